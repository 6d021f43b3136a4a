// The world on a canvas: metres to dots, colours from the style sheet, lines and shapes.

const DASHES = [[], [7, 3], [2, 2.5], [9, 3, 2, 3], [4, 2], [12, 4], [2, 5], [9, 2, 4, 2]];

function styleColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** All colours the canvases use; read again when the colour scheme changes. */
function readColours(roles) {
  const names = ['floor', 'line', 'wall', 'free', 'mover', 'zone', 'bump', 'body', 'start', 'trail', 'goal', 'sonar', 'contact', 'text', 'muted', 'card', 'accent'];
  const colours = Object.fromEntries(names.map((name) => [name, styleColour(name)]));
  colours.roles = Object.fromEntries(Object.keys(roles).map((name) => [name, styleColour(`role-${name}`)]));
  colours.looks = Array.from({ length: 8 }, (_, i) => styleColour(`look-${i}`));
  return colours;
}

function lookColour(colours, index) {
  return index < 0 ? colours.muted : colours.looks[index % 8];
}

/** Dots of the screen behind one CSS pixel are respected; drawing is in CSS pixels. */
function fitCanvas(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

/** The world seen through a canvas; y grows upwards in the world, downwards on the canvas. */
class View {
  constructor(canvas, bounds) {
    this.canvas = canvas;
    this.bounds = bounds;
    this.zoom = 1;
    this.centre = [(bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2];
  }

  begin() {
    const { context, width, height } = fitCanvas(this.canvas);
    const margin = 14;
    const fit = Math.min(
      (width - 2 * margin) / (this.bounds[2] - this.bounds[0]),
      (height - 2 * margin) / (this.bounds[3] - this.bounds[1]),
    );
    this.context = context;
    this.scale = fit * this.zoom;
    this.middle = [width / 2, height / 2];
    return context;
  }

  x(metres) {
    return this.middle[0] + (metres - this.centre[0]) * this.scale;
  }

  y(metres) {
    return this.middle[1] - (metres - this.centre[1]) * this.scale;
  }

  /** Traces x, y pairs, each taken to the world by `pose` where one is given. */
  trace(points, closed, pose) {
    const c = pose ? Math.cos(pose.yaw) : 1;
    const s = pose ? Math.sin(pose.yaw) : 0;
    const [dx, dy] = pose ? [pose.x, pose.y] : [0, 0];
    this.context.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) {
      const x = this.x(dx + c * points[i] - s * points[i + 1]);
      const y = this.y(dy + s * points[i] + c * points[i + 1]);
      if (i === 0) this.context.moveTo(x, y);
      else this.context.lineTo(x, y);
    }
    if (closed) this.context.closePath();
  }

  stroke(colour, width, dash) {
    this.context.strokeStyle = colour;
    this.context.lineWidth = width;
    this.context.setLineDash(dash || []);
    this.context.stroke();
    this.context.setLineDash([]);
  }

  fill(colour) {
    this.context.fillStyle = colour;
    this.context.fill();
  }

  disc(x, y, radius) {
    this.context.beginPath();
    this.context.arc(this.x(x), this.y(y), radius, 0, 2 * Math.PI);
  }
}

function zoomAt(view, factor, x, y) {
  const zoom = Math.min(40, Math.max(1, view.zoom * factor));
  const change = 1 / view.scale - 1 / ((view.scale / view.zoom) * zoom);
  view.centre = [view.centre[0] + (x - view.middle[0]) * change, view.centre[1] - (y - view.middle[1]) * change];
  view.zoom = zoom;
  if (zoom === 1) view.centre = [(view.bounds[0] + view.bounds[2]) / 2, (view.bounds[1] + view.bounds[3]) / 2];
}
