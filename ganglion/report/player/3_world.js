// What there is to see at one time, from the floor up.

const VIRIDIS = [
  [68, 1, 84], [72, 37, 118], [65, 68, 135], [53, 96, 141], [42, 120, 142], [33, 144, 140],
  [34, 168, 132], [67, 191, 113], [122, 209, 81], [187, 223, 39], [253, 231, 37],
];

function viridis(value) {
  const place = Math.min(1, Math.max(0, value)) * (VIRIDIS.length - 1);
  const below = Math.min(VIRIDIS.length - 2, Math.floor(place));
  return VIRIDIS[below].map((a, i) => Math.round(between(a, VIRIDIS[below + 1][i], place - below)));
}

/** Rectangles of a scanned map's cells: column, row, columns, rows. One path for all. */
function drawBlocks(view, map, blocks, colour) {
  const { context } = view;
  const cell = map.cell * view.scale;
  context.save();
  context.translate(view.x(map.x), view.y(map.y));
  context.rotate(-map.yaw);
  context.beginPath();
  for (let i = 0; i + 3 < blocks.length; i += 4) {
    context.rect(blocks[i] * cell, -(blocks[i + 1] + blocks[i + 3]) * cell, blocks[i + 2] * cell, blocks[i + 3] * cell);
  }
  context.fillStyle = colour;
  context.fill();
  context.restore();
}

function drawGround(view, scene, colours) {
  const [x0, y0, x1, y1] = view.bounds;
  view.trace([x0, y0, x1, y0, x1, y1, x0, y1], true);
  view.fill(colours.floor);
  for (const zone of scene.zones) {
    view.trace(zone.points, true);
    view.fill(colours.zone);
    view.stroke(colours.line, 1, [1, 3]);
  }
  for (const bump of scene.bumps) {
    view.trace(bump.points, false);
    view.stroke(colours.bump, 1.6, [8, 3, 2, 3]);
  }
  for (const block of scene.solids) {
    view.trace(block.points, true);
    view.fill(colours.wall);
  }
  if (scene.map) {
    drawBlocks(view, scene.map, scene.map.unknown, colours.mover);
    drawBlocks(view, scene.map, scene.map.occupied, colours.wall);
  }
  for (const piece of scene.furniture) {
    view.trace(piece.points, piece.closed);
    if (piece.closed) view.fill(colours.free);
  }
}

/** Over the learned map, so that the true walls can be compared with it. */
function drawEdges(view, scene, colours) {
  for (const piece of scene.furniture) {
    view.trace(piece.points, piece.closed);
    view.stroke(colours.line, 1.2);
  }
  for (const wall of scene.walls) {
    view.trace(wall.points, wall.closed);
    view.stroke(colours.wall, 2.5);
  }
}

function drawMovers(view, scene, t, colours) {
  for (const mover of scene.movers) {
    const row = Math.max(0, indexAt(mover.times, t));
    if (mover.poses.length < 3 * row + 3) continue;
    const [x, y, yaw] = mover.poses.slice(3 * row, 3 * row + 3);
    view.trace(mover.outline, true, { x, y, yaw });
    view.fill(colours.mover);
    view.stroke(colours.line, 1.2);
  }
}

function drawBeacons(view, scene, colours) {
  for (let i = 0; i + 1 < scene.beacons.length; i += 2) {
    const [x, y] = [view.x(scene.beacons[i]), view.y(scene.beacons[i + 1])];
    view.context.beginPath();
    for (const [dx, dy] of [[7, 0], [0, 7], [-7, 0], [0, -7]]) view.context.lineTo(x + dx, y + dy);
    view.context.closePath();
    view.fill(colours.goal);
    view.stroke('#22272e', 1.2);
  }
}

