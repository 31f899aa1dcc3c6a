// The table in three dimensions.
import {
  DirectionalLight,
  HemisphereLight,
  type InstancedMesh,
  type Material,
  Mesh,
  NeutralToneMapping,
  PerspectiveCamera,
  Quaternion,
  Scene,
  type Texture,
  Vector3,
  WebGLRenderer,
} from "three";
import { GhostBalls, Halos, SolidBalls } from "./balls.ts";
import { Eye } from "./camera.ts";
import type { Frame } from "./frame.ts";
import { Rings, Trails } from "./marks.ts";
import type { Rect, Stage } from "./stage.ts";
import { ground, leather, table } from "./table.ts";
import { type Cell, cellAt, cells, type Choice, ghosts, tables, type View } from "./view.ts";

/** Most device pixels a CSS pixel. */
const SHARPEST = 2;
/** Frames slower than this, ms, again and again while it plays, and the picture is made with fewer pixels and without cast shadows;
 * what takes longer than the second number was a pause. */
const SLOW = 45;
const PAUSE = 2000;
const PATIENCE = 12;
const COARSE = 0.75;

export class World implements View {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(26, 1);
  private readonly eye: Eye;
  private readonly solid: SolidBalls;
  private readonly halos: Halos;
  private readonly ghostBalls: GhostBalls[] = [];
  private readonly trails = new Map<string, Trails>();
  private readonly rings = new Map<number, Rings>();
  private readonly base = new Quaternion();
  private readonly light = new DirectionalLight("#fff1dc", 2.7);
  private width = 1;
  private height = 1;
  private slow = 0;
  private last = 0;
  /** What was last drawn, so that a place of the picture can be asked for its ball. */
  private drawn: { frame: Frame; choice: Choice } | null = null;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly stage: Stage,
    private readonly still: () => boolean,
    lost: () => void,
  ) {
    this.canvas = document.createElement("canvas");
    const context = this.canvas.getContext("webgl2", { antialias: true, alpha: true, powerPreference: "high-performance" });
    if (!context) {
      throw new Error("this browser has no WebGL 2");
    }
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      lost();
    });
    const { renderer, scene } = this;
    renderer.setClearColor(0x000000, 0);
    renderer.toneMapping = NeutralToneMapping;
    renderer.toneMappingExposure = 0.95;
    renderer.shadowMap.enabled = true;
    renderer.autoClear = false;
    scene.add(new HemisphereLight("#fff6e8", "#3a8a6a", 1.75));
    this.lamp();
    scene.add(table(stage), leather(stage));
    if (!stage.table) {
      scene.add(ground(stage));
    }
    this.solid = new SolidBalls(stage);
    this.halos = new Halos(stage);
    scene.add(this.solid.group, this.halos.group);
    for (const run of stage.runs) {
      const ghost = new GhostBalls(stage, run.index);
      this.ghostBalls.push(ghost);
      scene.add(ghost.mesh);
    }
    this.eye = new Eye(stage.sight, stage.floor, still);
  }

  look(choice: Choice): void {
    this.eye.look(choice.camera === "free" ? "free" : "above");
  }

  close(rect: Rect | null): void {
    this.eye.close(rect);
  }

  orbit(right: number, down: number): void {
    this.eye.orbit(-3 * right, -2.4 * down);
  }

  zoom(factor: number): void {
    this.eye.zoom(factor);
  }

  pan(right: number, up: number): void {
    this.eye.pan(right, up, this.camera);
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    const ratio = window.devicePixelRatio || 1;
    this.renderer.setPixelRatio(this.slow >= PATIENCE ? COARSE * Math.min(1, ratio) : Math.min(SHARPEST, ratio));
    this.renderer.setSize(this.width, this.height, false);
  }

  draw(frame: Frame, choice: Choice, rate: number, playing: boolean): boolean {
    const { renderer, camera, eye } = this;
    const now = performance.now();
    this.watch(now, playing);
    this.drawn = { frame, choice };
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    let moving = false;
    const all = tables(choice);
    const parts = this.cells(all.length);
    all.forEach((run, i) => {
      const { x, y, width, height } = parts[i];
      camera.aspect = width / height;
      moving = eye.place(camera, now) || moving;
      this.arrange(frame, choice, run, rate);
      const bottom = this.height - y - height;
      renderer.setViewport(x, bottom, width, height);
      renderer.setScissor(x, bottom, width, height);
      renderer.render(this.scene, camera);
    });
    return moving;
  }

  pick(px: number, py: number): number {
    if (!this.drawn) {
      return -1;
    }
    const { frame, choice } = this.drawn;
    const all = tables(choice);
    const parts = this.cells(all.length);
    const cell = cellAt(parts, px, py);
    if (cell < 0) {
      return -1;
    }
    const { x, y, width, height } = parts[cell];
    this.camera.aspect = width / height;
    this.eye.place(this.camera, performance.now());
    const scatter = frame.scatters[all[cell]];
    const at = new Vector3();
    let best = { ball: -1, distance: 18 };
    for (let ball = 0; ball < scatter.present.length; ball += 1) {
      at.fromArray(scatter.positions, 3 * ball).project(this.camera);
      const distance = Math.hypot(x + ((at.x + 1) / 2) * width - px, y + ((1 - at.y) / 2) * height - py);
      if (scatter.present[ball] && distance < best.distance) {
        best = { ball, distance };
      }
    }
    return best.ball;
  }

  dispose(): void {
    this.scene.traverse((object) => {
      if (object instanceof Mesh) {
        const mesh = object as Mesh | InstancedMesh;
        mesh.geometry.dispose();
        for (const material of [mesh.material].flat()) {
          (material as Material & { map?: Texture | null }).map?.dispose();
          material.dispose();
        }
      }
    });
    this.renderer.dispose();
    this.canvas.remove();
  }

  /** Puts balls, ghosts, trails and rings where one table of the picture has them. */
  private arrange(frame: Frame, choice: Choice, run: number, rate: number): void {
    const scatter = frame.scatters[run];
    this.solid.show(scatter, this.base, frame.time, rate);
    this.halos.show(scatter, choice.called, choice.ball);
    const others = ghosts(choice, run);
    this.ghostBalls.forEach((ghost, index) => {
      ghost.mesh.visible = others.includes(index);
      if (ghost.mesh.visible) {
        ghost.show(frame.scatters[index], scatter);
      }
    });
    for (const trails of this.trails.values()) {
      trails.mesh.visible = false;
    }
    if (choice.trails) {
      for (const index of [run, ...others]) {
        const trails = this.trailsOf(index, index !== run);
        trails.mesh.visible = true;
        trails.show(frame.time);
      }
    }
    for (const rings of this.rings.values()) {
      rings.mesh.visible = false;
    }
    if (choice.marks) {
      const rings = this.ringsOf(run);
      rings.mesh.visible = true;
      rings.show(frame.time, rate);
    }
  }

  private trailsOf(run: number, ghost: boolean): Trails {
    const key = `${run} ${ghost}`;
    let trails = this.trails.get(key);
    if (!trails) {
      trails = new Trails(this.stage, this.stage.runs[run], ghost);
      this.trails.set(key, trails);
      this.scene.add(trails.mesh);
    }
    return trails;
  }

  private ringsOf(run: number): Rings {
    let rings = this.rings.get(run);
    if (!rings) {
      rings = new Rings(this.stage, this.stage.runs[run], this.still());
      this.rings.set(run, rings);
      this.scene.add(rings.mesh);
    }
    return rings;
  }

  private cells(count: number): Cell[] {
    const { cells: parts, lying } = cells(this.stage.sight, count, this.width, this.height);
    this.lie(lying);
    return parts;
  }

  /** How a ball lies that has not turned: its number up, leaning to the reader. */
  private lie(lying: boolean): void {
    this.eye.lying = lying;
    const lean = 0.3;
    if (lying) {
      this.base.setFromAxisAngle(new Vector3(0, 1, 0), lean).multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), Math.PI / 2));
    } else {
      this.base.setFromAxisAngle(new Vector3(1, 0, 0), lean);
    }
  }

  private lamp(): void {
    const { light, scene, stage } = this;
    const { cloth } = stage;
    const [cx, cy] = [(cloth.x0 + cloth.x1) / 2, (cloth.y0 + cloth.y1) / 2];
    const reach = Math.hypot(cloth.x1 - cloth.x0, cloth.y1 - cloth.y0) / 2 + 6;
    light.position.set(cx - 0.25 * reach, cy - 0.3 * reach, stage.floor + 1.6 * reach);
    light.target.position.set(cx, cy, stage.floor);
    light.castShadow = true;
    light.shadow.mapSize.set(2048, 2048);
    light.shadow.radius = 3;
    light.shadow.bias = -0.0004;
    light.shadow.normalBias = 0.04;
    const box = light.shadow.camera;
    [box.left, box.right, box.bottom, box.top] = [-reach, reach, -reach, reach];
    box.near = 0.2 * reach;
    box.far = 3.2 * reach;
    scene.add(light, light.target);
  }

  /** Saves pixels and shadows where frames come slowly one after another while it plays. */
  private watch(now: number, playing: boolean): void {
    const passed = now - this.last;
    this.last = now;
    if (!playing || passed > PAUSE || this.slow >= PATIENCE) {
      return;
    }
    this.slow = passed > SLOW ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow >= PATIENCE) {
      this.light.castShadow = false;
      this.resize(this.width, this.height);
    }
  }
}
