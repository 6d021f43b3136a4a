import { frameAt, isSeen, shapesAt } from '../state/frames';
import type { Timeline } from '../state/timeline';
import { useSettings } from '../theme/settings';
import type { FieldPainter } from './draw_field';
import { drawEdges, drawGround, drawMovers } from './draw_ground';
import { drawRobots, drawTrail } from './draw_robot';
import { drawShapes } from './draw_shapes';
import type { View, WorldColours } from './view';

/** The layer that is painted: of the field of that name, whoever shows it. */
export interface ChosenLayer {
  field: string;
  layer: string;
}

function paintFields(
  view: View,
  painter: FieldPainter,
  timeline: Timeline,
  t: number,
  robot: number,
  chosen: ChosenLayer,
  colours: WorldColours,
): void {
  for (const { of, track } of timeline.fields) {
    const state = of.name === chosen.field && isSeen(of, robot) ? track.at(t) : null;
    const place = state && frameAt(timeline, of, state.words.frame, t);
    if (state && place) painter.draw(view, state, place, chosen.layer, colours);
  }
}

/** What there is to see at one time, from the floor up. */
export function paintWorld(
  view: View,
  painter: FieldPainter,
  timeline: Timeline,
  t: number,
  robot: number,
  chosen: ChosenLayer,
  colours: WorldColours,
): void {
  const { scene } = timeline;
  const { language } = useSettings.getState();
  if (scene) view.setBounds(scene.bounds);
  if (!view.begin()) return;
  if (scene) drawGround(view, scene, colours);
  paintFields(view, painter, timeline, t, robot, chosen, colours);
  if (scene) {
    drawEdges(view, scene, colours);
    drawMovers(view, scene, timeline.movers.at(t), colours);
  }
  const shapes = shapesAt(timeline, robot, t);
  drawShapes(view, shapes, true, language, colours);
  const track = timeline.robots[robot];
  if (track) drawTrail(view, track, t, colours);
  drawShapes(view, shapes, false, language, colours);
  drawRobots(view, timeline, t, robot, colours);
}
