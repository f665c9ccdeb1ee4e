// The controls around the picture, and the keyboard.
import { COLOR_MODES, Clouds, ColorMode, DISTANCE_RANGE_M, cssGradient } from './clouds';
import { SceneInfo } from './scene';

export interface Actions {
  redraw(): void;
  blend(t: number): void;
  frame(): void;
  top(): void;
  showCameras(on: boolean): void;
  showDrive(on: boolean): void;
  shadeDepth(on: boolean): void;
  measure(on: boolean): void;
}

const MODE_TITLES: Record<ColorMode, string> = {
  rgb: 'Photo', height: 'Height', intensity: 'Intensity', source: 'Source', distance: 'Distance',
};
const MODE_HINTS: Record<ColorMode, string> = {
  rgb: 'Colours of the photos; grey by intensity where no photo saw the point',
  height: 'Height',
  intensity: 'LiDAR intensity',
  source: 'Which sensor saw the point',
  distance: "Distance to the other sensor's cloud",
};

function find<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

/** Replaces the page by a sentence. */
export function fail(message: string): void {
  const box = find('failure');
  const text = document.createElement('p');
  text.textContent = message;
  box.replaceChildren(text);
  box.hidden = false;
  find('view').setAttribute('aria-busy', 'false');
}

function count(points: number): string {
  if (points >= 1e6) return `${(points / 1e6).toFixed(1)} M`;
  return points >= 1e3 ? `${(points / 1e3).toFixed(0)} k` : `${points}`;
}

export class Panel {
  private readonly boxes: HTMLInputElement[] = [];
  private readonly modes = new Map<ColorMode, HTMLButtonElement>();
  private sweep = 0; // timer of the before/after animation

  constructor(private readonly scene: SceneInfo, private readonly clouds: Clouds, private readonly act: Actions) {
    find('name').textContent = scene.name;
    document.title = `${scene.name} – HybridFusion viewer`;
    find('report').hidden = !scene.report;
    this.verdict();
    this.layers();
    this.colors();
    this.registration();
    this.show();
    this.tools();
    window.addEventListener('keydown', (event) => this.key(event));
  }

  say(text: string | null): void {
    find('message').hidden = text === null;
    find('message').textContent = text ?? '';
  }

  status(points: number, loading: boolean): void {
    find('status').textContent = `${count(points)} points shown${loading ? ' …' : ''}`;
  }

  private verdict(): void {
    const registration = this.scene.registration;
    if (!registration) return;
    const pill = find('verdict');
    const ok = registration.status === 'ok';
    pill.textContent = ok ? `registered, confidence ${registration.confidence.toFixed(2)}` : 'registration refused';
    pill.classList.add(!ok ? 'red' : registration.confidence >= 0.9 ? 'green' : registration.confidence >= 0.5 ? 'amber' : 'red');
    pill.title = registration.reason;
    pill.hidden = false;
  }

  private layers(): void {
    const hasFused = this.clouds.layer('fused') !== undefined;
    for (const layer of this.clouds.layers) {
      const label = document.createElement('label');
      const box = document.createElement('input');
      const title = document.createElement('span');
      const points = document.createElement('em');
      box.type = 'checkbox';
      box.id = `layer-${layer.info.name}`;
      box.checked = layer.info.name === 'fused' || !hasFused;
      title.textContent = layer.title;
      points.textContent = count(layer.points);
      label.title = `${layer.info.file}, ${layer.points} points`;
      label.append(box, title, points);
      find('layers').append(label);
      const apply = () => {
        layer.octree.visible = box.checked;
        this.act.redraw();
      };
      box.addEventListener('change', apply);
      apply();
      this.boxes.push(box);
    }
  }

  private colors(): void {
    const has = (name: 'intensity' | 'distance') => this.clouds.layers.some((layer) => layer.has[name]);
    for (const mode of COLOR_MODES) {
      const button = document.createElement('button');
      button.textContent = MODE_TITLES[mode];
      button.title = MODE_HINTS[mode];
      button.id = `mode-${mode}`;
      button.setAttribute('role', 'radio');
      button.disabled = (mode === 'intensity' || mode === 'distance') && !has(mode);
      button.addEventListener('click', () => this.color(mode));
      find('modes').append(button);
      this.modes.set(mode, button);
    }
    this.color('rgb');
  }

