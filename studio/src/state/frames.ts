import type { ShownShape, Whose } from '../api/exhibits';
import type { Timeline } from './timeline';

export interface Place {
  x: number;
  y: number;
  yaw: number;
}

const kDeepest = 32; // frames within frames

export function followedBy(pose: Place, local: Place): Place {
  const [c, s] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + c * local.x - s * local.y, y: pose.y + s * local.x + c * local.y, yaw: pose.yaw + local.yaw };
}

/** What a column of a robot says; "robot1/truth.x_m" is another robot's. NaN where there is none. */
export function columnAt(timeline: Timeline, robot: number, column: string, t: number): number {
  const other = /^robot(\d+)\/(.*)$/.exec(column);
  return other ? timeline.value(Number(other[1]), other[2], t) : timeline.value(Math.max(0, robot), column, t);
}

/** The frame of that name that counts for whoever shows something in it: his own, else his robot's, else of all. */
function findFrame(timeline: Timeline, owner: Whose, name: string) {
  const rank = (of: Whose) => {
    if (of.form !== 'frame' || of.name !== name) return 0;
    if (of.robot !== owner.robot) return of.robot < 0 ? 1 : 0;
    return of.owner === owner.owner ? 3 : 2;
  };
  let best: Timeline['exhibits'][number] | null = null;
  for (const one of timeline.exhibits) if (rank(one.of) > (best ? rank(best.of) : 0)) best = one;
  return best;
}

/** Where a frame is in the world; null where it leads nowhere, or what leads it has no reading. */
export function frameAt(timeline: Timeline, owner: Whose, name: string, t: number): Place | null {
  let pose: Place = { x: 0, y: 0, yaw: 0 };
  for (let depth = 0; name !== 'world'; depth += 1) {
    const frame = depth < kDeepest && name !== '' ? findFrame(timeline, owner, name) : null;
    const now = frame?.track.at(t);
    if (!frame || !now?.columns || now.in === undefined) return null;
    const led = now.columns.map((one) => (one === '' ? 0 : columnAt(timeline, frame.of.robot, one, t)));
    const [x, y, yaw] = led;
    if (!Number.isFinite(x + y + yaw)) return null;
    const fixed = { x: now.x ?? 0, y: now.y ?? 0, yaw: now.yaw ?? 0 };
    pose = followedBy(followedBy(fixed, { x, y, yaw }), pose);
    name = now.in;
  }
  return pose;
}

/** A shape and where it is; its radius as its signal says, where one does. */
export interface PlacedShape {
  shape: ShownShape;
  pose: Place;
  radius: number;
}

export function isSeen(of: Whose, robot: number): boolean {
  return of.robot < 0 || of.robot === robot;
}

/** The shapes that are there at a time: those of the robot that is looked at, and of all. */
export function shapesAt(timeline: Timeline, robot: number, t: number): PlacedShape[] {
  const placed: PlacedShape[] = [];
  for (const { of, track } of timeline.exhibits) {
    if (of.form !== 'marks' || !isSeen(of, robot)) continue;
    for (const shape of track.at(t)?.shapes ?? []) {
      const pose = frameAt(timeline, of, shape.frame, t);
      if (!pose) continue;
      const told = shape.column ? columnAt(timeline, of.robot, shape.column, t) : (shape.radius ?? 0);
      placed.push({ shape, pose, radius: Number.isFinite(told) && told > 0 ? told : 0 });
    }
  }
  return placed;
}
