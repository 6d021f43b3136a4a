import { useEffect, useState } from 'react';
import { api } from '../api/client';
import type { Files, RunFile } from '../api/types';
import { openDocument } from '../state/disk';
import { useDocument } from '../state/document';
import { openRecording } from '../state/recordings';
import { chooseExperiment, configure, useRun } from '../state/run';
import { complain, openDialog, show } from '../state/workbench';
import { useText } from '../text/text';

export async function openController(path: string): Promise<void> {
  try {
    await openDocument(path);
    show('drawing');
    await chooseExperiment();
  } catch (error) {
    complain(error);
  }
}

export function useFiles(): Files | null {
  const version = useRun((state) => state.filesVersion);
  const [files, setFiles] = useState<Files | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: read again whenever something was written
  useEffect(() => {
    api.files().then(setFiles, complain);
  }, [version]);
  return files;
}

function outcomeOf(run: RunFile, words: ReturnType<typeof useText>['files']): string {
  if (!run.finished) return words.cut;
  if (run.success === null) return words.not_judged;
  return run.success ? words.succeeded : words.failed;
}

function RunLine({ run }: { run: RunFile }) {
  const text = useText();
  const open = () => openRecording(run.path).then(() => show('world'), complain);
  return (
    <li className="run-line">
      <button type="button" aria-label={`${text.files.open_run}: ${run.path}`} onClick={open}>
        <b>{run.name || run.path}</b> <small>{text.files.seed(run.seed)}</small>
        <small className={run.success ? 'good' : ''}>{outcomeOf(run, text.files)}</small>
      </button>
      <a href={api.reportUrl(run.path)} target="_blank" rel="noreferrer" aria-label={text.files.report_of(run.path)}>
        {text.files.report}
      </a>
    </li>
  );
}

function Experiments({ files }: { files: Files }) {
  const text = useText();
  const chosen = useRun((state) => state.configuration.experiment);
  const choose = (path: string, controller: string) => {
    configure({ experiment: path, world: '', robot: '', seed: null, duration_s: null });
    if (controller && controller !== useDocument.getState().path)
      void openController(controller).then(() => configure({ experiment: path }));
    else openDialog({ kind: 'configure' });
  };
  return (
    <ul className="plain file-list">
      {files.experiments.map((one) => (
        <li key={one.path}>
          <button type="button" aria-pressed={one.path === chosen} onClick={() => choose(one.path, one.controller)}>
            <b>{one.name || one.path}</b> <small>{one.path}</small>
            {one.problems > 0 && <small className="bad">{text.files.problems(one.problems)}</small>}
          </button>
        </li>
      ))}
    </ul>
  );
}

/** What the folder has: controllers, experiments, recorded runs. */
export function FilesPane() {
  const text = useText();
  const files = useFiles();
  const path = useDocument((state) => state.path);
  if (!files) return null;
  return (
    <div className="files">
      <button type="button" className="primary" onClick={() => openDialog({ kind: 'new' })}>
        {text.commands.new}
      </button>
      <section aria-label={text.files.controllers}>
        <h2>{text.files.controllers}</h2>
        <ul className="plain file-list">
          {files.controllers.map((one) => (
            <li key={one.path}>
              <button type="button" aria-current={one.path === path} onClick={() => openController(one.path)}>
                <b>{one.name || one.path}</b> <small>{one.path}</small>
                {one.draft && <small className="bad">{text.files.draft}</small>}
              </button>
            </li>
          ))}
        </ul>
      </section>
      <section aria-label={text.files.experiments}>
        <h2>{text.files.experiments}</h2>
        <Experiments files={files} />
      </section>
      <section aria-label={text.files.runs}>
        <h2>{text.files.runs}</h2>
        <ul className="plain file-list">
          {files.runs.map((run) => (
            <RunLine key={run.path} run={run} />
          ))}
        </ul>
        {files.runs.length === 0 && <p className="hint">{text.files.none}</p>}
      </section>
    </div>
  );
}
