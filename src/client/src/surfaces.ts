// Textures of wood and cloth, drawn on canvases from a fixed sequence, and the light of the room.
import {
  BackSide,
  BoxGeometry,
  CanvasTexture,
  Mesh,
  MeshBasicMaterial,
  PMREMGenerator,
  RepeatWrapping,
  Scene,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
} from "three";

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
    pen.fillStyle = "#5a2b17";
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

/** What polished balls mirror: a dim room and the lamp above a table. */
export function room(renderer: WebGLRenderer): Texture {
  const scene = new Scene();
  const box = new BoxGeometry(1, 1, 1);
  const add = (shade: number, size: [number, number, number], place: [number, number, number], inside = false): void => {
    const material = new MeshBasicMaterial({ side: inside ? BackSide : 0 });
    material.color.setRGB(shade, shade * 0.97, shade * 0.9);
    const mesh = new Mesh(box, material);
    mesh.scale.set(...size);
    mesh.position.set(...place);
    scene.add(mesh);
  };
  add(0.16, [60, 60, 30], [0, 0, 6], true);
  for (const y of [-9, 0, 9]) {
    add(14, [7, 4.2, 0.3], [0, y, 15]);
  }
  add(1.1, [0.5, 40, 9], [-29, 0, 6]);
  add(0.7, [40, 0.5, 9], [0, 29, 6]);
  const generator = new PMREMGenerator(renderer);
  const made = generator.fromScene(scene, 0.02).texture;
  generator.dispose();
  box.dispose();
  return made;
}
