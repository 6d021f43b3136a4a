import { type Connection, type FinalConnectionState, useReactFlow } from '@xyflow/react';
import { useCallback, useRef } from 'react';
import { openDialog, toast } from '../state/workbench';
import { useText } from '../text/text';
import type { WireEdge } from './graph';
import { connectWire, Offer } from './wiring';

function wireText(source: string | null, handle: string | null | undefined): string {
  const output = (handle ?? '').replace(/^o:/, '');
  return output === '' ? (source ?? '') : `${source}.${output}`;
}

/** The wire in the hand: what it fits is known from when it is taken up. */
export function useWiring() {
  const text = useText();
  const flow = useReactFlow();
  const offer = useRef<Offer | null>(null);
  const start = useCallback((_: unknown, { nodeId, handleId, handleType }: Record<string, string | null>) => {
    offer.current = handleType === 'source' ? new Offer(wireText(nodeId, handleId)) : null;
  }, []);
  const valid = useCallback(({ target, targetHandle }: Connection | WireEdge) => {
    return offer.current?.allows(target, (targetHandle ?? '').slice(2)) ?? true;
  }, []);
  const connect = useCallback(({ source, sourceHandle, target, targetHandle }: Connection) => {
    void connectWire(wireText(source, sourceHandle), target, (targetHandle ?? '').slice(2));
  }, []);
  const end = useCallback(
    (event: MouseEvent | TouchEvent, state: FinalConnectionState) => {
      const taken = offer.current;
      offer.current = null;
      if (!taken || state.isValid) return;
      if (state.toHandle) {
        const [id, port] = [state.toHandle.nodeId, (state.toHandle.id ?? '').slice(2)];
        toast(`${text.connect.refused_toast}: ${taken.from} → ${id}.${port}`, taken.reasons(id, port), 'bad');
      } else if (!state.toNode) {
        const at = 'clientX' in event ? event : event.changedTouches[0];
        const { x, y } = flow.screenToFlowPosition({ x: at.clientX, y: at.clientY });
        openDialog({ kind: 'add', from: taken.from, at: [Math.round(x), Math.round(y)] });
      }
    },
    [flow, text],
  );
  return { start, valid, connect, end };
}
