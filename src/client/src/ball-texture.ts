// The skin of a ball, drawn on a canvas: number discs, stripe, spots. Equirectangular; a number faces +z with its top to +y.
import type { Paint } from "./palette.ts";

const WIDTH = 512;
const HEIGHT = 256;
const WHITE = "#f4efe2";
/** Half height of a stripe, and radius of a number's disc, both as parts of the height. */
const BAND = 0.2;
const DISC = 0.155;

/** The skin of one ball. */
export function skin(paint: Paint): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const pen = canvas.getContext("2d");
  if (!pen) {
    return canvas;
  }
  pen.fillStyle = paint.striped ? WHITE : paint.colour;
  pen.fillRect(0, 0, WIDTH, HEIGHT);
  if (paint.striped) {
    pen.fillStyle = paint.colour;
    pen.fillRect(0, HEIGHT * (0.5 - BAND), WIDTH, 2 * BAND * HEIGHT);
  }
  if (paint.spotted) {
    spots(pen, "#c4202b");
  }
  if (paint.label) {
    for (const u of [0.25, 0.75]) {
      number(pen, u * WIDTH, HEIGHT / 2, paint.label);
    }
  }
  return canvas;
}

function number(pen: CanvasRenderingContext2D, x: number, y: number, label: string): void {
  pen.fillStyle = WHITE;
  pen.beginPath();
  pen.arc(x, y, DISC * HEIGHT, 0, 2 * Math.PI);
  pen.fill();
  const size = label.length > 2 ? 30 : label.length > 1 ? 46 : 56;
  pen.fillStyle = "#16181a";
  pen.font = `700 ${size}px "Helvetica Neue", Arial, "Liberation Sans", sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(label, x, y + 0.04 * size, 2 * DISC * HEIGHT * 0.82);
  if (/^[69]$/.test(label)) {
    pen.fillRect(x - 0.3 * size, y + 0.44 * size, 0.6 * size, 3);
  }
}

/** Six spots, on the axes: of those on the poles only the rows next to them are painted. */
function spots(pen: CanvasRenderingContext2D, colour: string): void {
  const r = 0.05 * HEIGHT;
  pen.fillStyle = colour;
  for (const u of [0, 0.25, 0.5, 0.75, 1]) {
    pen.beginPath();
    pen.arc(u * WIDTH, HEIGHT / 2, r, 0, 2 * Math.PI);
    pen.fill();
  }
  pen.fillRect(0, 0, WIDTH, r);
  pen.fillRect(0, HEIGHT - r, WIDTH, r);
}
