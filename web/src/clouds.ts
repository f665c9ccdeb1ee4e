// The point clouds: loading, poses, colours.
import {
  Box3, BufferAttribute, BufferGeometry, Camera, Color, ColorManagement, Matrix4, Quaternion, Ray, Vector3, Vector4, WebGLRenderer,
} from 'three';
import { INFERNO, PointCloudOctree, PointColorType, PointShape, PointSizeType, Potree } from 'potree-core';
import { LAYER_TITLES, LayerInfo, LayerName, SceneInfo, matrixOf } from './scene';

// Colours are shown as they are written: photos and gradients hold screen colours already.
ColorManagement.enabled = false;

export type ColorMode = 'rgb' | 'height' | 'intensity' | 'source' | 'distance';
export const COLOR_MODES: ColorMode[] = ['rgb', 'height', 'intensity', 'source', 'distance'];
export const SOURCE_COLORS: Record<'vision' | 'lidar' | 'interpolated', string> = { vision: '#58a6ff', lidar: '#ff9f43', interpolated: '#b8c0cc' };
export const DISTANCE_RANGE_M = 1.0;

type Stops = [number, Color][];
// Near is calm, far is loud; what the other sensor never saw stays grey.
const DISTANCE_GRADIENT: Stops = [
  [0.0, new Color('#2c7bb6')], [0.1, new Color('#00a6ca')], [0.25, new Color('#7dd181')], [0.45, new Color('#f9d057')],
  [0.65, new Color('#e76818')], [0.9, new Color('#d7191c')], [0.94, new Color('#6b7280')], [1.0, new Color('#6b7280')],
];
const HEIGHT_GRADIENT: Stops = [
  [0.0, new Color('#30466e')], [0.2, new Color('#2a788e')], [0.4, new Color('#22a884')], [0.6, new Color('#7ad151')],
  [0.8, new Color('#fde725')], [1.0, new Color('#fff7d6')],
];

export function cssGradient(mode: ColorMode): string {
  const stops = mode === 'distance' ? DISTANCE_GRADIENT : mode === 'height' ? HEIGHT_GRADIENT : INFERNO;
  return `linear-gradient(90deg, ${stops.map(([at, c]) => `#${c.getHexString()} ${(at * 100).toFixed(0)}%`).join(', ')})`;
}

export interface Layer {
  info: LayerInfo;
  title: string;
  octree: PointCloudOctree;
  pose: Matrix4; // world_from_layer as shown
  points: number;
  has: { intensity: boolean; source: boolean; distance: boolean };
}

interface Metadata {
  points: number;
  offset: [number, number, number];
  attributes: { name: string }[];
}

export class Clouds {
  readonly potree = new Potree();
  readonly layers: Layer[] = [];
  /** Subtracted from the world on the GPU, so that single precision shows no jitter. */
  readonly center = new Vector3();
  mode: ColorMode = 'rgb';
  private heights: [number, number] = [0, 1];

  constructor(private readonly onChange: () => void) {}

  async load(scene: SceneInfo): Promise<void> {
    for (const info of scene.layers) {
      const url = `/cloud/${info.name}/metadata.json`;
      const metadata = (await (await fetch(url)).json()) as Metadata;
      const octree = await this.potree.loadPointCloud(url, {
        fetch: (input, init) => fetch(input, init).finally(this.onChange),
        getUrl: async (path) => path,
      });
      const named = (name: string) => metadata.attributes.some((a) => a.name === name);
      this.layers.push({
        info,
        title: LAYER_TITLES[info.name],
        octree,
        pose: matrixOf(info.world_from_layer),
        points: metadata.points,
        has: { intensity: named('intensity'), source: named('classification'), distance: named('distance') },
      });
    }
    const first = this.layers[0];
    if (first) this.boxOf(first).getCenter(this.center);
    for (const layer of this.layers) {
      this.prepareMaterial(layer);
      this.place(layer, layer.pose);
    }
  }

  layer(name: LayerName): Layer | undefined {
    return this.layers.find((layer) => layer.info.name === name);
  }

  private prepareMaterial(layer: Layer): void {
    const material = layer.octree.material;
    // The library's shader for Potree 2.0 knows no colour but that of the photos; the one for Potree 1 knows all.
    material.newFormat = false;
    material.shape = PointShape.CIRCLE;
    material.pointSizeType = PointSizeType.ADAPTIVE;
    material.minSize = 2;
    material.maxSize = 40;
    // Colours come as they are to be shown; any conversion would wash them out.
    material.outputColorEncoding = material.inputColorEncoding;
    layer.octree.visible = false;
  }

  /** The corners of the whole cloud in the world. */
  boxOf(layer: Layer): Box3 {
    const geometry = layer.octree.pcoGeometry;
    const box = geometry.tightBoundingBox.clone().translate(geometry.offset);
    return box.applyMatrix4(layer.pose);
  }

  place(layer: Layer, pose: Matrix4): void {
    layer.pose = pose;
    const placed = pose.clone().multiply(new Matrix4().makeTranslation(layer.octree.pcoGeometry.offset));
    const octree = layer.octree;
    placed.decompose(octree.position, octree.quaternion as Quaternion, octree.scale);
    octree.position.sub(this.center);
    octree.updateMatrixWorld(true);
    this.onChange();
  }

