// The table: cloth on slate, cushions, wooden rails with their sights, pockets.
import {
  BufferGeometry,
  CircleGeometry,
  CylinderGeometry,
  DoubleSide,
  ExtrudeGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Path as Hole,
  PlaneGeometry,
  RingGeometry,
  Shape,
  ShapeGeometry,
  Vector2,
} from "three";
import { outline, type Straight } from "./outline.ts";
import { polish } from "./polish.ts";
import { CLOTH, CUSHION, grow, type Rect, sights, type Stage, WOOD } from "./stage.ts";
import { weave, wood } from "./surfaces.ts";

const CUSHION_CLOTH = "#0f6048";
/** Heights above the cloth, R: where a cushion meets balls, top of the wood. */
const NOSE = 1.28;
const TOP = 1.62;
/** How far a cushion ends before a pocket, and how far its back reaches on toward it, R. */
const JAW = 0.3;
const FLARE = 0.45;

/** Everything of the table that stands still. */
export function table(stage: Stage): Group {
  const group = new Group();
  group.position.z = stage.floor;
  group.add(cloth(stage));
  if (stage.table) {
    group.add(cushions(stage.table, stage), frame(stage.table, stage), pearls(stage.table, stage));
  }
  for (const pocket of stage.pockets) {
    group.add(...hole(pocket.x, pocket.y, pocket.r));
  }
  return group;
}

function cloth(stage: Stage): Mesh {
  const rect = stage.table ? grow(stage.cloth, CUSHION + 0.5 * WOOD) : stage.cloth;
  const shape = new Shape([new Vector2(rect.x0, rect.y0), new Vector2(rect.x1, rect.y0), new Vector2(rect.x1, rect.y1), new Vector2(rect.x0, rect.y1)]);
  const inside = (x: number, y: number, r: number): boolean => x - r > rect.x0 && x + r < rect.x1 && y - r > rect.y0 && y + r < rect.y1;
  for (const { x, y, r } of stage.pockets.filter((pocket) => inside(pocket.x, pocket.y, pocket.r))) {
    shape.holes.push(new Hole().absarc(x, y, r, 0, 2 * Math.PI, true));
  }
  const map = weave();
  map.repeat.set(1 / 9, 1 / 9);
  const material = new MeshLambertMaterial({ color: CLOTH, map });
  lit(material, stage.cloth);
  const mesh = new Mesh(new ShapeGeometry(shape, 40), material);
  mesh.receiveShadow = true;
  return mesh;
}

/** Lets the light of the lamps fall off toward the edge of the cloth. */
function lit(material: MeshLambertMaterial, rect: Rect): void {
  const vec = (x: number, y: number): string => `vec2(${x.toFixed(5)}, ${y.toFixed(5)})`;
  const middle = vec((rect.x0 + rect.x1) / 2, (rect.y0 + rect.y1) / 2);
  const half = vec((rect.x1 - rect.x0) / 2, (rect.y1 - rect.y0) / 2);
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec2 litAt;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nlitAt = position.xy;");
    shader.fragmentShader = shader.fragmentShader.replace("#include <common>", "#include <common>\nvarying vec2 litAt;").replace(
      "#include <map_fragment>",
      `#include <map_fragment>
       vec2 off = abs(litAt - ${middle}) / ${half};
       diffuseColor.rgb *= mix(1.12, 0.66, smoothstep(0.25, 1.5, length(off)));`,
    );
  };
}

/** The cushions: a prism along each straight part of the edge. */
function cushions(edge: Rect, stage: Stage): Mesh {
  const wider = stage.pockets.map((pocket) => ({ ...pocket, r: pocket.r + JAW }));
  const corners: number[] = [];
  for (const straight of outline(edge, wider).straights) {
    prism(straight, corners);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: CUSHION_CLOTH, side: DoubleSide }));
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

/** Triangles of one cushion: front, top and both ends. */
function prism(straight: Straight, corners: number[]): void {
  const { x0, y0, x1, y1 } = straight;
  const length = Math.hypot(x1 - x0, y1 - y0);
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  // outward is to the right of the way around
  const [nx, ny] = [uy, -ux];
  const flare = (pocket: boolean): number => (pocket ? FLARE : 1) * CUSHION;
  const at = (along: number, out: number, z: number): [number, number, number] => [x0 + along * ux + out * nx, y0 + along * uy + out * ny, z];
  const profile: [number, number][] = [
    [0.22, 0],
    [0, NOSE - 0.2],
    [0.1, NOSE],
    [CUSHION, TOP - 0.02],
    [CUSHION, 0],
  ];
  const start = (out: number): number => (-out / CUSHION) * flare(straight.pocketBefore);
  const end = (out: number): number => length + (out / CUSHION) * flare(straight.pocketAfter);
  const quad = (a: number[], b: number[], c: number[], d: number[]): void => void corners.push(...a, ...b, ...c, ...a, ...c, ...d);
  for (let i = 0; i < 3; i += 1) {
    const [[d0, z0], [d1, z1]] = [profile[i], profile[i + 1]];
    quad(at(start(d0), d0, z0), at(start(d1), d1, z1), at(end(d1), d1, z1), at(end(d0), d0, z0));
  }
  for (const side of [start, end]) {
    const [a, b, c, d, e] = profile.map(([out, z]) => at(side(out), out, z));
    quad(a, b, c, d);
    corners.push(...a, ...d, ...e);
  }
}

