import { roleLook, roleNames } from '../api/exhibits';
import { isDark } from '../theme/settings';

/** The world seen through a canvas [m -> CSS px]; y grows upwards in the world, downwards on the canvas. */
export class View {
  context!: CanvasRenderingContext2D;
  scale = 1;
  zoom = 1;
  middle: [number, number] = [0, 0];
  centre: [number, number] = [0, 0];
  width = 0;
  height = 0;
  private bounds: readonly [number, number, number, number] = [0, 0, 1, 1];

  constructor(readonly canvas: HTMLCanvasElement) {}

  /** Another world is seen whole at first. */
  setBounds(bounds: readonly [number, number, number, number]): void {
    if (this.bounds.every((value, i) => value === bounds[i])) return;
    this.bounds = bounds;
    this.whole();
  }

  whole(): void {
    this.zoom = 1;
    this.centre = [(this.bounds[0] + this.bounds[2]) / 2, (this.bounds[1] + this.bounds[3]) / 2];
  }

  /** Clears the canvas; false where there is nothing to draw on. */
  begin(): boolean {
    const ratio = window.devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    const [w, h] = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (w === 0 || h === 0) return false;
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    const context = this.canvas.getContext('2d');
    if (!context) return false;
    this.context = context;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    const margin = 16;
    const below = margin + Math.min(40, this.height / 8); // the buttons lie there
    const [x0, y0, x1, y1] = this.bounds;
    const fit = Math.min((this.width - 2 * margin) / (x1 - x0 || 1), (this.height - margin - below) / (y1 - y0 || 1));
    this.scale = Math.max(1e-3, fit) * this.zoom;
    this.middle = [this.width / 2, (this.height + margin - below) / 2];
    return true;
  }

  x(metres: number): number {
    return this.middle[0] + (metres - this.centre[0]) * this.scale;
  }

  y(metres: number): number {
    return this.middle[1] - (metres - this.centre[1]) * this.scale;
  }

  /** The point of the world at a point of the canvas. */
  metres(x: number, y: number): [number, number] {
    return [this.centre[0] + (x - this.middle[0]) / this.scale, this.centre[1] - (y - this.middle[1]) / this.scale];
  }

  zoomBy(factor: number, x = this.middle[0], y = this.middle[1]): void {
    const zoom = Math.min(60, Math.max(0.5, this.zoom * factor));
    const change = 1 / this.scale - this.zoom / (this.scale * zoom);
    this.centre = [this.centre[0] + (x - this.middle[0]) * change, this.centre[1] - (y - this.middle[1]) * change];
    this.zoom = zoom;
  }

  panBy(dx: number, dy: number): void {
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] + dy / this.scale];
  }

  polygon(
    points: readonly (readonly [number, number])[],
    closed: boolean,
    pose?: readonly [number, number, number],
  ): void {
    const [px, py, yaw] = pose ?? [0, 0, 0];
    const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
    this.context.beginPath();
    for (const [x, y] of points) this.context.lineTo(this.x(px + c * x - s * y), this.y(py + s * x + c * y));
    if (closed) this.context.closePath();
  }

  disc(x: number, y: number, radius_px: number): void {
    this.context.beginPath();
    this.context.arc(this.x(x), this.y(y), radius_px, 0, 2 * Math.PI);
  }

  fill(colour: string): void {
    this.context.fillStyle = colour;
    this.context.fill();
  }

  stroke(colour: string, width: number, dash: number[] = []): void {
    this.context.strokeStyle = colour;
    this.context.lineWidth = width;
    this.context.setLineDash(dash);
    this.context.stroke();
    this.context.setLineDash([]);
  }
}

const kNames = [
  'floor',
  'line',
  'wall',
  'free',
  'mover',
  'body',
  'start',
  'trail',
  'goalmark',
  'sonar',
  'contact',
  'bump',
] as const;

export type WorldColours = Record<(typeof kNames)[number], string> & { roles: Record<string, string> };

/** Colours of the style sheet, as they are now. */
export function worldColours(): WorldColours {
  const style = getComputedStyle(document.documentElement);
  const look = isDark() ? 'dark' : 'light';
  const named = Object.fromEntries(kNames.map((name) => [name, style.getPropertyValue(`--world-${name}`).trim()]));
  return {
    ...named,
    roles: Object.fromEntries(roleNames().map((name) => [name, roleLook(name)[look]])),
  } as WorldColours;
}
