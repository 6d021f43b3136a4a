import type { RobotInfo } from '../api/types';
import type { RowTrack } from '../state/rows';
import type { Timeline } from '../state/timeline';
import type { View, WorldColours } from './view';

const kMostTrailPoints = 3000;
const kArrowEvery_px = 34;
const kSimpleAbove = 300;
const kFew = 12;

export interface Pose {
  x: number;
  y: number;
  yaw: number;
  touching: boolean;
}

export function poseAt(timeline: Timeline, robot: number, t: number): Pose | null {
  const x = timeline.value(robot, 'truth.x_m', t);
  const y = timeline.value(robot, 'truth.y_m', t);
  if (!Number.isFinite(x + y)) return null;
  const yaw = timeline.value(robot, 'truth.yaw_rad', t);
  return { x, y, yaw: Number.isFinite(yaw) ? yaw : 0, touching: timeline.value(robot, 'truth.touching', t) === 1 };
}

function arrow(view: View, x: number, y: number, angle: number): void {
  const { context } = view;
  context.moveTo(x - 7 * Math.cos(angle - 0.45), y - 7 * Math.sin(angle - 0.45));
  context.lineTo(x, y);
  context.lineTo(x - 7 * Math.cos(angle + 0.45), y - 7 * Math.sin(angle + 0.45));
}

/** Way so far: a green line with arrows, from a green dot. */
export function drawTrail(view: View, track: RowTrack, t: number, colours: WorldColours): void {
  const [cx, cy] = [track.columns.get('truth.x_m'), track.columns.get('truth.y_m')];
  const last = track.at(t);
  if (cx === undefined || cy === undefined || last < 0) return;
  const stride = Math.max(1, Math.ceil(last / kMostTrailPoints));
  const { context } = view;
  const arrows: [number, number, number][] = [];
  let before: [number, number] | null = null;
  let way = 0;
  context.beginPath();
  for (let i = 0; i <= last; i += stride) {
    const at: [number, number] = [view.x(track.value(i, cx)), view.y(track.value(i, cy))];
    if (!Number.isFinite(at[0] + at[1])) {
      before = null;
      continue;
    }
    if (before) {
      context.lineTo(at[0], at[1]);
      way += Math.hypot(at[0] - before[0], at[1] - before[1]);
      if (way > kArrowEvery_px) {
        arrows.push([at[0], at[1], Math.atan2(at[1] - before[1], at[0] - before[0])]);
        way = 0;
      }
    } else context.moveTo(at[0], at[1]);
    before = at;
  }
  for (const [x, y, angle] of arrows) arrow(view, x, y, angle);
  view.stroke(colours.trail, 1.8);
  view.disc(track.value(0, cx), track.value(0, cy), 6);
  view.fill(colours.start);
  view.stroke(colours.line, 1);
}

function sector(view: View, x: number, y: number, range_m: number, cone: number, yaw: number): void {
  view.context.beginPath();
  view.context.moveTo(view.x(x), view.y(y));
  view.context.arc(view.x(x), view.y(y), range_m * view.scale, -(yaw + cone / 2), -(yaw - cone / 2));
  view.context.closePath();
}

/** Widening blue arcs out to the reading; nothing in range: dashed; no reading: a grey stub; too close: a red one. */
function drawCone(
  view: View,
  pose: Pose,
  sensor: RobotInfo['sensors'][number],
  range: number,
  colours: WorldColours,
): void {
  const [c, s] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  const [x, y] = [pose.x + c * sensor.x_m - s * sensor.y_m, pose.y + s * sensor.x_m + c * sensor.y_m];
  const yaw = pose.yaw + sensor.yaw_rad;
  const cone = Math.max(sensor.cone_rad, 0.02);
  if (Number.isNaN(range) || range === Number.NEGATIVE_INFINITY) {
    sector(view, x, y, Math.min(0.12, sensor.max_range_m / 4), cone, yaw);
    view.fill(Number.isNaN(range) ? colours.mover : colours.contact);
    return;
  }
  const { context } = view;
  if (range === Number.POSITIVE_INFINITY) {
    sector(view, x, y, sensor.max_range_m, cone, yaw);
    context.globalAlpha = 0.4;
    view.stroke(colours.sonar, 1, [3, 5]);
    context.globalAlpha = 1;
    return;
  }
  sector(view, x, y, range, cone, yaw);
  context.globalAlpha = 0.1;
  view.fill(colours.sonar);
  for (const part of [0.25, 0.5, 0.75, 1]) {
    context.globalAlpha = part === 1 ? 0.95 : 0.5;
    context.beginPath();
    context.arc(view.x(x), view.y(y), range * part * view.scale, -(yaw + cone / 2), -(yaw - cone / 2));
    view.stroke(colours.sonar, part === 1 ? 2 : 1);
  }
  context.globalAlpha = 1;
}

function drawBody(view: View, pose: Pose, info: RobotInfo, colours: WorldColours): void {
  const [l, w] = [info.length_m / 2, info.width_m / 2];
  view.polygon(
    [
      [-l, -w],
      [l * 0.55, -w],
      [l, 0],
      [l * 0.55, w],
      [-l, w],
    ],
    true,
    [pose.x, pose.y, pose.yaw],
  );
  view.fill(colours.body);
  view.stroke(pose.touching ? colours.contact : colours.line, pose.touching ? 3 : 1.5);
}

/** In a crowd: the outlines of a robot's cones as one path, where there is a reading. */
function drawReach(view: View, pose: Pose, info: RobotInfo, range: (signal: string) => number, colour: string): void {
  const [c, s] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  const { context } = view;
  context.beginPath();
  for (const sensor of info.sensors) {
    if (!sensor.signal || sensor.max_range_m <= 0) continue;
    const reading = range(sensor.signal);
    if (!Number.isFinite(reading)) continue;
    const x = view.x(pose.x + c * sensor.x_m - s * sensor.y_m);
    const y = view.y(pose.y + s * sensor.x_m + c * sensor.y_m);
    const [yaw, half] = [pose.yaw + sensor.yaw_rad, Math.max(sensor.cone_rad, 0.02) / 2];
    context.moveTo(x, y);
    context.arc(x, y, reading * view.scale, -(yaw + half), -(yaw - half));
    context.closePath();
  }
  view.stroke(colour, 1);
}

/** The one that is looked at with its cones in full, and so the others while they are few. */
export function drawRobots(view: View, timeline: Timeline, t: number, robot: number, colours: WorldColours): void {
  const infos = timeline.info?.robots ?? [];
  infos.forEach((info, i) => {
    const pose = poseAt(timeline, i, t);
    if (!pose) return;
    if (i === robot || infos.length <= kFew) {
      for (const sensor of info.sensors) {
        if (sensor.signal && sensor.max_range_m > 0)
          drawCone(view, pose, sensor, timeline.value(i, sensor.signal, t), colours);
      }
    } else if (infos.length <= kSimpleAbove) {
      drawReach(view, pose, info, (signal) => timeline.value(i, signal, t), colours.sonar);
    }
    drawBody(view, pose, info, colours);
  });
}
