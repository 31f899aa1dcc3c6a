// Trails and rings on the cloth. Both are built once for a run; what is seen of them follows from the time alone.
import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
} from "three";
import { course, LIFE, marks } from "./course.ts";
import { ink, paint } from "./palette.ts";
import type { Run } from "./run.ts";
import type { Stage } from "./stage.ts";

const TRAIL_WIDTH = 0.2;

const TRAIL_VERTEX = `
attribute float when;
attribute float way;
attribute vec3 tint;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  whenSeen = when;
  waySeen = way;
  tintSeen = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const TRAIL_FRAGMENT = `
uniform float now;
uniform float fade;
uniform float dash;
uniform float strength;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  if (whenSeen > now || (dash > 0.0 && fract(waySeen / dash) > 0.6)) discard;
  float age = (now - whenSeen) / fade;
  gl_FragColor = vec4(tintSeen, strength * (0.3 + 0.7 * exp(-age)));
  #include <colorspace_fragment>
}`;

/** The trails of all balls of a run: in the balls' colours, or in the run's where it is a ghost. */
export class Trails {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;

  constructor(stage: Stage, run: Run, ghost: boolean) {
    const [points, whens, ways, tints, faces]: number[][] = [[], [], [], [], []];
    const z = stage.floor + (ghost ? 0.016 : 0.012);
    run.paths.forEach((path, ball) => {
      const colour = ghost ? new Color(ink(run.index).cloth) : new Color(paint(stage.data.balls[ball].id, ball).colour).lerp(new Color("#ffffff"), 0.25);
      const line = course(path, run.leaves[ball]);
      let way = 0;
      for (let i = 0; i + 5 < line.length; i += 3) {
        const [t0, x0, y0, t1, x1, y1] = line.subarray(i, i + 6);
        const length = Math.hypot(x1 - x0, y1 - y0);
        if (length < 1e-6) {
          continue;
        }
        const half = (TRAIL_WIDTH / 2) * (ghost ? 0.8 : 1);
        const [nx, ny] = [(-(y1 - y0) / length) * half, ((x1 - x0) / length) * half];
        const first = points.length / 3;
        points.push(x0 + nx, y0 + ny, z, x0 - nx, y0 - ny, z, x1 + nx, y1 + ny, z, x1 - nx, y1 - ny, z);
        whens.push(t0, t0, t1, t1);
        ways.push(way, way, way + length, way + length);
        tints.push(...[0, 1, 2, 3].flatMap(() => [colour.r, colour.g, colour.b]));
        faces.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
        way += length;
      }
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
    geometry.setAttribute("when", new Float32BufferAttribute(whens, 1));
    geometry.setAttribute("way", new Float32BufferAttribute(ways, 1));
    geometry.setAttribute("tint", new Float32BufferAttribute(tints, 3));
    geometry.setIndex(faces);
    const fade = Math.max(1e-9, stage.end / 5);
    this.material = new ShaderMaterial({
      vertexShader: TRAIL_VERTEX,
      fragmentShader: TRAIL_FRAGMENT,
      uniforms: { now: { value: 0 }, fade: { value: fade }, dash: { value: ghost ? 1.4 : 0 }, strength: { value: ghost ? 0.85 : 0.8 } },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  show(now: number): void {
    this.material.uniforms.now.value = now;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}

const RING_VERTEX = `
attribute float when;
uniform float now;
uniform float life;
uniform float grows;
varying vec2 at;
varying float age;
void main() {
  age = (now - when) / life;
  at = position.xy;
  float size = age < 0.0 || age > 1.0 ? 0.0 : 1.0 + grows * 0.9 * age;
  gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position.xy * size, position.z, 1.0);
}`;

const RING_FRAGMENT = `
varying vec2 at;
varying float age;
void main() {
  float d = length(at);
  float ring = smoothstep(0.7, 0.76, d) * smoothstep(1.0, 0.94, d);
  if (ring < 0.01) discard;
  gl_FragColor = vec4(1.0, 0.97, 0.85, ring * (1.0 - age) * 0.9);
}`;

/** The rings of all hits of a run. */
export class Rings {
  readonly mesh: InstancedMesh;
  private readonly material: ShaderMaterial;

  constructor(stage: Stage, run: Run, still: boolean) {
    const all = marks(stage, run);
    this.material = new ShaderMaterial({
      vertexShader: RING_VERTEX,
      fragmentShader: RING_FRAGMENT,
      uniforms: { now: { value: 0 }, life: { value: LIFE }, grows: { value: still ? 0 : 1 } },
      transparent: true,
      depthWrite: false,
    });
    const plane = new PlaneGeometry(2, 2);
    plane.setAttribute("when", new InstancedBufferAttribute(Float32Array.from(all, (mark) => mark.at), 1));
    this.mesh = new InstancedMesh(plane, this.material, Math.max(1, all.length));
    this.mesh.count = all.length;
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 3;
    all.forEach((mark, i) => this.mesh.setMatrixAt(i, new Matrix4().makeScale(mark.r, mark.r, 1).setPosition(mark.x, mark.y, stage.floor + 0.025)));
  }

  show(now: number, rate: number): void {
    this.material.uniforms.now.value = now;
    this.material.uniforms.life.value = LIFE * rate;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
