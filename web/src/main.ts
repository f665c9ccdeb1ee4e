import {
  Box3, LinearSRGBColorSpace, MOUSE, Matrix4, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { MapControls } from 'three/examples/jsm/controls/MapControls.js';
import { PotreeRenderer } from 'potree-core';
import { Clouds } from './clouds';
import { Cameras, Drive, Ruler } from './overlays';
import { PointBudget } from './point_budget';
import { SceneInfo, loadScene, matrixOf } from './scene';
import { Panel, fail } from './panel';

class Viewer {
  private readonly camera = new PerspectiveCamera(55, 1, 0.1, 20000);
  private readonly stage = new Scene();
  private readonly overlay = new Scene(); // drawn over the clouds, which hide what lies behind them in the stage
  private readonly shader = new PotreeRenderer({ edl: { enabled: true, strength: 0.5, radius: 1.3 } });
  private readonly controls: MapControls;
  private readonly cameras: Cameras;
  private readonly drive: Drive;
  private readonly ruler = new Ruler();
  private readonly panel: Panel;
  private readonly before: Matrix4 | null;
  private readonly after: Matrix4 | null;
  private measuring = false;
  private readonly budget = new PointBudget();
  private framesLeft = 0; // still to draw; nothing is drawn while nothing changes

  constructor(
    private readonly info: SceneInfo, private readonly clouds: Clouds,
    private readonly canvas: HTMLCanvasElement, private readonly renderer: WebGLRenderer,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = new MapControls(this.camera, canvas);
    this.controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.ROTATE };
    this.controls.zoomToCursor = true;
    this.controls.maxPolarAngle = 0.52 * Math.PI;
    this.controls.addEventListener('change', () => this.moved());
    this.cameras = new Cameras(info.cameras, clouds.center);
    this.drive = new Drive(info);
    this.before = info.registration?.before ? matrixOf(info.registration.before) : null;
    this.after = info.registration?.after ? matrixOf(info.registration.after) : null;
    this.drive.place(this.after ?? new Matrix4(), clouds.center);
    this.cameras.group.visible = this.drive.line.visible = false;
    this.stage.add(...clouds.layers.map((layer) => layer.octree), this.cameras.group, this.drive.line);
    this.overlay.add(this.ruler.group);
    this.panel = new Panel(info, clouds, {
      redraw: () => this.redraw(),
      blend: (t) => this.blend(t),
      frame: () => this.frame(),
      top: () => this.top(),
      showCameras: (on) => (this.cameras.group.visible = on),
      showDrive: (on) => (this.drive.line.visible = on),
      shadeDepth: (on) => this.shader.setEDL({ enabled: on }),
      measure: (on) => this.measure(on),
    });
    this.listen();
    this.resize();
  }

  private redraw(frames = 3): void {
    this.framesLeft = Math.max(this.framesLeft, this.budget.resting ? 1 : frames);
    this.canvas.setAttribute('aria-busy', 'true');
  }

  /** Draws what the machine draws quickly, and again in full once nothing moves. */
  private moved(): void {
    this.budget.moved();
    this.redraw();
  }

  private listen(): void {
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    let pressed = new Vector2();
    this.canvas.addEventListener('pointerdown', (event) => (pressed = new Vector2(event.clientX, event.clientY)));
    this.canvas.addEventListener('click', (event) => {
      const MOVED_PX = 4;
      if (pressed.distanceTo(new Vector2(event.clientX, event.clientY)) < MOVED_PX) this.click(event);
    });
    this.canvas.addEventListener('dblclick', (event) => {
      const hit = this.pick(event);
      if (hit && !this.measuring) this.controls.target.copy(hit), this.controls.update();
    });
    this.canvas.addEventListener('webglcontextlost', () => fail('The graphics driver stopped. Reload the page to go on.'));
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    this.moved();
  }

  private pointer(event: MouseEvent): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    return new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  }

  private pick(event: MouseEvent): Vector3 | null {
    const caster = new Raycaster();
    caster.setFromCamera(this.pointer(event), this.camera);
    return this.clouds.pick(this.renderer, this.camera, caster.ray);
  }

  private click(event: MouseEvent): void {
    if (!this.measuring && this.cameras.group.visible) {
      const size = new Vector2(this.canvas.clientWidth, this.canvas.clientHeight);
      const chosen = this.cameras.pick(this.pointer(event), this.camera, size);
      this.panel.say(chosen ? `Photo ${chosen.name}` : null);
      this.redraw();
      if (chosen) return;
    }
    const hit = this.pick(event);
    if (!hit) return;
    if (this.measuring) {
      this.ruler.add(hit, this.camera.position.distanceTo(hit) * 0.004);
      this.panel.say(this.ruler.text());
    } else {
      const at = hit.clone().add(this.clouds.center);
      this.panel.say(`East ${at.x.toFixed(2)} m, north ${at.y.toFixed(2)} m, up ${at.z.toFixed(2)} m`);
    }
    this.redraw();
  }

  private measure(on: boolean): void {
    this.measuring = on;
    this.canvas.classList.toggle('measuring', on);
    this.ruler.clear();
    this.panel.say(on ? this.ruler.text() : null);
    this.redraw();
  }

  /** LiDAR cloud between its coarse (0) and its registered pose (1), turned about its own middle. */
  private blend(t: number): void {
    const lidar = this.clouds.layer('lidar');
    if (!this.before || !this.after || !lidar) return;
    const geometry = lidar.octree.pcoGeometry;
    const middle = geometry.tightBoundingBox.getCenter(new Vector3()).add(geometry.offset);
    const turn = new Quaternion().setFromRotationMatrix(this.before).slerp(new Quaternion().setFromRotationMatrix(this.after), t);
    const place = middle.clone().applyMatrix4(this.before).lerp(middle.clone().applyMatrix4(this.after), t);
    const pose = new Matrix4().makeTranslation(place).multiply(new Matrix4().makeRotationFromQuaternion(turn))
      .multiply(new Matrix4().makeTranslation(middle.negate()));
    this.clouds.place(lidar, pose);
    this.drive.place(pose, this.clouds.center);
    this.moved();
  }

  /** Middle and extent of the shown clouds without their stray points. */
  private extent(): Box3 {
    const points = this.clouds.sample();
    const box = new Box3();
    if (points.length === 0) return box.set(new Vector3(-50, -50, -10), new Vector3(50, 50, 10));
    for (const axis of ['x', 'y', 'z'] as const) {
      const values = points.map((point) => point[axis]).sort((a, b) => a - b);
      box.min[axis] = values[Math.floor(0.02 * (values.length - 1))]!;
      box.max[axis] = values[Math.floor(0.98 * (values.length - 1))]!;
    }
    return box;
  }

  /** Around the drive, where both sensors saw the scene; else the whole. */
  private interest(): Box3 {
    const whole = this.extent();
    const lidar = this.clouds.layer('lidar');
    if (!this.after || !lidar || this.info.trajectory_in_lidar.length === 0) return whole;
    const AROUND_M = 18;
    const drive = new Box3();
    for (const p of this.info.trajectory_in_lidar) {
      drive.expandByPoint(new Vector3(...p).applyMatrix4(this.after).sub(this.clouds.center));
    }
    const near = drive.expandByVector(new Vector3(AROUND_M, AROUND_M, 4)).intersect(whole);
    return near.isEmpty() ? whole : near;
  }

  private look(direction: Vector3, box: Box3): void {
    const size = box.getSize(new Vector3());
    const reach = Math.max(1, 0.5 * Math.hypot(size.x, size.y)); // half the extent of what is shown [m]
    const distance = (1.05 * reach) / Math.tan((this.camera.fov * Math.PI) / 360) / Math.min(1.4, Math.max(this.camera.aspect, 0.6));
    this.controls.target.copy(box.getCenter(new Vector3()));
    this.camera.position.copy(this.controls.target).addScaledVector(direction.normalize(), distance);
    this.camera.near = reach * 0.002;
    this.camera.far = reach * 60;
    this.camera.updateProjectionMatrix();
    this.controls.maxDistance = reach * 20;
    this.controls.update();
    this.moved();
  }

  private frame(): void {
    this.look(new Vector3(-0.45, -0.8, 0.62), this.extent());
  }

  private top(): void {
    this.look(new Vector3(0, -0.001, 1), this.extent());
  }

  /** Waits for the coarsest level, which tells where to look and how high the scene is. */
  async start(): Promise<void> {
    const WAIT_MS = 15000;
    this.frame();
    const began = performance.now();
    while (this.clouds.sample().length === 0 && performance.now() - began < WAIT_MS) {
      this.clouds.update(this.camera, this.renderer, this.budget.points);
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
    const box = this.extent();
    this.clouds.setHeightRange(box.min.z, box.max.z);
    this.look(new Vector3(-0.45, -0.8, 0.62), this.interest());
    this.draw(performance.now());
  }

  private readonly draw = (now: number): void => {
    requestAnimationFrame(this.draw);
    if (this.framesLeft <= 0 && this.budget.settle(now)) this.framesLeft = 1;
    if (this.framesLeft <= 0) return this.budget.idle(now);
    this.budget.frame(now, this.clouds.visiblePoints());
    const loading = this.clouds.update(this.camera, this.renderer, this.budget.points);
    this.panel.status(this.clouds.visiblePoints(), loading || this.budget.unfinished);
    if (loading && this.budget.resting) return; // this picture takes long: it is drawn once, when all is there
    this.render();
    this.framesLeft = loading ? 3 : this.framesLeft - 1;
    if (this.framesLeft <= 0 && !this.budget.unfinished) this.canvas.setAttribute('aria-busy', 'false');
  };

  private render(): void {
    this.shader.render({ renderer: this.renderer, scene: this.stage, camera: this.camera, pointClouds: this.clouds.visible() });
    this.renderer.autoClear = false;
    this.renderer.render(this.overlay, this.camera);
    this.renderer.autoClear = true;
  }
}

async function main(): Promise<void> {
  const canvas = document.getElementById('view') as HTMLCanvasElement;
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) {
    return fail('This browser offers no WebGL 2, which drawing point clouds needs. Switch hardware acceleration on, update the '
      + 'graphics driver, or open the page in another browser. The clouds are also files of the workspace: '
      + 'fused/fused.ply opens in CloudCompare or MeshLab.');
  }
  context.getExtension('WEBGL_lose_context')?.loseContext();
  const scene = await loadScene();
  const renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setClearColor('#10151c');
  let viewer: Viewer | null = null;
  const clouds = new Clouds(() => viewer?.['redraw']());
  await clouds.load(scene);
  viewer = new Viewer(scene, clouds, canvas, renderer);
  await viewer.start();
}

main().catch((error: unknown) => fail(error instanceof Error ? error.message : String(error)));
