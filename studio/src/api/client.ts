import type { Files, Kind, Language, LinkTest, Model, Operation, Recording, RunState } from './types';

/** What the server refused, with its code: the page words codes it knows and shows the message of others. */
export class ApiError extends Error {
  constructor(
    readonly code: string,
    message: string,
    readonly details: Record<string, unknown> = {},
  ) {
    super(message);
  }
}

let language: Language = 'en';

/** Messages come in this language from now on. */
export function speak(wanted: Language): void {
  language = wanted;
}

async function answerOf(request: Promise<Response>): Promise<Response> {
  let response: Response;
  try {
    response = await request;
  } catch {
    throw new ApiError('Unreachable', '');
  }
  if (response.ok) return response;
  const body = await response.json().catch(() => null);
  const error = body?.error ?? { code: `${response.status}`, message: response.statusText };
  throw new ApiError(error.code, error.message, error.arguments ?? {});
}

async function get<T>(path: string): Promise<T> {
  return (await answerOf(fetch(path))).json();
}

function send(path: string, body: object): Promise<Response> {
  return answerOf(
    fetch(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ language, ...body }),
    }),
  );
}

async function post<T>(path: string, body: object): Promise<T> {
  return (await send(path, body)).json();
}

export interface Opened {
  path: string;
  text: string;
  hash: string;
  draft: { text: string; based_on: string } | null;
}

export interface Target {
  id: string;
  port: string;
  ok: boolean;
  reasons: string[];
}

export interface Source {
  from: string;
  ok: boolean;
  reasons: string[];
}

export interface StartRun {
  experiment: string;
  controller?: { path: string; text: string };
  world?: string;
  robot?: string;
  seed?: number;
  pace?: number;
  duration_s?: number;
  record?: boolean;
  paused?: boolean;
  program?: string;
  /** "" = the built-in simulation, whatever the experiment says. */
  address?: string;
}

/** Where a goal or an obstacle went. */
export interface Reached {
  x_m: number;
  y_m: number;
  reachable: boolean;
}

export interface Place {
  path: string;
  text: string;
}

export const api = {
  kinds: () => get<Kind[]>('/api/kinds'),
  files: () => get<Files>('/api/files'),
  programs: () => get<{ programs: { name: string; help: string }[] }>('/api/programs'),

  openFile: (path: string) => post<Opened>('/api/file/open', { path }),
  save: (place: Place, basedOn: string) => post<{ hash: string }>('/api/file/save', { ...place, based_on: basedOn }),
  autosave: (place: Place, basedOn: string) => post<object>('/api/file/autosave', { ...place, based_on: basedOn }),
  discard: (path: string) => post<object>('/api/file/discard', { path }),

  open: (place: Place) => post<{ model: Model }>('/api/document/open', place),
  edit: (place: Place, operations: Operation[]) =>
    post<{ text: string; model: Model; ids: string[] }>('/api/document/edit', { ...place, operations }),
  targets: (place: Place, from: string) => post<{ targets: Target[] }>('/api/document/targets', { ...place, from }),
  sources: (place: Place, to: string, port: string) =>
    post<{ sources: Source[] }>('/api/document/targets', { ...place, to, port }),
  mayConnect: (place: Place, from: string, to: string, port: string) =>
    post<{ ok: boolean; reasons?: string[] }>('/api/document/may_connect', { ...place, from, to, port }),
  copy: (place: Place, ids: string[]) => post<{ toml: string }>('/api/document/copy', { ...place, ids }),

  testLink: (run: StartRun) => post<{ test: LinkTest }>('/api/link/test', run),
  start: (run: StartRun) => post<{ run: string }>('/api/run/start', run),
  pause: () => post<{ state: RunState }>('/api/run/pause', {}),
  resume: () => post<{ state: RunState }>('/api/run/resume', {}),
  step: (ticks: number) => post<{ state: RunState }>('/api/run/step', { ticks }),
  stop: () => post<{ state: RunState }>('/api/run/stop', {}),
  reset: () => post<{ state: RunState }>('/api/run/reset', {}),
  pace: (pace: number) => post<{ state: RunState }>('/api/run/pace', { pace }),

  setGoal: (robot: number, x_m: number, y_m: number) => post<Reached>('/api/run/goal', { robot, x_m, y_m }),
  putObstacle: (mover: string, x_m: number, y_m: number) => post<Reached>('/api/run/obstacle', { mover, x_m, y_m }),

  recording: (path: string) => post<Recording>('/api/recording/open', { path }),
  samples: async (path: string) => (await send('/api/recording/samples', { path })).arrayBuffer(),
  recordedController: (path: string) => post<{ text: string }>('/api/recording/controller', { path }),
  reportUrl: (path: string) => `/api/recording/report?path=${encodeURIComponent(path)}&language=${language}`,
};
