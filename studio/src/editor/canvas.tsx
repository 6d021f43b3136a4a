import '@xyflow/react/dist/base.css';
import { Background, ConnectionMode, MiniMap, ReactFlow, ReactFlowProvider, useReactFlow } from '@xyflow/react';
import { type DragEvent, useEffect, useMemo, useRef } from 'react';
import { current, edit, useDocument } from '../state/document';
import { complain, openDialog, say, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { add, type Offered } from './adding';
import { setCanvas } from './canvas_handle';
import { ComponentBox } from './component_node';
import { useDrawn } from './drawn';
import type { ComponentNode, WireEdge } from './graph';
import { canvasKey } from './keyboard';
import type { Point } from './placing';
import { WireLine } from './wire_edge';
import { useWiring } from './wire_in_hand';

/** What never changes. Keys are ours: see canvasKey and the commands. */
const kLook = {
  nodeTypes: { component: ComponentBox },
  edgeTypes: { wire: WireLine },
  connectionMode: ConnectionMode.Strict,
  connectionRadius: 18,
  minZoom: 0.02,
  maxZoom: 2.5,
  nodesFocusable: false,
  edgesFocusable: false,
  disableKeyboardA11y: true,
  deleteKeyCode: null,
  multiSelectionKeyCode: ['Shift', 'Control', 'Meta'],
  elevateNodesOnSelect: false,
};
/** Above this only boxes in sight are drawn. */
const kManyBoxes = 300;
const kOtherWidth = 0.25;
export const kDragType = 'application/x-ganglion-component';

async function moved(_: unknown, __: unknown, dragged: ComponentNode[]): Promise<void> {
  const positions = Object.fromEntries(
    dragged
      .filter((node) => node.data.component.editable || node.id !== '')
      .map((node): [string, Point] => [node.id, [Math.round(node.position.x), Math.round(node.position.y)]]),
  );
  await edit([{ op: 'move', positions }]).catch(complain);
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

/** What is let go of over the drawing is added there. */
function useDrop() {
  const flow = useReactFlow();
  return (event: DragEvent) => {
    const dragged = event.dataTransfer.getData(kDragType);
    if (!dragged) return;
    event.preventDefault();
    const { x, y } = flow.screenToFlowPosition({ x: event.clientX, y: event.clientY });
    add(JSON.parse(dragged) as Offered, [Math.round(x / 10) * 10, Math.round(y / 10) * 10]).catch(complain);
  };
}

function useLabels() {
  const text = useText();
  return useMemo(
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
}

function Tools() {
  const text = useText();
  const flow = useReactFlow();
  return (
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
  );
}

function Boxes({ drawn }: { drawn: ReturnType<typeof useDrawn> }) {
  const wiring = useWiring();
  const labels = useLabels();
  const minimap = useWorkbench((state) => state.minimap);
  return (
    <ReactFlow
      {...kLook}
      nodes={drawn.nodes}
      edges={drawn.edges}
      onNodesChange={drawn.changeNodes}
      onEdgesChange={drawn.changeEdges}
      onNodeDragStop={moved}
      onSelectionDragStop={(event, dragged) => moved(event, null, dragged)}
      onConnectStart={wiring.start as never}
      onConnect={wiring.connect}
      onConnectEnd={wiring.end}
      isValidConnection={wiring.valid}
      onNodeDoubleClick={(_, node) => openDialog({ kind: 'rename', id: node.id })}
      onlyRenderVisibleElements={drawn.nodes.length > kManyBoxes}
      ariaLabelConfig={labels}
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
  );
}

function Flow() {
  const text = useText();
  const flow = useReactFlow<ComponentNode, WireEdge>();
  const drawn = useDrawn();
  const drop = useDrop();
  const path = useDocument((state) => state.path);
  const frame = useRef<HTMLDivElement>(null);
  const empty = drawn.nodes.length === 0;
  useEffect(() => setCanvas(flow, () => frame.current), [flow]);
  useFitting(frame, path, !empty);
  return (
    <div
      role="application"
      className="canvas"
      ref={frame}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: arrows walk the drawing along its wires
      tabIndex={0}
      aria-label={text.panes.drawing}
      onKeyDown={canvasKey}
      onDragOver={(event) => event.preventDefault()}
      onDrop={drop}
    >
      <Boxes drawn={drawn} />
      <Tools />
      {current() && empty && <Empty />}
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
