// What /scene.json says. Poses are 4x4, row-major; the world is the frame of the vision cloud, or of the LiDAR map
// where there is no other.
import { Matrix4 } from 'three';

export type LayerName = 'fused' | 'vision' | 'lidar';
export type Pose = number[];

export interface LayerInfo {
  name: LayerName;
  file: string;
  world_from_layer: Pose;
}

export interface CameraInfo {
  name: string;
  world_from_camera: Pose;
  half_width?: number; // of the image at distance 1
  half_height?: number;
}

export interface RegistrationInfo {
  status: 'ok' | 'refused';
  confidence: number;
  method: string;
  reason: string;
  has_initial: boolean;
  before?: Pose;
  after?: Pose;
}

export interface SceneInfo {
  name: string;
  layers: LayerInfo[];
  max_distance_m: number;
  registration: RegistrationInfo | null;
  cameras: CameraInfo[];
  trajectory_in_lidar: [number, number, number][];
  report: boolean;
}

export const LAYER_TITLES: Record<LayerName, string> = {
  fused: 'Fused cloud',
  vision: 'Vision (photos)',
  lidar: 'LiDAR (street)',
};

export function matrixOf(pose: Pose): Matrix4 {
  return new Matrix4().fromArray(pose).transpose();
}

export async function loadScene(): Promise<SceneInfo> {
  const answer = await fetch('/scene.json');
  if (!answer.ok) throw new Error(`the scene could not be loaded (HTTP ${answer.status})`);
  return (await answer.json()) as SceneInfo;
}
