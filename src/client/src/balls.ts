// The balls of a run in three dimensions: numbered and solid, or a ghost that is all rim.
import {
  CanvasTexture,
  Color,
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type MeshLambertMaterialParameters,
  PlaneGeometry,
  Quaternion,
  RingGeometry,
  ShaderMaterial,
  SphereGeometry,
  SRGBColorSpace,
  Vector3,
} from "three";
import { skin } from "./ball-texture.ts";
import type { Scatter } from "./frame.ts";
import { ink, paint } from "./palette.ts";
import { polish } from "./polish.ts";
import type { Stage } from "./stage.ts";
import { shade } from "./surfaces.ts";
import { apartness } from "./view.ts";

/** Up to this many balls each has a skin of its own; beyond, they are instances of one and have colours only. */
const MANY = 64;
/** How long a ball takes to sink in a pocket, s at 1x. */
const SINK = 0.12;

const [place, size, facing, matrix] = [new Vector3(), new Vector3(), new Quaternion(), new Matrix4()];
const GONE = new Matrix4().makeScale(0, 0, 0);

/** The solid balls, with the shade under each. */
export class SolidBalls {
  readonly group = new Group();
  private readonly meshes: Mesh[] = [];
  private readonly instances: InstancedMesh | null = null;
  private readonly shades: InstancedMesh;

  constructor(private readonly stage: Stage) {
    const { balls } = stage.data;
    const many = balls.length > MANY;
    const sphere = many ? new SphereGeometry(1, 20, 14) : new SphereGeometry(1, 48, 32);
    if (many) {
      this.instances = new InstancedMesh(sphere, varnished(stage, {}), balls.length);
      balls.forEach((ball, i) => this.instances?.setColorAt(i, new Color(paint(ball.id, i).colour)));
      this.instances.castShadow = true;
      this.instances.frustumCulled = false;
      this.group.add(this.instances);
    } else {
      balls.forEach((ball, i) => {
        const map = new CanvasTexture(skin(paint(ball.id, i)));
        map.colorSpace = SRGBColorSpace;
        map.anisotropy = 8;
        const mesh = new Mesh(sphere, varnished(stage, { map }));
        mesh.castShadow = true;
        mesh.receiveShadow = true;
        this.meshes.push(mesh);
        this.group.add(mesh);
      });
    }
    const dark = new MeshBasicMaterial({ map: shade(), transparent: true, depthWrite: false, opacity: 0.8 });
    this.shades = new InstancedMesh(new PlaneGeometry(2.5, 2.5), dark, balls.length);
    this.shades.frustumCulled = false;
    this.shades.renderOrder = 1;
    this.group.add(this.shades);
  }

  /** Puts the balls where a run has them; `base`: how a ball lies that has not turned. */
  show(scatter: Scatter, base: Quaternion, time: number, rate: number): void {
    const { stage, meshes, instances, shades } = this;
    const { positions, orientations, present, run } = scatter;
    stage.radii.forEach((r, i) => {
      place.fromArray(positions, 3 * i);
      const sunk = present[i] ? 0 : (time - run.leaves[i]) / (SINK * rate);
      const there = sunk >= 0 && sunk < 1;
      place.z -= 2.2 * r * Math.max(0, sunk) ** 2;
      facing.fromArray(orientations, 4 * i).multiply(base);
      matrix.compose(place, facing, size.setScalar(there ? r : 0));
      if (instances) {
        instances.setMatrixAt(i, matrix);
      } else {
        meshes[i].visible = there;
        meshes[i].position.copy(place);
        meshes[i].quaternion.copy(facing);
        meshes[i].scale.setScalar(r);
      }
      if (present[i]) {
        matrix.makeScale(r, r, r).setPosition(place.x, place.y, stage.floor + 0.02);
      }
      shades.setMatrixAt(i, present[i] ? matrix : GONE);
    });
    shades.instanceMatrix.needsUpdate = true;
    if (instances) {
      instances.instanceMatrix.needsUpdate = true;
    }
  }
}

function varnished(stage: Stage, parameters: MeshLambertMaterialParameters): MeshLambertMaterial {
  const material = new MeshLambertMaterial(parameters);
  polish(material, stage, 1, 0.012);
  return material;
}

