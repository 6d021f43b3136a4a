import { applyEdgeChanges, applyNodeChanges, type EdgeChange, type NodeChange } from '@xyflow/react';
import { useCallback, useState } from 'react';
import type { Model } from '../api/types';
import { select, useDocument, useModel } from '../state/document';
import { useWorkbench } from '../state/workbench';
import { type ComponentNode, edgesOf, nodesOf, type WireEdge } from './graph';
import type { Point } from './placing';

/** Boxes and wires as drawn now, and what they were drawn from. */
interface Drawn {
  path: string;
  model: Model | undefined;
  selection: readonly string[];
  expanded: ReadonlySet<string>;
  nodes: ComponentNode[];
  edges: WireEdge[];
  places: Map<string, Point>;
}

const kBlank: Drawn = {
  path: '',
  model: undefined,
  selection: [],
  expanded: new Set(),
  nodes: [],
  edges: [],
  places: new Map(),
};

/** Another file starts with places of its own. */
function follow(before: Drawn, now: Pick<Drawn, 'path' | 'model' | 'selection' | 'expanded'>): Drawn {
  const { nodes, edges, places } = now.path === before.path ? before : { ...kBlank, places: new Map() };
  const { model } = now;
  if (!model) return { ...now, nodes: [], edges: [], places };
  const drawnNodes = nodesOf(model, now.expanded, now.selection, nodes, places);
  return { ...now, nodes: drawnNodes, edges: model === before.model ? edges : edgesOf(model, edges), places };
}

/** They follow the model, and the hand while it drags. */
export function useDrawn() {
  const model = useModel();
  const path = useDocument((state) => state.path);
  const selection = useDocument((state) => state.selection);
  const expanded = useWorkbench((state) => state.expanded);
  const [drawn, setDrawn] = useState(kBlank);
  let shown = drawn;
  // While rendering, not in an effect: one frame less until a change is seen.
  if (drawn.model !== model || drawn.path !== path || drawn.selection !== selection || drawn.expanded !== expanded) {
    shown = follow(drawn, { path, model, selection, expanded });
    setDrawn(shown);
  }
  const changeNodes = useCallback((changes: NodeChange<ComponentNode>[]) => {
    setDrawn((before) => ({ ...before, nodes: applyNodeChanges(changes, before.nodes) }));
    const picks = changes.filter((one) => one.type === 'select');
    if (picks.length === 0) return;
    const picked = new Set(useDocument.getState().selection);
    for (const one of picks) {
      if (one.selected) picked.add(one.id);
      else picked.delete(one.id);
    }
    select([...picked]);
  }, []);
  const changeEdges = useCallback(
    (changes: EdgeChange<WireEdge>[]) =>
      setDrawn((before) => ({ ...before, edges: applyEdgeChanges(changes, before.edges) })),
    [],
  );
  return { nodes: shown.nodes, edges: shown.edges, changeNodes, changeEdges };
}
