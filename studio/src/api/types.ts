// What the server says: docs/studio_api.md. Angles in rad, lengths in m, times in s of the run.
import type { Whose } from './exhibits';
import type { Language, Worded } from './words';

export type { Language, Worded };

export type ComponentClass = 'goal' | 'sensation' | 'sensing' | 'acting' | 'coordinator';
export type Value = number | string | boolean | number[];

export interface PortDescriptor {
  name: string;
  direction: 'in' | 'out';
  role: string;
  unit: string;
  type: string;
  size: number;
  elements: string[];
  required: boolean;
  many: boolean;
  common: boolean;
  help: Worded;
}

export interface ParameterDescriptor {
  name: string;
  type: 'real' | 'integer' | 'boolean' | 'choice' | 'word' | 'reals' | 'file';
  unit: string;
  default: Value;
  min?: number;
  max?: number;
  choices?: string[];
  count?: number;
  ours: boolean;
  help: Worded;
}

export interface Kind {
  class: string;
  name: string;
  paper_name: string;
  summary: Worded;
  source: string;
  ports: PortDescriptor[];
  parameters: ParameterDescriptor[];
}

export interface Channel {
  name: string;
  unit: string;
  type: string;
  elements: string[];
  min: number;
  max: number;
}

export interface CommandElement {
  name: string;
  unit: string;
  min: number;
  max: number;
  safe: number;
}

export interface Robot {
  path: string;
  name: string;
  known: boolean;
  channels: Channel[];
  commands: { name: string; elements: CommandElement[] }[];
}

export interface Wire {
  text: string;
  from: string;
  output: string;
  element: string;
  previous: boolean;
  ok: boolean;
}

export interface Output {
  name: string;
  unit: string;
  type: string;
  elements: string[];
}

/** Without the lines that the server says besides: of a component that did not change they would be old (share.ts). */
export interface Component {
  id: string;
  class: ComponentClass;
  kind: string;
  editable: boolean;
  position: [number, number] | null;
  channel: string;
  command: string;
  inputs: { port: string; wires: Wire[] }[];
  outputs: Output[];
  parameters: { name: string; value: Value }[];
  unknown: { key: string; text: string }[];
}

export interface Problem {
  code: string;
  message: string;
  line: number;
  column: number;
  component: string;
  port: string;
  key: string;
}

export interface Model {
  name: string;
  tick_s: number;
  robot: Robot;
  components: Component[];
  problems: Problem[];
  runnable: boolean;
}

export type Operation =
  | { op: 'add'; class: string; kind: string; id?: string; position?: [number, number]; set?: Record<string, Value> }
  | { op: 'remove'; ids: string[] }
  | { op: 'rename'; id: string; to: string }
  | { op: 'set'; id: string; key: string; value: Value }
  | { op: 'unset'; id: string; key: string }
  | { op: 'connect'; from: string; id: string; port: string; index?: number }
  | { op: 'disconnect'; id: string; port: string; from?: string }
  | { op: 'reorder'; id: string; port: string; order: string[] }
  | { op: 'move'; positions: Record<string, [number, number]> }
  | { op: 'paste'; toml: string; offset?: [number, number] };

export interface RunFile {
  path: string;
  name: string;
  seed: number;
  finished: boolean;
  /** null: nobody judged. */
  success: boolean | null;
  reason: string;
  digest: string;
  controller_hash: string;
  recorded_s: number;
  measures: Record<string, number | null>;
}

export interface Files {
  folder: string;
  controllers: { path: string; name: string; draft: boolean }[];
  experiments: {
    path: string;
    name: string;
    controller: string;
    robot: string;
    world: string;
    duration_s: number;
    seed: number;
    /** Where the file says that the robot is; "" = nowhere else. */
    address: string;
    program: boolean;
    problems: number;
  }[];
  worlds: { path: string; name: string }[];
  robots: { path: string; name: string }[];
  runs: RunFile[];
}

export interface Outcome {
  /** null: nobody judged, for want of a criterion of success. */
  success: boolean | null;
  reason: string;
  reason_es: string;
  digest: string;
  measures: Record<string, number | null>;
  file: string;
  error: string | null;
  error_es?: string;
}

/** A look at a robot: what was found so far. */
export interface LinkTest {
  test: string;
  done: boolean;
  good: boolean;
  findings: { good: boolean; message: string }[];
}

export interface RunState {
  state: 'idle' | 'preparing' | 'armed' | 'running' | 'paused' | 'done';
  run: string;
  experiment: string;
  controller: string;
  name: string;
  seed: number;
  pace: number;
  speed: number;
  time_s: number;
  duration_s: number;
  share: number;
  outcome: Outcome | null;
  attached: boolean;
}

export interface Stream {
  stream: number;
  topic: string;
  kind: 'row' | 'field' | 'exhibit' | 'movers';
  columns: { name: string; unit: string }[];
  /** Of what is shown: who shows it. */
  of?: Whose;
}

export interface Shape {
  class: 'wall' | 'furniture' | 'mover';
  kind?: string;
  points?: [number, number][];
  closed?: boolean;
  x?: number;
  y?: number;
  radius?: number;
  id?: string;
  label?: string;
  pose?: [number, number, number];
}

export interface Scene {
  name: string;
  bounds: [number, number, number, number];
  shapes: Shape[];
  map?: {
    origin: [number, number, number];
    resolution: number;
    columns: number;
    rows: number;
    occupied: [number, number, number, number][];
    unknown: [number, number, number, number][];
  };
  movers: Shape[];
  spawns: { id?: string; label?: string; pose: [number, number, number] }[];
  floor?: Shape[];
  bumps?: [[number, number], [number, number]][];
  beacons?: { x: number; y: number }[];
}

export interface RobotInfo {
  name: string;
  length_m: number;
  width_m: number;
  radius_m: number;
  sensors: {
    id: string;
    kind: string;
    x_m: number;
    y_m: number;
    yaw_rad: number;
    cone_rad: number;
    max_range_m: number;
    signal: string;
  }[];
  /** Side of the cells that a goal set by hand can be; none where nobody takes one. */
  goal_cell_m?: number;
}

export interface Info {
  robots: RobotInfo[];
  coordinators: { id: string; candidates: string[] }[];
  cell_m: number;
}

/** Somebody reached into the running world: set a goal, or put an obstacle elsewhere. */
export interface InterventionEvent {
  event: 'intervention';
  time_s: number;
  tick: number;
  what: 'goal' | 'obstacle';
  robot?: number;
  mover?: string;
  x_m: number;
  y_m: number;
}

export interface LogEvent {
  event: 'log';
  time_s: number;
  level: number;
  name: string;
  message: string;
  message_es?: string;
}

export type StudioEvent =
  | { event: 'run'; state: RunState }
  | { event: 'streams'; streams: Stream[]; scene: Scene | null; info: Info | null; more?: boolean }
  | { event: 'file'; path: string; hash: string }
  | ({ event: 'link' } & LinkTest)
  | InterventionEvent
  | LogEvent;

export interface Hello {
  type: 'hello';
  protocol: number;
  session: string;
  seq: number;
  resumed: boolean;
  state: RunState;
  streams: Stream[];
  scene: Scene | null;
  info: Info | null;
}

export interface Recording {
  info: Info;
  scene: Scene | null;
  streams: Stream[];
  events: (InterventionEvent | LogEvent)[];
  duration_s: number;
  run: RunFile;
  damages: string[];
}
