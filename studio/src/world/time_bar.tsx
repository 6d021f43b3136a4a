import { player, usePlayer } from '../state/player';
import { useRun } from '../state/run';
import type { Timeline } from '../state/timeline';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';

const kSpeeds = [0.1, 0.5, 1, 2, 5, 10, 20];

/** Where on the slider somebody reached into the world; the list of events says what it was. */
function Marks({ timeline, first, end }: { timeline: Timeline; first: number; end: number }) {
  const span = Math.max(end - first, 1e-3);
  return timeline.interventions.map((one, i) => (
    <i
      // biome-ignore lint/suspicious/noArrayIndexKey: they are only ever added
      key={i}
      className="time-mark"
      aria-hidden="true"
      style={{ left: `calc(8px + (100% - 16px) * ${(Math.min(one.time_s, end) - first) / span})` }}
    />
  ));
}

function Slider({ timeline, t, end }: { timeline: Timeline; t: number; end: number }) {
  const text = useText();
  const first = timeline.times[0] ?? 0;
  return (
    <span className="time-line">
      <input
        type="range"
        min={first}
        max={Math.max(end, first + 1e-3)}
        step="any"
        value={t}
        aria-label={text.world.slider}
        aria-valuetext={`${t.toFixed(1)} s`}
        onChange={(event) => player.seek(Number(event.target.value))}
        onKeyDown={(event) => {
          if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
          event.preventDefault();
          event.stopPropagation();
          player.step(event.key === 'ArrowLeft' ? -1 : 1);
        }}
      />
      <Marks timeline={timeline} first={first} end={end} />
    </span>
  );
}

function Speed({ speed }: { speed: number }) {
  const text = useText();
  return (
    <label>
      <span className="for-readers">{text.world.speed}</span>
      <select
        value={speed}
        aria-label={text.world.speed}
        onChange={(event) => usePlayer.setState({ speed: Number(event.target.value) })}
      >
        {kSpeeds.map((one) => (
          <option key={one} value={one}>
            {text.run.times(`${one}`)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The time that is looked at, apart from the run's own. */
export function TimeBar() {
  const text = useText();
  const { timeline, t, end, playing, following, growing, speed } = usePlayer();
  const live = useRun((state) => state.state?.state);
  if (!timeline) return null;
  return (
    <div className="time-bar">
      <button
        type="button"
        aria-label={playing ? text.world.pause : text.world.play}
        onClick={() => player.play(!playing)}
      >
        <Icon name={playing ? 'pause' : 'play'} />
      </button>
      <Slider timeline={timeline} t={t} end={end} />
      <output className="time-now">{t.toFixed(1)} s</output>
      <Speed speed={speed} />
      {growing && (
        <button
          type="button"
          aria-pressed={following}
          title={text.world.live_hint}
          onClick={() => player.follow(!following)}
          className={live === 'running' ? 'live' : ''}
        >
          {following ? text.world.live : text.world.held}
        </button>
      )}
    </div>
  );
}