/** The wood around: an outer edge with round corners, an inner one with room for the pockets. */
function frame(edge: Rect, stage: Stage): Mesh {
  const outer = grow(edge, CUSHION + WOOD);
  const r = 2.4;
  const shape = new Shape();
  shape.moveTo(outer.x0 + r, outer.y0);
  for (const [x, y, angle] of [
    [outer.x1 - r, outer.y0 + r, -0.5],
    [outer.x1 - r, outer.y1 - r, 0],
    [outer.x0 + r, outer.y1 - r, 0.5],
    [outer.x0 + r, outer.y0 + r, 1],
  ]) {
    shape.absarc(x, y, r, angle * Math.PI, (angle + 0.5) * Math.PI, false);
  }
  const inner = outline(grow(edge, CUSHION), liners(stage)).points;
  shape.holes.push(new Hole(inner.map(([x, y]) => new Vector2(x, y)).reverse()));
  const bevel = 0.22;
  const geometry = new ExtrudeGeometry(shape, { depth: TOP + 3 - 2 * bevel, bevelSize: bevel, bevelThickness: bevel, bevelOffset: -bevel, bevelSegments: 3, curveSegments: 12 });
  geometry.translate(0, 0, -3 + bevel);
  const material = new MeshLambertMaterial({ map: wood() });
  grain(material, edge);
  polish(material, stage, 0.55, 0.12);
  const mesh = new Mesh(geometry, material);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

/** Lets the grain run along each rail and meet at the corners at 45 degrees. */
function grain(material: MeshLambertMaterial, edge: Rect): void {
  const middle = [(edge.x0 + edge.x1) / 2, (edge.y0 + edge.y1) / 2];
  const half = [(edge.x1 - edge.x0) / 2, (edge.y1 - edge.y0) / 2];
  const vec = (v: number[]): string => `vec2(${v.map((x) => x.toFixed(6)).join(",")})`;
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 grainAt;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\ngrainAt = position;");
    shader.fragmentShader = shader.fragmentShader.replace("#include <common>", "#include <common>\nvarying vec3 grainAt;").replace(
      "#include <map_fragment>",
      `vec2 far = abs(grainAt.xy - ${vec(middle)}) - ${vec(half)};
       vec2 grainUv = far.x > far.y ? vec2(grainAt.y / 34.0, (grainAt.x + grainAt.z) / 7.0) : vec2(grainAt.x / 34.0 + 0.37, (grainAt.y + grainAt.z) / 7.0);
       diffuseColor *= texture2D(map, grainUv);`,
    );
  };
}

/** The pockets as the wood leaves room for them. */
function liners(stage: Stage): { x: number; y: number; r: number }[] {
  return stage.pockets.map((pocket) => ({ ...pocket, r: pocket.r + 0.1 }));
}

/** Sights of mother-of-pearl in the wood. */
function pearls(edge: Rect, stage: Stage): InstancedMesh {
  const places = sights(edge, stage);
  const mesh = new InstancedMesh(new CircleGeometry(0.26, 4), new MeshLambertMaterial({ color: "#efe6d2" }), Math.max(1, places.length));
  mesh.count = places.length;
  places.forEach(([x, y], i) => mesh.setMatrixAt(i, new Matrix4().makeTranslation(x, y, TOP + 0.012)));
  return mesh;
}

/** A pocket: a dark shaft, its ground, and a leather rim where it cuts into the wood. */
function hole(x: number, y: number, r: number): Mesh[] {
  const shaft = new Mesh(new CylinderGeometry(r, r * 0.92, 2.6, 40, 1, true).rotateX(Math.PI / 2), new MeshLambertMaterial({ color: "#15110e", side: DoubleSide }));
  shaft.position.set(x, y, -1.3);
  const ground = new Mesh(new CircleGeometry(r, 40), new MeshBasicMaterial({ color: "#050505" }));
  ground.position.set(x, y, -2.5);
  const rim = new Mesh(new RingGeometry(r * 0.985, r * 1.06, 48), new MeshLambertMaterial({ color: "#0b0a09" }));
  rim.position.set(x, y, 0.012);
  return [shaft, ground, rim];
}

/** Leather around the pockets where the wood gives way to them. */
export function leather(stage: Stage): Group {
  const group = new Group();
  group.position.z = stage.floor;
  if (!stage.table) {
    return group;
  }
  const material = new MeshLambertMaterial({ color: "#17130f", side: DoubleSide });
  for (const arc of outline(grow(stage.table, CUSHION), liners(stage)).arcs) {
    const { x, y, r } = arc.pocket;
    // just within the wood, which has the same edge
    const wall = new Mesh(new CylinderGeometry(0.985 * r, 0.985 * r, TOP + 1, 40, 1, true, 0, arc.sweep).rotateX(Math.PI / 2), material);
    // a cylinder of three starts at its z axis; turned upright, that is -y
    wall.position.set(x, y, (TOP - 1) / 2 + 0.02);
    wall.rotation.z = arc.from + Math.PI / 2;
    const top = new Mesh(new RingGeometry(r - 0.02, r + 0.42, 40, 1, arc.from, arc.sweep), material);
    top.position.set(x, y, TOP + 0.02);
    group.add(wall, top);
  }
  return group;
}

/** A dark ground far below, so that an unbounded plane does not float. */
export function ground(stage: Stage): Mesh {
  const rect = grow(stage.cloth, 0.4);
  const mesh = new Mesh(new PlaneGeometry(rect.x1 - rect.x0, rect.y1 - rect.y0), new MeshBasicMaterial({ color: "#0a3a2c" }));
  mesh.position.set((rect.x0 + rect.x1) / 2, (rect.y0 + rect.y1) / 2, stage.floor - 0.05);
  return mesh;
}
