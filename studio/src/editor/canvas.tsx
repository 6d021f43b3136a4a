import '@xyflow/react/dist/base.css';
import {
  Background,
  type Connection,
  ConnectionMode,
  type FinalConnectionState,
  MiniMap,
  ReactFlow,
  ReactFlowProvider,
  useReactFlow,
} from '@xyflow/react';
import { type DragEvent, useCallback, useEffect, useMemo, useRef } from 'react';
import { current, edit, useDocument } from '../state/document';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { complain, openDialog, say, toast, useWorkbench } from '../state/workbench';
import { add, type Offered } from './adding';
import { setCanvas } from './canvas_handle';
import { ComponentBox } from './component_node';
import { useDrawn } from './drawn';
import type { ComponentNode, WireEdge } from './graph';
import { canvasKey } from './keyboard';
import type { Point } from './placing';
import { WireLine } from './wire_edge';
import { connectWire, Offer } from './wiring';

const kNodeTypes = { component: ComponentBox };
const kEdgeTypes = { wire: WireLine };
/** Above this only boxes in sight are drawn. */
const kManyBoxes = 300;
const kOtherWidth = 0.25;
export const kDragType = 'application/x-ganglion-component';

function wireText(source: string | null, handle: string | null | undefined): string {
  const output = (handle ?? '').replace(/^o:/, '');
  return output === '' ? (source ?? '') : `${source}.${output}`;
}

async function moved(_: unknown, __: unknown, dragged: ComponentNode[]): Promise<void> {
  const positions = Object.fromEntries(
    dragged
      .filter((node) => node.data.component.editable || node.id !== '')
      .map((node): [string, Point] => [node.id, [Math.round(node.position.x), Math.round(node.position.y)]]),
  );
  await edit([{ op: 'move', positions }]).catch(complain);
}

/** The wire in the hand: what it fits is known from when it is taken up. */
function useWiring() {
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

/** Shows all of a file's drawing once it is there and has a size, and again when it gets quite another width. */
function useFitting(frame: { current: HTMLElement | null }, path: string, drawn: boolean) {
  const flow = useReactFlow();
  const fitted = useRef({ path: '', width: 0 });
  useEffect(() => {
    const element = frame.current;
    if (!element) return;
    const look = () => {
      const width = element.clientWidth;
      // What is added first to an empty drawing stays where it is put.
      if (current()?.model.components.length === 0) fitted.current = { path, width };
      const same = fitted.current.path === path && Math.abs(width - fitted.current.width) < kOtherWidth * width;
      if (!drawn || same || width === 0) return;
      fitted.current = { path, width };
      // Only after the next frame does the drawing itself know of its width.
      requestAnimationFrame(() => requestAnimationFrame(() => void flow.fitView({ padding: 0.06, maxZoom: 1 })));
    };
    const sized = new ResizeObserver(look);
    sized.observe(element);
    look();
    return () => sized.disconnect();
  }, [flow, frame, path, drawn]);
}

function Flow() {
  const text = useText();
  const flow = useReactFlow<ComponentNode, WireEdge>();
  const { nodes, edges, changeNodes, changeEdges } = useDrawn();
  const wiring = useWiring();
  const minimap = useWorkbench((state) => state.minimap);
  const path = useDocument((state) => state.path);
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => setCanvas(flow, () => frame.current), [flow]);
  useFitting(frame, path, nodes.length > 0);
  const drop = (event: DragEvent) => {
    const dragged = event.dataTransfer.getData(kDragType);
    if (!dragged) return;
    event.preventDefault();
    const { x, y } = flow.screenToFlowPosition({ x: event.clientX, y: event.clientY });
    add(JSON.parse(dragged) as Offered, [Math.round(x / 10) * 10, Math.round(y / 10) * 10]).catch(complain);
  };
  const aria = useMemo(
    () => ({
      'minimap.ariaLabel': text.commands.minimap,
      'node.a11yDescription.default': text.shell.arrows_help,
      'node.a11yDescription.keyboardDisabled': text.shell.arrows_help,
      'edge.a11yDescription.default': text.shell.arrows_help,
      'handle.ariaLabel': text.commands.connect,
      'controls.ariaLabel': text.menus.view,
    }),
    [text],
  );
  return (
    <div
      role="application"
      className="canvas"
      ref={frame}
      // arrows walk the drawing along its wires
      tabIndex={0}
      aria-label={text.panes.drawing}
      onKeyDown={canvasKey}
      onDragOver={(event) => event.preventDefault()}
      onDrop={drop}
    >
      <ReactFlow
        nodes={nodes}
        edges={edges}
        nodeTypes={kNodeTypes}
        edgeTypes={kEdgeTypes}
        onNodesChange={changeNodes}
        onEdgesChange={changeEdges}
        onNodeDragStop={moved}
        onSelectionDragStop={(event, dragged) => moved(event, null, dragged)}
        onConnectStart={wiring.start as never}
        onConnect={wiring.connect}
        onConnectEnd={wiring.end}
        isValidConnection={wiring.valid}
        connectionMode={ConnectionMode.Strict}
        connectionRadius={18}
        onNodeDoubleClick={(_, node) => openDialog({ kind: 'rename', id: node.id })}
        onlyRenderVisibleElements={nodes.length > kManyBoxes}
        minZoom={0.02}
        maxZoom={2.5}
        nodesFocusable={false}
        edgesFocusable={false}
        disableKeyboardA11y
        deleteKeyCode={null}
        multiSelectionKeyCode={['Shift', 'Control', 'Meta']}
        ariaLabelConfig={aria}
        elevateNodesOnSelect={false}
      >
        <Background gap={20} size={1} />
        {minimap && (
          <MiniMap
            pannable
            zoomable
            nodeClassName={(node) => `mini class-${(node as ComponentNode).data.component.class}`}
          />
        )}
      </ReactFlow>
      <div className="canvas-tools">
        <button type="button" aria-label={text.shell.zoom_in} onClick={() => void flow.zoomIn()}>
          <Icon name="plus" />
        </button>
        <button type="button" aria-label={text.shell.zoom_out} onClick={() => void flow.zoomOut()}>
          <Icon name="minus" />
        </button>
        <button
          type="button"
          aria-label={text.shell.fit}
          onClick={() => void flow.fitView({ padding: 0.06, maxZoom: 1 })}
        >
          <Icon name="fit" />
        </button>
      </div>
      {current() && nodes.length === 0 && <Empty />}
    </div>
  );
}

function Empty() {
  const text = useText();
  useEffect(() => say(text.shell.empty), [text]);
  return (
    <div className="canvas-empty">
      <p>{text.shell.empty}</p>
      <button type="button" onClick={() => openDialog({ kind: 'add' })}>
        {text.commands.add}
      </button>
    </div>
  );
}

export function Canvas() {
  return (
    <ReactFlowProvider>
      <Flow />
    </ReactFlowProvider>
  );
}
