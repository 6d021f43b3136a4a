// An in-memory stand-in for the document service, after docs/studio_api.md: as much as the page's own tests need.
import type { Component, Model, Operation, Output, Wire } from '../src/api/types';

export function wire(text: string): Wire {
  const previous = text.endsWith('@previous');
  const [from, output = '', element = ''] = text.replace('@previous', '').split('.');
  return { text, from, output, element, previous, ok: true };
}

export function output(name: string, elements: string[] = [], unit = ''): Output {
  return { name, unit, type: 'real', elements };
}

export function component(id: string, more: Partial<Component> = {}): Component {
  return {
    id,
    class: 'sensing',
    kind: '',
    editable: true,
    position: null,
    channel: '',
    command: '',
    inputs: [],
    outputs: [],
    parameters: [],
    unknown: [],
    ...more,
  };
}

export function model(components: Component[]): Model {
  const robot = { path: 'robot.toml', name: 'Stub', known: true, channels: [], commands: [] };
  return { name: 'Stub', tick_s: 0, robot, components, problems: [], runnable: true };
}

/** The stub's text is one id a line. */
function modelOf(text: string): Model {
  return model(
    text
      .split('\n')
      .filter(Boolean)
      .map((id) => component(id)),
  );
}

function edited(text: string, operation: Operation): string {
  const ids = text.split('\n').filter(Boolean);
  if (operation.op === 'add') return [...ids, operation.id ?? 'new'].join('\n');
  if (operation.op === 'remove') return ids.filter((id) => !operation.ids.includes(id)).join('\n');
  if (operation.op === 'rename') return ids.map((id) => (id === operation.id ? operation.to : id)).join('\n');
  return `${text}\n`;
}

export class StubServer {
  files = new Map<string, string>();
  drafts = new Map<string, { text: string; based_on: string }>();
  asked: string[] = [];

  install(): void {
    globalThis.fetch = (async (path: string, init?: RequestInit) => this.answer(path, init)) as typeof fetch;
  }

  private answer(path: string, init?: RequestInit): Response {
    this.asked.push(path);
    const body = init?.body ? JSON.parse(String(init.body)) : {};
    const [status, answer] = this.respond(path, body);
    return new Response(JSON.stringify(answer), { status });
  }

  private respond(path: string, body: Record<string, never> & { path: string; text: string }): [number, object] {
    const { path: file, text } = body;
    switch (path) {
      case '/api/file/open':
        return [
          200,
          { path: file, text: this.files.get(file), hash: this.files.get(file), draft: this.drafts.get(file) ?? null },
        ];
      case '/api/file/save': {
        const now = this.files.get(file) ?? '';
        if (now !== body.based_on)
          return [409, { error: { code: 'Conflict', message: 'changed', arguments: { hash: now, text: now } } }];
        this.files.set(file, text);
        this.drafts.delete(file);
        return [200, { hash: text }];
      }
      case '/api/file/autosave':
        this.drafts.set(file, { text, based_on: body.based_on });
        return [200, {}];
      case '/api/file/discard':
        this.drafts.delete(file);
        return [200, {}];
      case '/api/document/open':
        return [200, { model: modelOf(text) }];
      case '/api/document/edit': {
        const made = (body.operations as Operation[]).reduce(edited, text);
        return [200, { text: made, model: modelOf(made), ids: [] }];
      }
      default:
        return [404, { error: { code: 'UnknownPath', message: path, arguments: {} } }];
    }
  }
}
