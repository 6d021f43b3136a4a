import { type FormEvent, useState } from 'react';
import { usePlayer } from '../state/player';
import { closeDialog } from '../state/workbench';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { moverPose, putObstacle, setGoal } from './reach';

function Number2({ at, set }: { at: [string, string]; set(at: [string, string]): void }) {
  const text = useText();
  const field = (label: string, which: 0 | 1) => (
    <label className="field">
      <span>{label}</span>
      <input
        inputMode="decimal"
        value={at[which]}
        data-first={which === 0 ? true : undefined}
        onChange={(event) => set(which === 0 ? [event.target.value, at[1]] : [at[0], event.target.value])}
        onFocus={(event) => event.target.select()}
      />
    </label>
  );
  return (
    <>
      {field(text.reach.x, 0)}
      {field(text.reach.y, 1)}
    </>
  );
}

/** Both numbers, decimals with point or comma; null where they are none. */
function pointOf(at: [string, string]): [number, number] | null {
  const [x, y] = at.map((words) => (words.trim() === '' ? Number.NaN : Number(words.replace(',', '.'))));
  return Number.isFinite(x + y) ? [x, y] : null;
}

function Ends({ words, bad }: { words: string; bad: boolean }) {
  const text = useText();
  return (
    <div className="dialog-ends">
      <span role="status">{bad ? text.reach.numbers : ''}</span>
      <button type="submit" className="primary">
        {words}
      </button>
    </div>
  );
}

/** A goal by two numbers: what a click on the ground does. */
export function GoalDialog() {
  const text = useText();
  const [at, setAt] = useState<[string, string]>(['', '']);
  const [bad, setBad] = useState(false);
  const submit = (event: FormEvent) => {
    event.preventDefault();
    const point = pointOf(at);
    setBad(point === null);
    if (!point) return;
    closeDialog();
    void setGoal(point);
  };
  return (
    <Modal title={text.reach.goal_title}>
      <form onSubmit={submit}>
        <Number2 at={at} set={setAt} />
        <Ends words={text.reach.set} bad={bad} />
      </form>
    </Modal>
  );
}

/** An obstacle put elsewhere by two numbers: what dragging it does. */
export function ObstacleDialog() {
  const text = useText();
  const { timeline } = usePlayer.getState();
  const movers = timeline?.scene?.movers ?? [];
  const placeOf = (id: string): [string, string] => {
    const shape = movers.find((one) => one.id === id);
    const [x, y] = timeline && shape ? moverPose(timeline, shape, timeline.end) : [0, 0];
    return [x.toFixed(2), y.toFixed(2)];
  };
  const [mover, setMover] = useState(movers[0]?.id ?? '');
  const [at, setAt] = useState(() => placeOf(mover));
  const [bad, setBad] = useState(false);
  const submit = (event: FormEvent) => {
    event.preventDefault();
    const point = pointOf(at);
    setBad(point === null);
    if (!point) return;
    closeDialog();
    void putObstacle(mover, point);
  };
  const choose = (id: string) => {
    setMover(id);
    setAt(placeOf(id));
  };
  return (
    <Modal title={text.reach.obstacle_title}>
      <form onSubmit={submit}>
        <label className="field">
          <span>{text.reach.obstacle}</span>
          <select value={mover} onChange={(event) => choose(event.target.value)}>
            {movers.map((one) => (
              <option key={one.id} value={one.id}>
                {one.label || one.id}
              </option>
            ))}
          </select>
        </label>
        <Number2 at={at} set={setAt} />
        <Ends words={text.reach.put} bad={bad} />
      </form>
    </Modal>
  );
}
