// Robots: trail, sonar cones, body.

/** One path for each spell of a behaviour up to row `last`. */
function drawTrail(view, robot, last, colours) {
  const coordination = robot.coordinations[0];
  const stride = Math.max(1, Math.floor(robot.t.length / 4000));
  let active = null;
  let open = false;
  const finish = () => {
    if (!open) return;
    const look = active === null ? colours.trail : lookColour(colours, active);
    view.stroke(look, 2, active === null || active < 0 ? [] : DASHES[active % 8]);
    open = false;
  };
  for (let row = 0; row <= last; row += 1) {
    if (row % stride !== 0 && row !== last) continue;
    const [x, y] = [view.x(robot.x[row]), view.y(robot.y[row])];
    if (!Number.isFinite(x + y)) {
      finish();
      continue;
    }
    const now = coordination ? activeAt(coordination, row) : null;
    if (open) view.context.lineTo(x, y);
    if (!open || now !== active) {
      finish();
      active = now;
      view.context.beginPath();
      view.context.moveTo(x, y);
      open = true;
    }
  }
  finish();
}

function drawStart(view, robot, colours) {
  if (!Number.isFinite(robot.x[0] + robot.y[0])) return;
  view.disc(robot.x[0], robot.y[0], 5);
  view.fill(colours.start);
  view.stroke('#22272e', 1);
}

function traceSector(view, at, range, cone, yaw) {
  view.context.beginPath();
  view.context.moveTo(view.x(at.x), view.y(at.y));
  view.context.arc(view.x(at.x), view.y(at.y), range * view.scale, -(yaw + cone / 2), -(yaw - cone / 2));
  view.context.closePath();
}

/** Widening arcs out to the reading; an empty cone is dashed, a lost echo a short grey stub, too close a red one. */
function drawCone(view, at, yaw, sensor, range, colours) {
  const cone = Math.max(sensor.cone, 0.02);
  const stub = Math.min(0.12, sensor.max / 4);
  if (Number.isNaN(range) || range === Number.NEGATIVE_INFINITY) {
    traceSector(view, at, stub, cone, yaw);
    view.fill(Number.isNaN(range) ? colours.muted : colours.contact);
    return;
  }
  if (range === Number.POSITIVE_INFINITY) {
    traceSector(view, at, sensor.max, cone, yaw);
    view.context.globalAlpha = 0.35;
    view.stroke(colours.sonar, 1, [3, 5]);
    view.context.globalAlpha = 1;
    return;
  }
  traceSector(view, at, range, cone, yaw);
  view.context.globalAlpha = 0.1;
  view.fill(colours.sonar);
  for (const part of [0.25, 0.5, 0.75, 1]) {
    view.context.globalAlpha = part === 1 ? 0.95 : 0.45;
    view.context.beginPath();
    view.context.arc(view.x(at.x), view.y(at.y), range * part * view.scale, -(yaw + cone / 2), -(yaw - cone / 2));
    view.stroke(colours.sonar, part === 1 ? 2.4 : 1.2);
  }
  view.context.globalAlpha = 1;
}

function drawSensors(view, robot, pose, colours) {
  for (const sensor of robot.sensors) {
    const at = {
      x: pose.x + Math.cos(pose.yaw) * sensor.x - Math.sin(pose.yaw) * sensor.y,
      y: pose.y + Math.sin(pose.yaw) * sensor.x + Math.cos(pose.yaw) * sensor.y,
    };
    drawCone(view, at, pose.yaw + sensor.yaw, sensor, reading(sensor, pose.row), colours);
  }
}

/** To scale, but never so small that it cannot be seen. */
function drawBody(view, robot, pose, colours, chosen) {
  const least = 9 / view.scale;
  const edge = pose.touching ? colours.contact : colours.wall;
  if (robot.radius > 0) {
    view.disc(pose.x, pose.y, Math.max(robot.radius, least / 2) * view.scale);
  } else {
    const grow = Math.max(1, least / Math.max(robot.length, robot.width, 1e-6));
    const [l, w] = [(robot.length * grow) / 2, (robot.width * grow) / 2];
    view.trace([l, -w, l, w, -l, w, -l, -w], true, pose);
  }
  view.fill(colours.body);
  view.stroke(edge, pose.touching ? 3 : chosen ? 2 : 1.2);
  const nose = Math.max(robot.radius || robot.length / 2, least / 2);
  view.trace([nose, 0, nose * 0.2, nose * 0.5, nose * 0.2, -nose * 0.5], true, pose);
  view.fill(edge);
}

/** Whether something is of the robot that is looked at, or of all. */
function isSeen(player, exhibit) {
  return exhibit.robot < 0 || exhibit.robot === player.robot;
}

/** The whole world at t. */
function drawWorld(player) {
  const { view, run, t, colours, layers } = player;
  view.begin();
  drawGround(view, run.scene, colours);
  const [field, layer] = (layers.field ?? '').split('\n');
  for (const one of run.exhibits) {
    if (one.of !== 'field' || one.name !== field || !isSeen(player, one)) continue;
    const index = one.layers.findIndex((each) => each.name === layer);
    if (index >= 0) drawField(view, run, one, t, index, colours);
  }
  drawEdges(view, run.scene, colours);
  drawBeacons(view, run.scene, colours);
  if (layers.movers) drawMovers(view, run.scene, t, colours);
  const shapes = shapesAt(run, t, (one) => isSeen(player, one) && layers[`marks-${one.name}`] !== false);
  drawShapes(view, run, shapes, true, colours);
  const poses = run.robots.map((robot) => poseAt(robot, t, player.smooth));
  run.robots.forEach((robot, i) => {
    if (layers.trail && poses[i]) drawTrail(view, robot, poses[i].row, colours);
    drawStart(view, robot, colours);
  });
  drawShapes(view, run, shapes, false, colours);
  run.robots.forEach((robot, i) => {
    if (!poses[i]) return;
    if (layers.sonar && (i === player.robot || run.robots.length <= 12)) drawSensors(view, robot, poses[i], colours);
    drawBody(view, robot, poses[i], colours, i === player.robot);
  });
}
