// Cameras, trajectory and measured distances, drawn over the clouds.
import {
  BufferGeometry, Camera, Color, Group, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry,
  Vector2, Vector3,
} from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { CameraInfo, SceneInfo, matrixOf } from './scene';

const CAMERA_COLOR = '#3fb950';
const CHOSEN_COLOR = '#f0883e';
const DRIVE_WIDTH_PX = 3;
const DRIVE_COLOR = '#ff5c5c';

export class Cameras {
  readonly group = new Group();
  private readonly centers: Vector3[] = [];
  private readonly frusta: LineSegments;
  private readonly chosen = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: CHOSEN_COLOR }));

  constructor(private readonly cameras: CameraInfo[], origin: Vector3) {
    const toOrigin = new Matrix4().makeTranslation(origin.clone().negate());
    const poses = cameras.map((camera) => matrixOf(camera.world_from_camera).premultiply(toOrigin));
    for (const pose of poses) this.centers.push(new Vector3().setFromMatrixPosition(pose));
    this.size = this.spread() * 0.35;
    const points = cameras.flatMap((camera, i) => this.frustum(camera, poses[i]!));
    this.frusta = new LineSegments(
      new BufferGeometry().setFromPoints(points),
      new LineBasicMaterial({ color: CAMERA_COLOR, transparent: true, opacity: 0.8 }),
    );
    this.poses = poses;
    this.group.add(this.frusta, this.chosen);
  }
  private readonly poses: Matrix4[];
  private readonly size: number;

  /** Typical distance between neighbouring cameras [m]. */
  private spread(): number {
    const nearest = this.centers.map((center, i) =>
      Math.min(...this.centers.filter((_, j) => j !== i).map((other) => other.distanceTo(center))));
    nearest.sort((a, b) => a - b);
    const middle = nearest[Math.floor(nearest.length / 2)];
    return middle !== undefined && Number.isFinite(middle) ? Math.min(Math.max(middle, 0.5), 50) : 5;
  }

  private frustum(camera: CameraInfo, pose: Matrix4): Vector3[] {
    const w = (camera.half_width ?? 0.6) * this.size;
    const h = (camera.half_height ?? 0.4) * this.size;
    const at = (x: number, y: number) => new Vector3(x, y, this.size).applyMatrix4(pose);
    const center = new Vector3().setFromMatrixPosition(pose);
    const corners = [at(-w, -h), at(w, -h), at(w, h), at(-w, h)];
    const up = at(0, -1.35 * h); // a roof over the upper edge of the image
    const lines: Vector3[] = [];
    corners.forEach((corner, i) => lines.push(center, corner, corner, corners[(i + 1) % 4]!));
    lines.push(corners[0]!, up, up, corners[1]!);
    return lines;
  }

  /** The camera nearest to a place on the screen, or null when none is within reach. */
  pick(pointer: Vector2, camera: Camera, size: Vector2): CameraInfo | null {
    const REACH_PX = 14;
    let best: number | null = null;
    let bestDistance = REACH_PX;
    this.centers.forEach((center, i) => {
      const at = center.clone().project(camera);
      if (at.z > 1) return;
      const distance = new Vector2((at.x - pointer.x) * size.x, (at.y - pointer.y) * size.y).length() / 2;
      if (distance < bestDistance) [best, bestDistance] = [i, distance];
    });
    this.choose(best);
    return best === null ? null : this.cameras[best]!;
  }

  private choose(index: number | null): void {
    const points = index === null ? [] : this.frustum(this.cameras[index]!, this.poses[index]!);
    this.chosen.geometry.dispose();
    this.chosen.geometry = new BufferGeometry().setFromPoints(points);
  }
}

export class Drive {
  readonly line: Line2;

  constructor(scene: SceneInfo) {
    const points = scene.trajectory_in_lidar.map((p) => new Vector3(...p));
    const geometry = new LineGeometry();
    if (points.length > 1) geometry.setFromPoints(points);
    this.line = new Line2(geometry, new LineMaterial({ color: DRIVE_COLOR, linewidth: DRIVE_WIDTH_PX }));
    this.line.frustumCulled = false;
    this.line.matrixAutoUpdate = false;
  }

  place(worldFromLidar: Matrix4, origin: Vector3): void {
    this.line.matrix.makeTranslation(origin.clone().negate()).multiply(worldFromLidar);
    this.line.matrixWorldNeedsUpdate = true;
  }
}

export class Ruler {
  readonly group = new Group();
  private readonly ends: Vector3[] = [];
  private readonly line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: '#ffffff', depthTest: false }));

  constructor() {
    this.line.renderOrder = 10;
    this.line.frustumCulled = false;
    this.group.add(this.line);
  }

  /** A third point starts anew. */
  add(point: Vector3, markerSize: number): void {
    if (this.ends.length === 2) this.clear();
    this.ends.push(point);
    const marker = new Mesh(
      new SphereGeometry(markerSize, 16, 12),
      new MeshBasicMaterial({ color: new Color('#ffffff'), depthTest: false }),
    );
    marker.position.copy(point);
    marker.renderOrder = 11;
    this.group.add(marker);
    this.line.geometry.dispose();
    this.line.geometry = new BufferGeometry().setFromPoints(this.ends);
  }

  clear(): void {
    this.ends.length = 0;
    for (const child of [...this.group.children]) {
      if (child instanceof Mesh) {
        (child.geometry as BufferGeometry).dispose();
        this.group.remove(child);
      }
    }
    this.line.geometry.dispose();
    this.line.geometry = new BufferGeometry();
  }

  text(): string {
    const [a, b] = this.ends;
    if (!a) return 'Click a first point.';
    if (!b) return 'Click a second point.';
    const d = b.clone().sub(a);
    const m = (value: number) => `${value.toFixed(2)} m`;
    return `${m(d.length())} (horizontal ${m(Math.hypot(d.x, d.y))}, height ${m(d.z)})`;
  }
}
