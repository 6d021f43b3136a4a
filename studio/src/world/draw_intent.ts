import type { Timeline } from '../state/timeline';
import { trace } from './draw_ground';
import { type Intent, moverPose } from './reach';
import type { View, WorldColours } from './view';

/** What a pointer is about to do: the cell that would be the goal, the obstacle on its way. */
export function drawIntent(view: View, timeline: Timeline, intent: Intent, colours: WorldColours): void {
  if (intent.cell) {
    const [x, y, side] = intent.cell;
    const corners: [number, number][] = [
      [x, y],
      [x + side, y],
      [x + side, y + side],
      [x, y + side],
    ];
    view.polygon(corners, true);
    view.context.globalAlpha = 0.25;
    view.fill(colours.goalmark);
    view.context.globalAlpha = 1;
    view.stroke(colours.line, 1.5, [4, 3]);
  }
  const { ghost } = intent;
  const shape = ghost && timeline.scene?.movers.find((one) => one.id === ghost.mover);
  if (!ghost || !shape) return;
  const [, , yaw] = moverPose(timeline, shape, timeline.end);
  trace(view, { ...shape, closed: true }, [ghost.at[0], ghost.at[1], yaw]);
  view.context.globalAlpha = 0.5;
  view.fill(colours.mover);
  view.context.globalAlpha = 1;
  view.stroke(colours.line, 2, [5, 3]);
}
