import type { KeyboardEvent } from 'react';
import type { Component, Model } from '../api/types';
import { current, edit, select, useDocument } from '../state/document';
import { complain, say } from '../state/workbench';
import { text } from '../text/text';
import { places, reveal } from './canvas_handle';
import type { Point } from './placing';

const kNudge = 10;

const kArrows: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

function sources(component: Component): string[] {
  return component.inputs.flatMap((input) => input.wires.map((wire) => wire.from));
}

/** The component one comes to from another: left and right along wires, up and down among those that share an end of
 *  a wire with it, else through the file. */
export function neighbour(model: Model, from: string, [dx, dy]: Point): string | undefined {
  const at = model.components.findIndex((component) => component.id === from);
  if (at < 0) return model.components[0]?.id;
  if (dx < 0) return sources(model.components[at])[0];
  if (dx > 0) return model.components.find((component) => sources(component).includes(from))?.id;
  return model.components[at + dy]?.id;
}

function nudge([dx, dy]: Point): void {
  const moved = [...places(useDocument.getState().selection)].map(([id, [x, y]]): [string, Point] => [
    id,
    [Math.round(x) + dx * kNudge, Math.round(y) + dy * kNudge],
  ]);
  if (moved.length === 0) return;
  edit([{ op: 'move', positions: Object.fromEntries(moved) }], { merge: `nudge ${moved.map(([id]) => id)}` }).catch(
    complain,
  );
}

function walk(arrow: Point): void {
  const model = current()?.model;
  if (!model) return;
  const next = neighbour(model, useDocument.getState().selection.at(-1) ?? '', arrow);
  if (next === undefined) return;
  select([next]);
  reveal(next);
  say(text().shell.selected(next));
}

/** Arrows walk along the wires; with Alt they move what is selected; Escape selects nothing. */
export function canvasKey(event: KeyboardEvent): void {
  if (event.key === 'Escape') select([]);
  const arrow = kArrows[event.key];
  if (!arrow || event.ctrlKey || event.metaKey) return;
  event.preventDefault();
  if (event.altKey) nudge(arrow);
  else walk(arrow);
}