  private color(mode: ColorMode): void {
    this.clouds.colorize(mode);
    for (const [other, button] of this.modes) button.setAttribute('aria-checked', String(other === mode));
    find('keys').hidden = mode !== 'source';
    find('legend').hidden = mode === 'rgb' || mode === 'source';
    find('ramp').style.background = cssGradient(mode);
    const [low, high] = this.clouds.heightRange();
    const ends: Record<string, [string, string, string]> = {
      height: [`${low.toFixed(0)} m`, '', `${high.toFixed(0)} m`],
      intensity: ['weak', '', 'strong'],
      distance: ['0 m', `${DISTANCE_RANGE_M / 2} m`, `≥ ${DISTANCE_RANGE_M} m`],
    };
    const texts = ends[mode] ?? ['', '', ''];
    ['low', 'mid', 'high'].forEach((id, i) => (find(id).textContent = texts[i] ?? ''));
  }

  private registration(): void {
    const registration = this.scene.registration;
    if (registration?.status !== 'ok' || !this.clouds.layer('lidar') || !this.clouds.layer('vision')) return;
    find('registration').hidden = false;
    find('before').textContent = registration.has_initial ? 'before (GNSS)' : 'before (own frame)';
    find('slider').addEventListener('input', () => {
      this.stopSweep();
      this.blend(Number(find<HTMLInputElement>('slider').value));
    });
  }

  /** The fused cloud stands still, so the slider shows its two parts. */
  private blend(t: number): void {
    for (const box of this.boxes) {
      const wanted = box.id !== 'layer-fused';
      if (box.checked !== wanted) box.click();
    }
    find<HTMLInputElement>('slider').value = String(t);
    this.act.blend(t);
  }

  private stopSweep(): void {
    cancelAnimationFrame(this.sweep);
  }

  /** Moves the slider to its other end within a second. */
  private toggleBeforeAfter(): void {
    if (find('registration').hidden) return;
    this.stopSweep();
    const from = Number(find<HTMLInputElement>('slider').value);
    const to = from > 0.5 ? 0 : 1;
    const began = performance.now();
    const step = (now: number) => {
      const s = Math.min(1, (now - began) / 900);
      this.blend(from + (to - from) * s * s * (3 - 2 * s));
      if (s < 1) this.sweep = requestAnimationFrame(step);
    };
    this.sweep = requestAnimationFrame(step);
  }

  private check(id: string, apply: (on: boolean) => void): void {
    const box = find<HTMLInputElement>(id);
    box.addEventListener('change', () => {
      apply(box.checked);
      this.act.redraw();
    });
  }

  private show(): void {
    find('show-cameras').hidden = this.scene.cameras.length === 0;
    find('num-cameras').textContent = `${this.scene.cameras.length}`;
    const placed = this.scene.registration?.status === 'ok' || !this.clouds.layer('vision');
    find('show-drive').hidden = this.scene.trajectory_in_lidar.length === 0 || !placed;
    this.check('cameras', (on) => this.act.showCameras(on));
    this.check('drive', (on) => this.act.showDrive(on));
    this.check('edl', (on) => this.act.shadeDepth(on));
    const size = find<HTMLInputElement>('size');
    const apply = () => this.clouds.setPointSize(Number(size.value));
    size.addEventListener('input', apply);
    apply();
  }

  private tools(): void {
    const measure = find('measure');
    measure.addEventListener('click', () => {
      const on = measure.getAttribute('aria-pressed') !== 'true';
      measure.setAttribute('aria-pressed', String(on));
      this.act.measure(on);
    });
    find('frame').addEventListener('click', () => this.act.frame());
    find('top').addEventListener('click', () => this.act.top());
    find('help').addEventListener('click', () => find<HTMLDialogElement>('keyboard').showModal());
  }

  private nextColor(): void {
    const usable = COLOR_MODES.filter((mode) => !this.modes.get(mode)!.disabled);
    this.color(usable[(usable.indexOf(this.clouds.mode) + 1) % usable.length]!);
  }

  private resizePoints(step: number): void {
    const size = find<HTMLInputElement>('size');
    size.value = String(Number(size.value) + step);
    size.dispatchEvent(new Event('input'));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || find<HTMLDialogElement>('keyboard').open) return;
    const press = (id: string) => () => find(id).click();
    const keys: Record<string, () => void> = {
      '1': () => this.boxes[0]?.click(), '2': () => this.boxes[1]?.click(), '3': () => this.boxes[2]?.click(),
      c: () => this.nextColor(), b: () => this.toggleBeforeAfter(), m: press('measure'), f: press('frame'), t: press('top'),
      p: press('cameras'), l: press('drive'), e: press('edl'), '?': press('help'), '+': () => this.resizePoints(0.2),
      '-': () => this.resizePoints(-0.2), h: () => (find('panel').hidden = !find('panel').hidden),
      escape: () => find('measure').getAttribute('aria-pressed') === 'true' ? find('measure').click() : this.say(null),
    };
    const action = keys[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
