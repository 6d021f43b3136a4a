import './theme/colours.css';
import './theme/base.css';
import './theme/shell.css';
import './theme/drawing.css';
import './theme/world.css';
import { createRoot } from 'react-dom/client';
import { Shell } from './app/shell';
import { listenToKeys } from './commands/keys';
import { startAutosave } from './document/autosave';
import { connect } from './run/session';
import { reword, useDocument } from './state/document';
import { loadKinds } from './state/kinds';
import { complain, toast } from './state/workbench';
import { text } from './text/text';
import { applySettings, useSettings } from './theme/settings';

applySettings();
listenToKeys();
startAutosave(() => toast(text().save.autosave_failed, [], 'bad'));
useSettings.subscribe((now, before) => {
  if (now.language !== before.language) reword().catch(complain);
});

// Edits that wait for a server that is away are in this page only.
addEventListener('beforeunload', (event) => {
  if (useDocument.getState().busy > 0) event.preventDefault();
});

const root = document.getElementById('studio');
if (root) {
  loadKinds()
    .catch(complain)
    .finally(() => {
      createRoot(root).render(<Shell />);
      connect();
    });
}
