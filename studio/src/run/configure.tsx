import { useEffect, useState } from 'react';
import { api } from '../api/client';
import { useDocument, useModel } from '../document/document';
import { useFiles } from '../document/files';
import { RobotCard } from '../editor/controller_form';
import { numberOf } from '../editor/field';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { closeDialog, complain } from '../ui/workbench';
import { configure, useRun } from './run';

type Program = { name: string; help: string };

function usePrograms(): Program[] {
  const [programs, setPrograms] = useState<Program[]>([]);
  useEffect(() => {
    api.programs().then((answer) => setPrograms(answer.programs), complain);
  }, []);
  return programs;
}

interface ChoiceProps {
  label: string;
  value: string;
  options: { path: string; name: string }[];
  none?: string;
  pick(value: string): void;
}

function Choice({ label, value, options, none, pick }: ChoiceProps) {
  return (
    <label className="field">
      <span>{label}</span>
      <select aria-label={label} value={value} onChange={(event) => pick(event.target.value)}>
        {none !== undefined && <option value="">{none}</option>}
        {options.map((one) => (
          <option key={one.path} value={one.path}>
            {one.name && one.name !== one.path ? `${one.name} (${one.path})` : one.path}
          </option>
        ))}
      </select>
    </label>
  );
}

function Amount({
  label,
  value,
  usual,
  set,
}: {
  label: string;
  value: number | null;
  usual: number | undefined;
  set(value: number | null): void;
}) {
  const [words, setWords] = useState(value === null ? '' : `${value}`);
  return (
    <label className="field">
      <span>{label}</span>
      <input
        inputMode="decimal"
        value={words}
        placeholder={usual === undefined ? '' : `${usual}`}
        onChange={(event) => {
          setWords(event.target.value);
          set(numberOf(event.target.value));
        }}
      />
    </label>
  );
}

/** Asks the server now whether what is chosen can be started. */
function TestConnection({ programs }: { programs: Program[] }) {
  const text = useText();
  const { program, experiment } = useRun((state) => state.configuration);
  const [answer, setAnswer] = useState('');
  const test = async () => {
    setAnswer('');
    try {
      const [listed, files] = await Promise.all([api.programs(), api.files()]);
      const chosen = files.experiments.find((one) => one.path === experiment);
      if (program)
        setAnswer(
          listed.programs.some((one) => one.name === program)
            ? text.configure.program_ok
            : text.errors.ProgramNotListed,
        );
      else setAnswer(chosen && chosen.problems === 0 ? text.configure.simulation_ok : text.configure.simulation_bad);
    } catch {
      setAnswer(text.configure.unreachable);
    }
  };
  return (
    <div className="field">
      <button type="button" onClick={test} disabled={programs.length === 0 && !experiment}>
        {text.configure.test}
      </button>
      <span role="status">{answer}</span>
    </div>
  );
}

/** The paper's "Configure": which application the controller is run with. */
export function ConfigureDialog() {
  const text = useText();
  const files = useFiles();
  const programs = usePrograms();
  const model = useModel();
  const path = useDocument((state) => state.path);
  const chosen = useRun((state) => state.configuration);
  const experiment = files?.experiments.find((one) => one.path === chosen.experiment);
  return (
    <Modal title={text.configure.title} wide>
      <div className="columns">
        <div>
          {path && <p className="hint">{text.configure.drawn(path)}</p>}
          <Choice
            label={text.configure.experiment}
            value={chosen.experiment}
            options={files?.experiments ?? []}
            none={chosen.experiment ? undefined : text.files.none}
            pick={(value) => configure({ experiment: value, world: '', robot: '' })}
          />
          {files?.experiments.length === 0 && <p className="bad">{text.configure.no_experiment}</p>}
          <Choice
            label={text.configure.application}
            value={chosen.program}
            options={programs.map((one) => ({ path: one.name, name: one.help }))}
            none={text.configure.simulation}
            pick={(program) => configure({ program })}
          />
          <TestConnection programs={programs} />
          <Choice
            label={text.configure.world}
            value={chosen.world}
            options={files?.worlds ?? []}
            none={text.configure.as_experiment}
            pick={(world) => configure({ world })}
          />
          <Choice
            label={text.configure.robot}
            value={chosen.robot}
            options={files?.robots ?? []}
            none={text.configure.as_experiment}
            pick={(robot) => configure({ robot })}
          />
          <Amount
            label={text.configure.seed}
            value={chosen.seed}
            usual={experiment?.seed}
            set={(seed) => configure({ seed })}
          />
          <Amount
            label={text.configure.duration}
            value={chosen.duration_s}
            usual={experiment?.duration_s}
            set={(duration_s) => configure({ duration_s })}
          />
          <label className="check">
            <input
              type="checkbox"
              checked={chosen.paused}
              onChange={(event) => configure({ paused: event.target.checked })}
            />{' '}
            {text.configure.paused}
          </label>
          <label className="check">
            <input
              type="checkbox"
              checked={chosen.record}
              onChange={(event) => configure({ record: event.target.checked })}
            />{' '}
            {text.configure.record}
          </label>
        </div>
        <div>{model && <RobotCard robot={model.robot} />}</div>
      </div>
      <div className="dialog-ends">
        <button type="button" className="primary" onClick={closeDialog}>
          {text.configure.ok}
        </button>
      </div>
    </Modal>
  );
}
