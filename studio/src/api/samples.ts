import type { Exhibit, FieldWords } from './exhibits';

/** One sample of a stream (docs/studio_api.md, Samples); the numbers of a row or path may be the message's own. */
export type Sample = { stream: number; seq: number; t: number } & (
  | { kind: 'row'; tick: number; values: Float64Array }
  | { kind: 'field'; base: number; field: FieldChange }
  | { kind: 'exhibit'; exhibit: Exhibit }
  | { kind: 'movers'; movers: { id: string; x_m: number; y_m: number; yaw_rad: number }[] }
);

/** Cells that are new or changed: all layers of each, one byte a layer. Words only of a field as a whole. */
export interface FieldChange {
  columns: number;
  rows: number;
  origin: [number, number];
  layers: number;
  cells: Uint32Array;
  values: Uint8Array;
  words: FieldWords | null;
}

const kHeader = 16;
const kFieldHeader = 40;

const kLittleEndian = new Uint8Array(Uint16Array.of(1).buffer)[0] === 1;

/** The message's own bytes where they lie as numbers must; else copied out of it. */
function floats(view: DataView, at: number, count: number): Float64Array {
  const start = view.byteOffset + at;
  if (at + 8 * count > view.byteLength) throw new RangeError('cut short');
  if (kLittleEndian && start % 8 === 0) return new Float64Array(view.buffer, start, count);
  const values = new Float64Array(count);
  for (let i = 0; i < count; i += 1) values[i] = view.getFloat64(at + 8 * i, true);
  return values;
}

function jsonAt(view: DataView, at: number, bytes = view.byteLength - at) {
  return JSON.parse(new TextDecoder().decode(new Uint8Array(view.buffer, view.byteOffset + at, bytes)));
}

function fieldOf(view: DataView, at: number): { base: number; field: FieldChange } {
  const layers = view.getUint32(at + 28, true);
  const count = view.getUint32(at + 32, true);
  const words = view.getUint32(at + 36, true);
  const cells = new Uint32Array(count);
  for (let i = 0; i < count; i += 1) cells[i] = view.getUint32(at + kFieldHeader + 4 * i, true);
  const start = at + kFieldHeader + 4 * count;
  const end = start + count * layers;
  if (end + words > view.byteLength) throw new RangeError('cut short');
  const field = {
    columns: view.getUint32(at + 4, true),
    rows: view.getUint32(at + 8, true),
    origin: [view.getFloat64(at + 12, true), view.getFloat64(at + 20, true)] as [number, number],
    layers,
    cells,
    values: new Uint8Array(view.buffer.slice(view.byteOffset + start, view.byteOffset + end)),
    words: words > 0 ? (jsonAt(view, end, words) as FieldWords) : null,
  };
  return { base: view.getUint32(at, true), field };
}

/** null: not one that this page understands, or cut short. */
export function decodeSample(view: DataView): Sample | null {
  if (view.byteLength < kHeader || view.getUint8(1) !== 1) return null;
  const head = { stream: view.getUint16(2, true), seq: view.getUint32(4, true), t: view.getFloat64(8, true) };
  try {
    switch (view.getUint8(0)) {
      case 1: {
        const count = view.getUint32(kHeader + 4, true);
        return { ...head, kind: 'row', tick: view.getUint32(kHeader, true), values: floats(view, kHeader + 8, count) };
      }
      case 4:
        return { ...head, kind: 'movers', movers: jsonAt(view, kHeader).movers };
      case 6:
        return { ...head, kind: 'field', ...fieldOf(view, kHeader) };
      case 7:
        return { ...head, kind: 'exhibit', exhibit: jsonAt(view, kHeader) };
      default:
        return null;
    }
  } catch {
    return null;
  }
}

const kBundle = 5;

/** All samples of one message: it may be several rows that waited together. */
export function decodeMessage(buffer: ArrayBuffer): Sample[] {
  const view = new DataView(buffer);
  if (view.byteLength < kHeader || view.getUint8(0) !== kBundle) {
    const sample = decodeSample(view);
    return sample ? [sample] : [];
  }
  const samples: Sample[] = [];
  for (let at = kHeader; at + 8 <= view.byteLength; ) {
    const bytes = Number(view.getBigUint64(at, true));
    if (at + 8 + bytes > view.byteLength) break;
    const sample = decodeSample(new DataView(buffer, at + 8, bytes));
    if (sample) samples.push(sample);
    at += 8 + Math.ceil(bytes / 8) * 8;
  }
  return samples;
}

/** The samples of a recording, each behind its length in bytes. */
export function decodeSamples(buffer: ArrayBuffer): Sample[] {
  const view = new DataView(buffer);
  const samples: Sample[] = [];
  for (let at = 0; at + 4 <= view.byteLength; ) {
    const bytes = view.getUint32(at, true);
    if (at + 4 + bytes > view.byteLength) break;
    const sample = decodeSample(new DataView(buffer, at + 4, bytes));
    if (sample) samples.push(sample);
    at += 4 + bytes;
  }
  return samples;
}
