import { lazy, Suspense } from 'react';
import { CommandButton } from '../commands/command_button';
import { Menu } from '../commands/menu';
import { Banners } from '../document/banners';
import { FilesPane } from '../document/files';
import { HistoryPane } from '../document/history_pane';
import { Canvas } from '../editor/canvas';
import { Inspector } from '../editor/inspector';
import { Palette } from '../editor/palette';
import { Problems } from '../editor/problems';
import { TableView } from '../editor/table_view';
import { Outcome } from '../run/outcome';
import { isDirty, useDocument, useModel } from '../state/document';
import { type Pane, show, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Toasts } from '../ui/toasts';
import { World } from '../world/world';
import { Dialogs } from './dialogs';
import { RunBar } from './run_bar';

const Tour = lazy(() => import('../tour/tour').then((module) => ({ default: module.Tour })));

const kPhonePanes: Pane[] = ['files', 'add', 'drawing', 'table', 'properties', 'world', 'problems', 'history'];

function Head() {
  const text = useText();
  const model = useModel();
  const path = useDocument((state) => state.path);
  const dirty = useDocument((state) => isDirty(state));
  const canUndo = useDocument((state) => state.now > 0);
  const canRedo = useDocument((state) => state.now + 1 < state.steps.length);
  return (
    <header className="head">
      <Menu />
      <h1>
        <span className="head-name">{model ? model.name || path : text.studio}</span>
        {model && (
          <small title={path} className={dirty ? 'dirty' : ''}>
            {dirty ? text.save.dirty : text.save.clean}
          </small>
        )}
      </h1>
      <CommandButton name="undo" icon="undo" enabled={canUndo} />
      <CommandButton name="redo" icon="redo" enabled={canRedo} />
      <CommandButton name="save" icon="save" enabled={model !== undefined && dirty} />
      <RunBar />
    </header>
  );
}

function Tabs({ panes, chosen }: { panes: Pane[]; chosen: Pane }) {
  const text = useText();
  return (
    <nav className="tabs" aria-label={panes.map((pane) => text.panes[pane]).join(', ')}>
      {panes.map((pane) => (
        <button key={pane} type="button" aria-current={pane === chosen ? 'page' : undefined} onClick={() => show(pane)}>
          {text.panes[pane]}
        </button>
      ))}
    </nav>
  );
}

function Left() {
  const left = useWorkbench((state) => state.left);
  return (
    <div className="left">
      <Tabs panes={['files', 'add', 'history']} chosen={left} />
      <div className="scroll">
        {left === 'files' && <FilesPane />}
        {left === 'add' && <Palette />}
        {left === 'history' && <HistoryPane />}
      </div>
    </div>
  );
}

function Centre() {
  const centre = useWorkbench((state) => state.centre);
  const split = useWorkbench((state) => state.split);
  return (
    <div className={`centre ${split ? 'split' : ''}`} id="centre">
      <Tabs panes={['drawing', 'table', 'world']} chosen={centre} />
      <Banners />
      <Outcome />
      <div className="centre-body">
        {centre === 'table' ? <TableView /> : (centre === 'drawing' || split) && <Canvas />}
        {(centre === 'world' || split) && <World />}
      </div>
      <Problems />
    </div>
  );
}

/** What screen readers are told. By itself: the whole page need not be gone through for it. */
function Said() {
  const said = useWorkbench((state) => state.said);
  return (
    <div className="for-readers" role="status" aria-live="polite">
      {said}
    </div>
  );
}

/** The whole page. Below 900 px one pane is shown at a time, chosen below. */
export function Shell() {
  const text = useText();
  const pane = useWorkbench((state) => state.pane);
  const tour = useWorkbench((state) => state.tour);
  return (
    <main className={`shell pane-${pane}`}>
      <a className="skip" href="#centre">
        {text.shell.skip}
      </a>
      <Head />
      <Left />
      <Centre />
      <section className="right" aria-label={text.panes.properties}>
        <div className="scroll">
          <Inspector />
        </div>
      </section>
      <div className="phone-tabs">
        <Tabs panes={kPhonePanes} chosen={pane} />
      </div>
      {tour !== null && (
        <Suspense>
          <Tour />
        </Suspense>
      )}
      <Dialogs />
      <Toasts />
      <Said />
    </main>
  );
}
