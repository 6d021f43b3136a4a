import type { Timeline } from '../state/timeline';
import { drawEdges, drawGround, drawMovers } from './draw_ground';
import type { MapPainter } from './draw_map';
import { drawAttempts, drawRobots, drawTrail } from './draw_robot';
import type { View, WorldColours } from './view';

function drawPaths(view: View, timeline: Timeline, t: number, colours: WorldColours): void {
  for (const path of timeline.paths) {
    const points = path.track.at(t);
    if (!points || points.length < 4) continue;
    view.context.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) view.context.lineTo(view.x(points[i]), view.y(points[i + 1]));
    if (path.topic.includes('/attempts/')) view.stroke(colours.attempt, 2.5, [2, 4]);
    else view.stroke(colours.route, 2, [7, 4]);
  }
}

/** The goal of that time: a yellow dot, hollow once it is done with. */
function drawGoal(view: View, timeline: Timeline, t: number, robot: number, colours: WorldColours): void {
  const goal = timeline.goals.filter((one) => one.time_s <= t + 1e-9 && one.robot === robot).at(-1);
  if (!goal) return;
  view.disc(goal.x_m, goal.y_m, 7);
  if (goal.state === 'set') view.fill(colours.goalmark);
  view.stroke(goal.state === 'set' ? '#22272e' : colours.goalmark, goal.state === 'set' ? 1.5 : 3);
}

/** What there is to see at one time, from the floor up. */
export function paintWorld(
  view: View,
  map: MapPainter,
  timeline: Timeline,
  t: number,
  robot: number,
  layer: string,
  colours: WorldColours,
): void {
  const { scene } = timeline;
  if (scene) view.setBounds(scene.bounds);
  if (!view.begin()) return;
  if (scene) drawGround(view, scene, colours);
  const learned = timeline.maps[0];
  const state = learned?.track.at(t);
  if (state && layer !== '') map.draw(view, state, learned.layers, layer, colours);
  if (scene) {
    drawEdges(view, scene, colours);
    drawMovers(view, scene, timeline.movers.at(t), colours);
  }
  const track = timeline.robots[robot];
  if (track) {
    drawAttempts(view, track, t, timeline.info?.cell_m || 0.2, colours);
    drawTrail(view, track, t, colours);
  }
  drawPaths(view, timeline, t, colours);
  drawGoal(view, timeline, t, robot, colours);
  drawRobots(view, timeline, t, robot, colours);
}
