import { type FormEvent, useState } from 'react';
import { api } from '../api/client';
import { openDocument } from '../state/disk';
import { chooseExperiment, filesChanged } from '../state/run';
import { closeDialog, complain, show } from '../state/workbench';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { useFiles } from './files';

const kFile = /^[A-Za-z0-9_-]+$/;

function folderOf(path: string): string {
  return path.split('/').slice(0, -1).join('/');
}

/** Has the server write an empty controller beside the robot, and opens it. */
async function create(robot: string, file: string, name: string): Promise<void> {
  const folder = folderOf(robot);
  const path = `${folder ? `${folder}/` : ''}${file}.toml`;
  const made = await api.edit({ path, text: '' }, [
    { op: 'set', id: '', key: 'format', value: 1 },
    { op: 'set', id: '', key: 'name', value: name },
    { op: 'set', id: '', key: 'robot', value: robot.split('/').at(-1) ?? '' },
  ]);
  await api.save({ path, text: made.text }, '');
  await openDocument(path);
  filesChanged();
  show('add');
  show('drawing');
  await chooseExperiment();
}

export function NewDialog() {
  const text = useText();
  const files = useFiles();
  const [file, setFile] = useState('my_controller');
  const [name, setName] = useState('');
  const [robot, setRobot] = useState('');
  const chosen = robot || files?.robots[0]?.path || '';
  const folder = folderOf(chosen);
  const bad = !kFile.test(file);
  const taken = files?.controllers.some((one) => one.path === `${folder ? `${folder}/` : ''}${file}.toml`);
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (bad || taken || !chosen) return;
    closeDialog();
    create(chosen, file, name || file).catch(complain);
  };
  return (
    <Modal title={text.new.title}>
      <form onSubmit={submit}>
        <label className="field">
          <span>{text.new.robot}</span>
          <select aria-label={text.new.robot} value={chosen} onChange={(event) => setRobot(event.target.value)}>
            {files?.robots.map((one) => (
              <option key={one.path} value={one.path}>
                {one.name} ({one.path})
              </option>
            ))}
          </select>
        </label>
        <label className="field">
          <span>{text.new.file}</span>
          <input value={file} aria-invalid={bad || taken} onChange={(event) => setFile(event.target.value)} />
        </label>
        {bad && <p className="bad">{text.new.bad_file}</p>}
        {taken && <p className="bad">{text.new.taken}</p>}
        <label className="field">
          <span>{text.new.name}</span>
          <input value={name} onChange={(event) => setName(event.target.value)} />
        </label>
        <p className="hint">{text.new.beside}</p>
        <div className="dialog-ends">
          <button type="submit" className="primary" disabled={bad || taken || !chosen}>
            {text.new.create}
          </button>
        </div>
      </form>
    </Modal>
  );
}