  /** Points of the coarsest level in the GPU's frame: a fair sample of the whole. */
  sample(): Vector3[] {
    const points: Vector3[] = [];
    for (const layer of this.layers) {
      const geometry = rootGeometry(layer.octree);
      if (!geometry || !layer.octree.visible) continue;
      const positions = geometry.getAttribute('position');
      const step = Math.max(1, Math.floor(positions.count / 5000));
      layer.octree.updateMatrixWorld(true);
      for (let i = 0; i < positions.count; i += step) {
        points.push(new Vector3().fromBufferAttribute(positions, i).applyMatrix4(layer.octree.matrixWorld));
      }
    }
    return points;
  }

  setHeightRange(low: number, high: number): void {
    this.heights = [low, Math.max(high, low + 0.1)];
  }

  heightRange(): [number, number] {
    return [this.heights[0] + this.center.z, this.heights[1] + this.center.z];
  }

  colorize(mode: ColorMode): void {
    this.mode = mode;
    for (const layer of this.layers) {
      const material = layer.octree.material;
      const source = layer.info.name === 'lidar' ? SOURCE_COLORS.lidar : SOURCE_COLORS.vision;
      if (mode === 'height') {
        material.gradient = HEIGHT_GRADIENT;
        [material.heightMin, material.heightMax] = this.heights;
        material.pointColorType = PointColorType.HEIGHT;
      } else if (mode === 'intensity' && layer.has.intensity) {
        material.gradient = INFERNO;
        material.intensityRange = [0, 65535];
        material.pointColorType = PointColorType.INTENSITY_GRADIENT;
      } else if (mode === 'distance' && layer.has.distance) {
        material.gradient = DISTANCE_GRADIENT;
        material.intensityRange = [0, DISTANCE_RANGE_M];
        material.pointColorType = PointColorType.INTENSITY_GRADIENT;
      } else if (mode === 'source' && layer.has.source) {
        material.classification = { 0: rgba(SOURCE_COLORS.vision), 1: rgba(SOURCE_COLORS.lidar), 2: rgba(SOURCE_COLORS.interpolated), DEFAULT: rgba('#888888') };
        material.pointColorType = PointColorType.CLASSIFICATION;
      } else if (mode === 'rgb') {
        material.pointColorType = PointColorType.RGB;
      } else {
        material.color = new Color(mode === 'source' ? source : '#7d8590');
        material.pointColorType = PointColorType.COLOR;
      }
    }
    this.onChange();
  }

  setPointSize(size: number): void {
    for (const layer of this.layers) layer.octree.material.size = size;
    this.onChange();
  }

  /**
   * Gives the shader its attributes by the names it knows: `color`, and one scalar, `intensity`, whose place distance
   * takes while it is shown.
   */
  private bindAttributes(): void {
    const shown = this.mode === 'distance' ? 'distance' : 'measured';
    for (const layer of this.layers) {
      if (!layer.octree.visible) continue;
      for (const node of layer.octree.visibleNodes) {
        const geometry = node.geometryNode.geometry;
        if (!geometry) continue;
        if (!geometry.hasAttribute('color')) geometry.setAttribute('color', geometry.getAttribute('rgba'));
        if (!layer.has.distance || geometry.userData.scalar === shown) continue;
        if (!geometry.userData.measured) {
          const count = geometry.getAttribute('position').count;
          geometry.userData.measured =
            geometry.getAttribute('intensity') ?? new BufferAttribute(new Float32Array(count), 1);
        }
        const distance = geometry.getAttribute('distance');
        geometry.setAttribute('intensity', shown === 'distance' ? distance : geometry.userData.measured);
        geometry.userData.scalar = shown;
      }
    }
  }

  /** Chooses what is shown: at most `points`. @returns whether nodes are still on their way. */
  update(camera: Camera, renderer: WebGLRenderer, points: number): boolean {
    this.potree.pointBudget = points;
    const result = this.potree.updatePointClouds(this.visible(), camera, renderer);
    this.bindAttributes();
    return result.nodeLoadPromises.length > 0 || this.layers.some((l) => l.octree.pcoGeometry.numNodesLoading > 0);
  }

  visible(): PointCloudOctree[] {
    return this.layers.filter((layer) => layer.octree.visible).map((layer) => layer.octree);
  }

  visiblePoints(): number {
    return this.visible().reduce((sum, octree) => sum + octree.numVisiblePoints, 0);
  }

  pick(renderer: WebGLRenderer, camera: Camera, ray: Ray): Vector3 | null {
    const hit = Potree.pick(this.visible(), renderer, camera, ray, { pickWindowSize: 15 });
    return hit?.position ? hit.position.clone() : null;
  }
}

function rootGeometry(octree: PointCloudOctree): BufferGeometry | null {
  return octree.pcoGeometry.root?.geometry ?? null;
}

function rgba(css: string): Vector4 {
  const color = new Color().setStyle(css, '');
  return new Vector4(color.r, color.g, color.b, 1);
}
