// Reaching into a running world: a goal set, an obstacle put elsewhere. The server says whether that can be.
import { api } from '../api/client';
import type { InterventionEvent, Shape } from '../api/types';
import { player, usePlayer } from '../state/player';
import { useRun } from '../state/run';
import type { Timeline } from '../state/timeline';
import { complain, say, toast } from '../state/workbench';
import type { Dictionary } from '../text/en';
import { text } from '../text/text';

type Point = [number, number];

/** What a pointer is about to do, drawn over the world until it is done. */
export interface Intent {
  /** Lower left corner and side of the cell that would be the goal. */
  cell: [number, number, number] | null;
  /** An obstacle on its way, with its centre at that point. */
  ghost: { mover: string; at: Point } | null;
}

/** The newest of a run that this page steers is looked at: only then is what is seen what can be reached. */
export function mayReach(): boolean {
  const { state, live, recording } = useRun.getState();
  const { timeline, following } = usePlayer.getState();
  const going = state !== null && ['armed', 'running', 'paused'].includes(state.state) && !state.attached;
  return going && recording === null && live !== null && live === timeline && following;
}

/** The side of the cells that a goal set by hand can be; null where nobody takes one. */
export function goalCell_m(timeline: Timeline | null, robot: number): number | null {
  return timeline?.info?.robots[robot]?.goal_cell_m ?? null;
}

export function maySetGoal(): boolean {
  const { timeline, robot } = usePlayer.getState();
  return mayReach() && goalCell_m(timeline, robot) !== null;
}

export function mayPutObstacle(): boolean {
  return mayReach() && (usePlayer.getState().timeline?.scene?.movers.length ?? 0) > 0;
}

/** The cell that holds a point, as Intent has it. */
export function cellAt([x, y]: Point, cell_m: number): [number, number, number] {
  return [Math.floor(x / cell_m) * cell_m, Math.floor(y / cell_m) * cell_m, cell_m];
}

/** Where an obstacle stands at a time: x, y, yaw. */
export function moverPose(timeline: Timeline, shape: Shape, t: number): [number, number, number] {
  const now = timeline.movers.at(t)?.find((mover) => mover.id === shape.id);
  return now ? [now.x_m, now.y_m, now.yaw_rad] : (shape.pose ?? [0, 0, 0]);
}

/** Whether a shape holds a point of its own frame, or comes nearer to it than `reach`. */
function holds(shape: Shape, [x, y]: Point, reach: number): boolean {
  if (!shape.points) return Math.hypot(x, y) <= (shape.radius ?? 0) + reach;
  const xs = shape.points.map((point) => point[0]);
  const ys = shape.points.map((point) => point[1]);
  const within = (value: number, all: number[]) =>
    value >= Math.min(...all) - reach && value <= Math.max(...all) + reach;
  return within(x, xs) && within(y, ys);
}

/** The obstacle that moves and is drawn last at a point; `reach_m` is how far beside it still counts. */
export function moverAt(timeline: Timeline, t: number, [x, y]: Point, reach_m = 0): Shape | undefined {
  return timeline.scene?.movers.findLast((shape) => {
    const [px, py, yaw] = moverPose(timeline, shape, t);
    const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
    return holds(shape, [c * (x - px) + s * (y - py), -s * (x - px) + c * (y - py)], reach_m);
  });
}

const metres = (value: number) => value.toFixed(2);

/** Asks for a goal there; what is refused is told with the reason. */
export async function setGoal([x, y]: Point): Promise<void> {
  try {
    const reached = await api.setGoal(usePlayer.getState().robot, x, y);
    const words = text().reach;
    const done = words.goal_set(metres(reached.x_m), metres(reached.y_m));
    if (reached.reachable) say(done);
    else toast(done, [words.goal_sealed]);
  } catch (error) {
    complain(error);
  }
  player.wake();
}

export async function putObstacle(mover: string, [x, y]: Point): Promise<void> {
  try {
    await api.putObstacle(mover, x, y);
    say(text().reach.obstacle_put(mover, metres(x), metres(y)));
  } catch (error) {
    complain(error);
  }
  player.wake();
}

export function interventionWords(one: InterventionEvent, words: Dictionary): string {
  const [x, y] = [metres(one.x_m), metres(one.y_m)];
  return one.what === 'goal' ? words.reach.event_goal(x, y) : words.reach.event_obstacle(one.mover ?? '', x, y);
}
