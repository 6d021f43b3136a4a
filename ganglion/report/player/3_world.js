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

/** The colour of one byte of a layer [r, g, b, a]; nothing for the unknown. */
function cellColour(layer, byte, colours) {
  if (byte === UNKNOWN) return [0, 0, 0, 0];
  const one = classOf(layer, byte);
  return one ? [...channels(colours.roles[one.role]), 205] : [...viridis(byte / 254), 215];
}

/** The class whose byte is nearest; nothing for a scale. */
function classOf(layer, byte) {
  let best = null;
  for (const one of layer.classes) {
    if (!best || Math.abs(one.byte - byte) < Math.abs(best.byte - byte)) best = one;
  }
  return best;
}

/** "#rrggbb" as three numbers. */
function channels(colour) {
  return [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
}

function paintCells(field, now, layer, colours) {
  const painted = `${layer}:${field.shown}:${colours.floor}`;
  if (field.image && field.painted === painted) return;
  field.painted = painted;
  field.image = new OffscreenCanvas(now.columns, now.rows);
  const context = field.image.getContext('2d');
  const image = context.createImageData(now.columns, now.rows);
  for (let row = 0; row < now.rows; row += 1) {
    for (let column = 0; column < now.columns; column += 1) {
      const dot = ((now.rows - 1 - row) * now.columns + column) * 4;
      image.data.set(cellColour(field.layers[layer], now.cells[layer][row * now.columns + column], colours), dot);
    }
  }
  context.putImageData(image, 0, 0);
}

function drawCross(context, x, y, size) {
  context.beginPath();
  for (const side of [-1, 1]) {
    context.moveTo(x - size, y - size * side);
    context.lineTo(x + size, y + size * side);
  }
}

/** The sign of a class over a cell, in a box of twice `size` about x, y on the canvas. */
function drawSign(view, sign, x, y, size, colour) {
  const { context } = view;
  if (sign === 'hatch') {
    context.beginPath();
    context.moveTo(x - size, y + size);
    context.lineTo(x + size, y - size);
    view.stroke('#ffffff', 1.4);
  } else if (sign === 'cross') {
    drawCross(context, x, y, size + 1);
    view.stroke('#ffffff', 4);
    view.stroke(colour, 2);
  } else if (sign === 'dot') {
    context.beginPath();
    context.arc(x, y, Math.max(1.5, size / 2.5), 0, 2 * Math.PI);
    view.fill('#ffffff');
  }
}

/** Signs of all layers of classes; a cross covers the others. */
function drawSigns(view, run, field, now, place, size, colours) {
  if (size < 1.5) return;
  const layers = field.layers.map((layer, i) => [layer, i]).filter(([layer]) => layer.classes.length > 0);
  for (let cell = 0; cell < now.columns * now.rows; cell += 1) {
    const found = layers.map(([layer, i]) => (now.cells[i][cell] === UNKNOWN ? null : classOf(layer, now.cells[i][cell])));
    const signs = found.filter(Boolean).map((one) => [run.roles[one.role].sign, one.role]);
    const crossed = signs.some(([sign]) => sign === 'cross');
    const [x, y] = place(cell % now.columns, Math.floor(cell / now.columns));
    for (const [sign, role] of signs) if (sign !== 'dot' || !crossed) drawSign(view, sign, x, y, size, colours.roles[role]);
  }
}

/** One layer of a field in its frame. */
function drawField(view, run, field, t, layer, colours) {
  const now = fieldAt(field, t);
  const pose = now && frameAt(run, field, field.frame, t);
  if (!pose) return;
  paintCells(field, now, layer, colours);
  const [wide, high] = [field.cell[0] * view.scale, field.cell[1] * view.scale];
  const { context } = view;
  context.save();
  context.translate(view.x(pose.x), view.y(pose.y));
  context.rotate(-pose.yaw);
  context.imageSmoothingEnabled = false;
  const [left, below] = [now.x * view.scale, -now.y * view.scale];
  context.drawImage(field.image, left, below - now.rows * high, now.columns * wide, now.rows * high);
  const place = (column, row) => [left + (column + 0.5) * wide, below - (row + 0.5) * high];
  drawSigns(view, run, field, now, place, Math.min(7, Math.min(wide, high) / 3), colours);
  context.restore();
}

const [POLYLINE, POLYGON, DISC, SECTOR, POINT, LABEL] = [0, 1, 2, 3, 4, 5];

function fillAndStroke(view, role, colour, closed) {
  if (closed) {
    view.context.globalAlpha *= role.filled ? 0.45 : 0.12;
    view.fill(colour);
    view.context.globalAlpha = role.over ? 0.5 : 1;
  }
  view.stroke(colour, 2, role.dash);
}

function drawDisc(view, role, colour, at, radius, small) {
  view.disc(at.x, at.y, small ? radius * 0.7 : radius);
  if (!role.filled) return fillAndStroke(view, role, colour, true);
  view.fill(colour);
  view.stroke('#22272e', 1.3);
  if (role.sign === 'cross') {
    drawCross(view.context, view.x(at.x), view.y(at.y), radius * 0.5);
    view.stroke('#22272e', 1.8);
  }
  return undefined;
}

function drawShape(view, run, { shape, pose, radius }, colours) {
  const role = run.roles[shape.role];
  const colour = colours.roles[shape.role];
  const at = followedBy(pose, { x: shape.xy[0], y: shape.xy[1], yaw: 0 });
  view.context.globalAlpha = role.over ? 0.5 : 1;
  if (shape.form === POLYLINE || shape.form === POLYGON) {
    view.trace(shape.xy, shape.form === POLYGON, pose);
    fillAndStroke(view, role, colour, shape.form === POLYGON);
  } else if (shape.form === DISC) {
    drawDisc(view, role, colour, at, Math.max(radius * view.scale, shape.radius ? 4 : 9), role.over && !shape.radius);
  } else if (shape.form === SECTOR) {
    traceSector(view, at, radius, shape.angle ?? 0, at.yaw);
    fillAndStroke(view, role, colour, true);
  } else if (shape.form === POINT) {
    view.disc(at.x, at.y, 4);
    view.fill(colour);
  }
  view.context.globalAlpha = 1;
}

function drawLabel(view, run, { shape, pose }, colours) {
  if (!shape.label || (shape.form === DISC && run.roles[shape.role].over)) return;
  const count = shape.xy.length / 2;
  let [x, y] = [0, 0];
  for (let i = 0; i < shape.xy.length; i += 2) {
    const at = followedBy(pose, { x: shape.xy[i], y: shape.xy[i + 1], yaw: 0 });
    x += at.x / count;
    y += at.y / count;
  }
  const { context } = view;
  const inside = shape.form === DISC;
  context.font = inside ? 'bold 10px sans-serif' : '12px sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const down = inside || shape.form === POLYGON ? 0.5 : 14;
  context.lineWidth = 3;
  context.strokeStyle = colours.floor;
  context.setLineDash([]);
  if (!inside) context.strokeText(shape.label[language], view.x(x), view.y(y) + down);
  context.fillStyle = inside ? '#22272e' : colours.text;
  context.fillText(shape.label[language], view.x(x), view.y(y) + down);
}

/** Lines lie below the ways, everything else above them. */
function drawShapes(view, run, shapes, lines, colours) {
  const some = shapes.filter(({ shape }) => (shape.form === POLYLINE) === lines);
  for (const placed of some) if (placed.shape.form !== LABEL) drawShape(view, run, placed, colours);
  for (const placed of some) drawLabel(view, run, placed, colours);
}
