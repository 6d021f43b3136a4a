import { history, type ValueSource } from '../state/live_values';

const kWidth = 150;
const kHeight = 44;

let card: HTMLElement | null = null;

function draw(canvas: HTMLCanvasElement, values: number[]): void {
  const ratio = devicePixelRatio || 1;
  canvas.width = kWidth * ratio;
  canvas.height = kHeight * ratio;
  const context = canvas.getContext('2d');
  const known = values.filter(Number.isFinite);
  if (!context || known.length < 2) return;
  context.scale(ratio, ratio);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  context.strokeStyle = getComputedStyle(canvas).color;
  context.lineWidth = 1.5;
  context.beginPath();
  let open = false;
  values.forEach((value, i) => {
    const x = (i / (values.length - 1)) * (kWidth - 4) + 2;
    const y = kHeight - 4 - ((value - low) / (high - low || 1)) * (kHeight - 8);
    if (!Number.isFinite(value)) open = false;
    else if (open) context.lineTo(x, y);
    else {
      context.moveTo(x, y);
      open = true;
    }
  });
  context.stroke();
}

/** A small plot of the last values beside a wire's label; null takes it away. */
export function showSparkline(beside: HTMLElement | null, source?: ValueSource): void {
  card?.remove();
  card = null;
  if (!beside || !source) return;
  const values = history(source);
  if (values.length < 2) return;
  card = document.createElement('div');
  card.className = 'sparkline';
  card.setAttribute('role', 'presentation');
  const canvas = document.createElement('canvas');
  const caption = document.createElement('small');
  caption.textContent = `${source.signals[0]}${source.unit ? ` [${source.unit}]` : ''}`;
  card.append(canvas, caption);
  document.body.append(card);
  const box = beside.getBoundingClientRect();
  card.style.left = `${Math.max(4, Math.min(innerWidth - kWidth - 24, box.left))}px`;
  card.style.top = `${Math.max(4, box.top - kHeight - 34)}px`;
  draw(canvas, values);
}
