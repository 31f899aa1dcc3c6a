// Textures of wood, cloth and shade, drawn on canvases from a fixed sequence.
import { CanvasTexture, RepeatWrapping, SRGBColorSpace, type Texture } from "three";

/** Numbers in [0, 1) that are the same in every browser. */
function sequence(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

function canvas(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D | null] {
  const element = document.createElement("canvas");
  element.width = width;
  element.height = height;
  return [element, element.getContext("2d")];
}

function texture(element: HTMLCanvasElement): Texture {
  const made = new CanvasTexture(element);
  made.wrapS = RepeatWrapping;
  made.wrapT = RepeatWrapping;
  made.colorSpace = SRGBColorSpace;
  made.anisotropy = 8;
  return made;
}

/** Mahogany with its grain along u; repeats. */
export function wood(): Texture {
  const [width, height] = [1024, 128];
  const [element, pen] = canvas(width, height);
  if (pen) {
    const next = sequence(7);
    pen.fillStyle = "#6b3a20";
    pen.fillRect(0, 0, width, height);
    for (let i = 0; i < 420; i += 1) {
      const y = next() * height;
      const dark = next() < 0.6;
      pen.strokeStyle = dark ? `rgba(28,10,4,${0.05 + 0.16 * next()})` : `rgba(190,110,60,${0.03 + 0.1 * next()})`;
      pen.lineWidth = 0.5 + 1.6 * next();
      const [bend, turns, phase] = [1 + 3 * next(), 1 + Math.floor(2 * next()), 6.3 * next()];
      pen.beginPath();
      // whole turns over the width, so that the edges meet
      for (let x = 0; x <= width; x += 16) {
        pen.lineTo(x, y + bend * Math.sin(phase + (turns * 2 * Math.PI * x) / width));
      }
      pen.stroke();
    }
  }
  return texture(element);
}

/** The weave of the cloth, near white, to be multiplied with its colour; repeats. */
export function weave(): Texture {
  const size = 256;
  const [element, pen] = canvas(size, size);
  if (pen) {
    const next = sequence(11);
    pen.fillStyle = "#e9e9e9";
    pen.fillRect(0, 0, size, size);
    for (let i = 0; i < 9000; i += 1) {
      const shade = next() < 0.5 ? 0 : 255;
      pen.fillStyle = `rgba(${shade},${shade},${shade},${0.05 * next() + 0.01})`;
      pen.fillRect(next() * size, next() * size, 1 + 2 * next(), 1);
    }
  }
  return texture(element);
}

/** A soft round spot, black, for the shade under a ball. */
export function shade(): Texture {
  const size = 64;
  const [element, pen] = canvas(size, size);
  if (pen) {
    const spot = pen.createRadialGradient(size / 2, size / 2, 0, size / 2, size / 2, size / 2);
    spot.addColorStop(0, "rgba(0,0,0,0.75)");
    spot.addColorStop(0.45, "rgba(0,0,0,0.5)");
    spot.addColorStop(1, "rgba(0,0,0,0)");
    pen.fillStyle = spot;
    pen.fillRect(0, 0, size, size);
  }
  return new CanvasTexture(element);
}