/** The colour of one cell [r, g, b, a] in the chosen view of the map; nothing for the unexplored. */
function cellColour(map, cell, layer) {
  const label = map.label[cell];
  if (label === 0 && map.risk[cell] === 0 && map.inhibited[cell] === 0) return [0, 0, 0, 0];
  if (layer === 'risk') return [...viridis(map.risk[cell] / 255), 215];
  if (layer === 'inhibition') return [...viridis(Math.min(1, map.inhibited[cell] / 20)), 215];
  return label === 2 ? [52, 60, 70, 225] : label === 1 ? [150, 200, 190, 190] : [0, 0, 0, 0];
}

function paintCells(map, layer) {
  map.image ??= new OffscreenCanvas(map.columns, map.rows);
  const painted = `${layer}:${map.shown}`;
  if (map.painted === painted) return;
  map.painted = painted;
  const context = map.image.getContext('2d');
  const image = context.createImageData(map.columns, map.rows);
  for (let row = 0; row < map.rows; row += 1) {
    for (let column = 0; column < map.columns; column += 1) {
      const dot = ((map.rows - 1 - row) * map.columns + column) * 4;
      image.data.set(cellColour(map, row * map.columns + column, layer), dot);
    }
  }
  context.putImageData(image, 0, 0);
}

function drawCross(view, x, y, size) {
  const [px, py] = [view.x(x), view.y(y)];
  view.context.beginPath();
  for (const side of [-1, 1]) {
    view.context.moveTo(px - size, py - size * side);
    view.context.lineTo(px + size, py + size * side);
  }
}

function drawMarks(view, map, colours) {
  const size = Math.min(7, (map.cell * view.scale) / 3);
  if (size < 1.5) return;
  for (let cell = 0; cell < map.label.length; cell += 1) {
    const x = map.x + ((cell % map.columns) + 0.5) * map.cell;
    const y = map.y + (Math.floor(cell / map.columns) + 0.5) * map.cell;
    if (map.label[cell] === 2) {
      view.context.beginPath();
      view.context.moveTo(view.x(x) - size, view.y(y) + size);
      view.context.lineTo(view.x(x) + size, view.y(y) - size);
      view.stroke('#ffffff', 1.4);
    }
    if (map.inhibited[cell] > 0) {
      drawCross(view, x, y, size + 1);
      view.stroke('#ffffff', 4);
      view.stroke(colours.contact, 2);
    } else if (map.dynamic[cell] > 0) {
      view.disc(x, y, Math.max(1.5, size / 2.5));
      view.fill('#ffffff');
    }
  }
}

function drawMap(view, map, t, layer, colours) {
  showMapAt(map, t);
  if (map.shown < 0) return;
  paintCells(map, layer);
  const width = map.columns * map.cell * view.scale;
  const height = map.rows * map.cell * view.scale;
  view.context.imageSmoothingEnabled = false;
  view.context.drawImage(map.image, view.x(map.x), view.y(map.y) - height, width, height);
  drawMarks(view, map, colours);
}

function drawRoutes(view, robot, t, colours) {
  const newest = {};
  for (const route of robot.routes) if (route.t <= t) newest[route.component] = route;
  for (const route of Object.values(newest)) {
    view.trace(route.points, false);
    view.stroke(colours.route, 2, [6, 4]);
  }
}

function drawGoals(view, robot, t, colours) {
  robot.goals.forEach((goal, i) => {
    if (goal.set > t) return;
    const ended = goal.ended !== null && goal.ended <= t;
    view.context.globalAlpha = ended ? 0.45 : 1;
    view.disc(goal.x, goal.y, ended ? 6 : 9);
    view.fill(colours.goal);
    view.stroke('#22272e', 1.3);
    view.context.fillStyle = '#22272e';
    view.context.font = 'bold 10px sans-serif';
    view.context.textAlign = 'center';
    view.context.textBaseline = 'middle';
    if (robot.goals.length > 1 && !ended) view.context.fillText(String(i + 1), view.x(goal.x), view.y(goal.y) + 0.5);
    view.context.globalAlpha = 1;
  });
}

function drawAttempts(view, robot, t, colours) {
  for (const attempt of robot.attempts) {
    if (attempt.t > t) break;
    view.trace(attempt.line, false);
    view.stroke(colours.attempt, 2, [2, 3]);
  }
}
