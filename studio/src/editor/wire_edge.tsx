import { BaseEdge, EdgeLabelRenderer, type EdgeProps, getBezierPath } from '@xyflow/react';
import { memo, useCallback } from 'react';
import { useDocument } from '../state/document';
import { watchValue } from '../state/live_values';
import { isOfDrawing, useRun } from '../state/run';
import type { WireEdge } from './graph';
import { showSparkline } from './sparkline';

const kLabelStep = 17;

/** The value that runs along a wire, written by live_values beside React, at the end where it arrives: ports are a row
 *  apart there, so that labels do not cover each other. */
function Value({ x, y, data }: { x: number; y: number; data: NonNullable<WireEdge['data']> }) {
  const { signals, elements, unit } = data;
  const attach = useCallback(
    (element: HTMLButtonElement | null) => (element ? watchValue(element, { signals, elements, unit }) : undefined),
    [signals, elements, unit],
  );
  const place = `translate(-100%, -50%) translate(${x - 14}px, ${y + data.index * kLabelStep}px)`;
  return (
    <EdgeLabelRenderer>
      <button
        type="button"
        ref={attach}
        className="wire-value nodrag nopan"
        tabIndex={-1}
        style={{ transform: place }}
        onMouseEnter={(event) => showSparkline(event.currentTarget, { signals, elements, unit })}
        onMouseLeave={() => showSparkline(null)}
      />
    </EdgeLabelRenderer>
  );
}

function Wire(props: EdgeProps<WireEdge>) {
  const { data, sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition, selected } = props;
  const file = useDocument((state) => state.path);
  const live = useRun((state) => state.showing && isOfDrawing(state, file));
  const [path] = getBezierPath({ sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition });
  if (!data) return null;
  const look = `wire role-${data.role} ${data.wire.previous ? 'previous' : ''} ${data.wire.ok ? '' : 'bad'}`;
  return (
    <>
      <BaseEdge path={path} className={`${look} ${selected ? 'selected' : ''}`} interactionWidth={16} />
      {live && <Value x={targetX} y={targetY} data={data} />}
    </>
  );
}

export const WireLine = memo(Wire);