const GHOST_VERTEX = `
attribute float seen;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec4 at = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  normalSeen = normalize(mat3(modelViewMatrix) * mat3(instanceMatrix) * normal);
  toEye = normalize(-at.xyz);
  amount = seen;
  gl_Position = projectionMatrix * at;
}`;

/** A clear body with a full rim, broken into beats, so that runs are told apart without colour. */
const GHOST_FRAGMENT = `
uniform vec3 colour;
uniform float beats;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec3 n = normalize(normalSeen);
  float facing = clamp(dot(n, normalize(toEye)), 0.0, 1.0);
  float rim = smoothstep(0.62, 0.42, facing);
  float beat = beats < 0.5 ? 1.0 : smoothstep(0.22, 0.3, abs(fract(atan(n.y, n.x) / 6.2831853 * beats) - 0.5));
  float alpha = amount * max(0.3, rim * mix(0.35, 1.0, beat));
  gl_FragColor = vec4(mix(colour, vec3(1.0), 0.15 * facing), alpha);
  #include <colorspace_fragment>
}`;

/** The balls of another run, seen only where they are elsewhere. */
export class GhostBalls {
  readonly mesh: InstancedMesh;
  private readonly seen: InstancedBufferAttribute;

  constructor(
    private readonly stage: Stage,
    run: number,
  ) {
    const n = stage.data.balls.length;
    const { cloth, beats } = ink(run);
    const material = new ShaderMaterial({
      vertexShader: GHOST_VERTEX,
      fragmentShader: GHOST_FRAGMENT,
      uniforms: { colour: { value: new Color(cloth) }, beats: { value: beats } },
      transparent: true,
      depthWrite: false,
    });
    const sphere = new SphereGeometry(1, n > MANY ? 18 : 36, n > MANY ? 12 : 24);
    this.seen = new InstancedBufferAttribute(new Float32Array(n), 1);
    this.seen.setUsage(DynamicDrawUsage);
    sphere.setAttribute("seen", this.seen);
    this.mesh = new InstancedMesh(sphere, material, n);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 4;
  }

  show(scatter: Scatter, solid: Scatter): void {
    const { mesh, seen, stage } = this;
    stage.radii.forEach((r, i) => {
      const [here, there] = [scatter.present[i] === 1, solid.present[i] === 1];
      const amount = !here ? 0 : there ? apartness(scatter.positions, solid.positions, i) : 1;
      seen.array[i] = amount;
      place.fromArray(scatter.positions, 3 * i);
      mesh.setMatrixAt(i, amount > 0 ? matrix.makeScale(1.02 * r, 1.02 * r, 1.02 * r).setPosition(place) : GONE);
    });
    seen.needsUpdate = true;
    mesh.instanceMatrix.needsUpdate = true;
  }
}

/** Rings that stand around the balls that matter now: those of a parting, and the one that the plots follow. */
export class Halos {
  readonly group = new Group();
  private readonly called: Mesh[];
  private readonly chosen: Mesh;

  constructor(private readonly stage: Stage) {
    // on top of everything: a ball in a pack must be seen to be meant
    const strong = new MeshBasicMaterial({ color: "#ffe98a", transparent: true, opacity: 0.95, depthTest: false, depthWrite: false });
    const bands = new RingGeometry(1.02, 1.2, 64);
    this.called = Array.from({ length: 8 }, () => new Mesh(bands, strong));
    this.chosen = new Mesh(new RingGeometry(1.12, 1.2, 64), new MeshBasicMaterial({ color: "#ffffff", transparent: true, opacity: 0.7, depthWrite: false }));
    this.called.forEach((mesh) => (mesh.renderOrder = 5));
    this.group.add(...this.called, this.chosen);
  }

  show(scatter: Scatter, called: number[], chosen: number): void {
    this.called.forEach((mesh, slot) => this.put(mesh, scatter, called[slot] ?? -1));
    this.put(this.chosen, scatter, chosen);
  }

  private put(mesh: Mesh, scatter: Scatter, ball: number): void {
    mesh.visible = ball >= 0 && scatter.present[ball] === 1;
    if (mesh.visible) {
      const r = this.stage.radii[ball];
      mesh.scale.setScalar(r);
      mesh.position.set(scatter.positions[3 * ball], scatter.positions[3 * ball + 1], this.stage.floor + 0.03);
    }
  }
}
