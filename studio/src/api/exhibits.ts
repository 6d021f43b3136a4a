// What is shown, by form: docs/studio_api.md, Exhibits. Words in both languages, roles by name, points as x, y, x, y...
import roles from './roles.json';
import type { Worded } from './words';

/** How a role is drawn and called: the table of ganglion/exhibit/role.cpp, which a test holds this one to. */
export interface RoleLook extends Worded {
  light: string;
  dark: string;
  dash: number[];
  sign: string;
  filled: boolean;
  over: boolean;
}
const kRoles: Record<string, RoleLook> = roles;

export function roleLook(role: string): RoleLook {
  return kRoles[role] ?? kRoles.plain;
}

export function roleNames(): string[] {
  return Object.keys(kRoles);
}

/** Who shows it: robot -1 = the application as a whole. */
export interface Whose {
  robot: number;
  owner: string;
  form: string;
  name: string;
}

export interface ShownAxis {
  title: Worded;
  unit: string;
  ticks: Worded[];
}

export interface ShownClass {
  byte: number;
  role: string;
  title: Worded;
}

export interface ShownLayer {
  name: string;
  title: Worded;
  unit: string;
  low: number;
  high: number;
  classes: ShownClass[];
}

/** Words and scales of a field; a byte of a cell is 0 at the low end of a layer's scale, 254 at the high one. */
export interface FieldWords {
  title: Worded;
  frame: string;
  cell: [number, number];
  layers: ShownLayer[];
  across?: ShownAxis;
  up?: ShownAxis;
}

export const kUnknown = 255;

export interface ShownFrame {
  in: string;
  x: number;
  y: number;
  yaw: number;
  columns: [string, string, string];
}

export const kForms = { polyline: 0, polygon: 1, disc: 2, sector: 3, point: 4, label: 5 } as const;

export interface ShownShape {
  form: number;
  role: string;
  frame: string;
  xy: number[];
  id?: string;
  radius?: number;
  angle?: number;
  column?: string;
  label?: Worded;
}

export interface ShownCurve {
  across: ShownAxis;
  up: ShownAxis;
  lines: { title: Worded; role: string; xy: number[] }[];
  cursor: string;
}

export interface ShownBars {
  up: ShownAxis;
  bars: { title: Worded; value: number; role: string }[];
}

export interface ShownNetwork {
  nodes: { title: Worded; x: number; y: number; value: number; role: string }[];
  edges: { from: number; to: number; weight: number; role: string }[];
}

/** A state of anything but a field: which members there are follows from the form. */
export type Exhibit = { title: Worded } & Partial<ShownFrame> &
  Partial<ShownCurve> &
  Partial<ShownBars> &
  Partial<ShownNetwork> & { shapes?: ShownShape[] };
