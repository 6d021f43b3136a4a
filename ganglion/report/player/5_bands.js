// Behaviours over time: a band for each, the moment shown as a line. A click seeks.

const BAND = 20;
const HEAD = 16;
const NAMES = 92;

/** Where each coordinator's bands begin below the upper edge; the last entry is the height of all. */
function bandsTops(robot) {
  const tops = [HEAD];
  const many = (robot?.coordinations.length ?? 0) > 1;
  for (const coordination of robot?.coordinations ?? []) {
    tops.push(tops[tops.length - 1] + coordination.candidates.length * BAND + (many ? HEAD + 4 : 4));
  }
  return tops;
}

/** Spells in which a candidate stands the same: [from row, to row, share 0..255, wanted]. */
function spells(coordination, candidate) {
  const width = coordination.candidates.length;
  const found = [];
  const shared = coordination.shares.length > 0;
  const share = (row) => (shared ? coordination.shares[row * width + candidate] : coordination.active[row] === candidate ? 255 : 0);
  const wants = (row) => coordination.wanted[row * width + candidate] === 1;
  let from = 0;
  for (let row = 1; row <= coordination.active.length; row += 1) {
    if (row < coordination.active.length && share(row) === share(from) && wants(row) === wants(from)) continue;
    found.push([from, row, share(from), wants(from)]);
    from = row;
  }
  return found;
}

function hatchPattern(player, context, colour) {
  player.patterns ??= {};
  player.patterns[colour] ??= makeHatch(context, colour);
  return player.patterns[colour];
}

function makeHatch(context, colour) {
  const tile = new OffscreenCanvas(6, 6);
  const c = tile.getContext('2d');
  c.strokeStyle = colour;
  c.lineWidth = 1.2;
  c.beginPath();
  for (const shift of [-6, 0, 6]) {
    c.moveTo(shift - 1, 7);
    c.lineTo(shift + 7, -1);
  }
  c.stroke();
  return context.createPattern(tile, 'repeat');
}

function drawBand(context, player, coordination, candidate, top, scale) {
  const robot = player.run.robots[player.robot];
  const colour = lookColour(player.colours, candidate);
  coordination.spells ??= coordination.candidates.map((_, i) => spells(coordination, i));
  for (const [from, to, share, wanted] of coordination.spells[candidate]) {
    if (share === 0 && !wanted) continue;
    const left = scale(robot.t[from]);
    const width = Math.max(0.7, scale(to < robot.t.length ? robot.t[to] : player.duration) - left);
    const height = share > 0 ? ((BAND - 5) * share) / 255 : BAND - 5;
    context.fillStyle = share > 0 ? colour : hatchPattern(player, context, colour);
    context.fillRect(left, top + BAND - 5 - height, width, height);
  }
}

function drawEventMarks(context, player, scale) {
  for (const event of player.run.events) {
    context.fillStyle = event.level === 'info' ? player.colours.muted : player.colours.contact;
    const x = scale(event.t);
    context.beginPath();
    context.moveTo(x, HEAD - 2);
    context.lineTo(x - 4, HEAD - 10);
    context.lineTo(x + 4, HEAD - 10);
    context.fill();
  }
}

function fitText(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let short = text;
  while (short && context.measureText(`${short}…`).width > width) short = short.slice(0, -1);
  return `${short}…`;
}

function drawNames(context, player, coordination, top) {
  context.font = '12px sans-serif';
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  coordination.candidates.forEach((name, i) => {
    context.fillStyle = player.colours.text;
    context.fillText(fitText(context, name, NAMES - 12), NAMES - 8, top + i * BAND + (BAND - 5) / 2);
  });
}

function drawCoordination(context, player, coordination, top, scale) {
  drawNames(context, player, coordination, top);
  coordination.candidates.forEach((_, i) => {
    drawBand(context, player, coordination, i, top + i * BAND, scale);
    context.strokeStyle = player.colours.muted;
    context.lineWidth = 0.6;
    context.strokeRect(scale(0), top + i * BAND, scale(player.duration) - scale(0), BAND - 5);
  });
}

/** Draws the strip below the world. */
function drawBands(player) {
  const robot = player.run.robots[player.robot];
  const coordinations = robot?.coordinations ?? [];
  const tops = bandsTops(robot);
  player.bands.style.height = `${tops[tops.length - 1] + 6}px`;
  const { context, width, height } = fitCanvas(player.bands);
  const scale = (t) => bandsX(player, width, t);
  coordinations.forEach((coordination, i) => {
    const head = coordinations.length > 1 ? HEAD : 0;
    drawCoordination(context, player, coordination, tops[i] + head, scale);
    context.fillStyle = player.colours.text;
    context.textAlign = 'left';
    if (head) context.fillText(coordination.name, scale(0), tops[i] + head / 2);
  });
  context.strokeStyle = player.colours.muted;
  context.strokeRect(scale(0), HEAD - 1, scale(player.duration) - scale(0), 0.5);
  drawEventMarks(context, player, scale);
  context.fillStyle = player.colours.accent;
  context.fillRect(scale(player.t) - 1, 2, 2, height - 4);
}

function bandsX(player, width, t) {
  const left = player.run.robots[player.robot]?.coordinations.length ? NAMES : 6;
  return left + (t / player.duration) * (width - left - 6);
}

/** The time under a point of the strip. */
function bandsTime(player, x) {
  const zero = bandsX(player, player.bands.clientWidth, 0);
  const end = bandsX(player, player.bands.clientWidth, player.duration);
  return ((x - zero) / (end - zero)) * player.duration;
}
