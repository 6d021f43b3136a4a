import { useEffect, useState } from 'react';
import { api } from '../api/client';
import type { Files } from '../api/types';
import { useFiles } from '../document/files';
import { RobotCard } from '../editor/controller_form';
import { useDocument, useModel } from '../state/document';
import { type Application, configure, useRun } from '../state/run';
import { closeDialog, complain } from '../state/workbench';
import { numberOf } from '../text/numbers';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { testLink } from './start';

type Experiment = Files['experiments'][number];
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

/** Where the robot is: simulated here, at an address, or a listed program that is started for the run. */
function ApplicationChoice({ programs, told }: { programs: Program[]; told: string }) {
  const text = useText();
  const { application, program, address } = useRun((state) => state.configuration);
  const value = application === 'program' ? `program ${program}` : application;
  const pick = (words: string) =>
    words.startsWith('program ')
      ? configure({ application: 'program', program: words.slice('program '.length) })
      : configure({ application: words as Application });
  const label = text.configure.application;
  return (
    <>
      <label className="field">
        <span>{label}</span>
        <select aria-label={label} value={value} onChange={(event) => pick(event.target.value)}>
          <option value="experiment">{`${text.configure.as_experiment} (${told})`}</option>
          <option value="simulation">{text.configure.simulation}</option>
          <option value="address">{text.configure.at_address}</option>
          {programs.map((one) => (
            <option key={one.name} value={`program ${one.name}`}>
              {one.help ? `${one.name}: ${one.help}` : one.name}
            </option>
          ))}
        </select>
      </label>
      {application === 'address' && (
        <label className="field">
          <span>{text.configure.address}</span>
          <input
            value={address}
            placeholder="tcp://127.0.0.1:7007"
            spellCheck={false}
            onChange={(event) => configure({ address: event.target.value })}
          />
          <small>{text.configure.address_hint}</small>
        </label>
      )}
    </>
  );
}

/** Has the server look at what is chosen, as a run would: nothing is moved. */
function TestConnection() {
  const text = useText();
  const { experiment, application, address } = useRun((state) => state.configuration);
  const test = useRun((state) => state.linkTest);
  const testing = test !== null && !test.done;
  const missing = !experiment || (application === 'address' && !address.trim());
  return (
    <div className="test">
      <button type="button" onClick={() => testLink().catch(complain)} disabled={testing || missing}>
        {text.configure.test}
      </button>
      <div role="status">
        {testing && <p>{text.configure.testing}</p>}
        {test?.done && (
          <p className={test.good ? 'good' : 'bad'}>{test.good ? text.configure.test_good : text.configure.test_bad}</p>
        )}
        {test && (
          <ul className="plain small-print findings">
            {test.findings.map((one) => (
              <li key={one.message} className={one.good ? '' : 'bad'}>
                {one.message}
              </li>
            ))}
          </ul>
        )}
      </div>
    </div>
  );
}

function Check({ label, checked, set }: { label: string; checked: boolean; set(checked: boolean): void }) {
  return (
    <label className="check">
      <input type="checkbox" checked={checked} onChange={(event) => set(event.target.checked)} /> {label}
    </label>
  );
}

/** What of the experiment is another for this run; what is left empty is as the experiment says. */
function Settings({ files, experiment }: { files: Files | null; experiment: Experiment | undefined }) {
  const text = useText();
  const chosen = useRun((state) => state.configuration);
  return (
    <>
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
      <Check label={text.configure.paused} checked={chosen.paused} set={(paused) => configure({ paused })} />
      <Check label={text.configure.record} checked={chosen.record} set={(record) => configure({ record })} />
    </>
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
          <ApplicationChoice
            programs={programs}
            told={experiment?.address || (experiment?.program ? text.configure.a_program : text.configure.simulation)}
          />
          <TestConnection />
          <Settings files={files} experiment={experiment} />
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
