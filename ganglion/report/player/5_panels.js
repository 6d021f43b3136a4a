// What was shown and lies nowhere in the world: curves, bars, networks, fields with axes of their own.

const PANEL_LOOKS = 8;

function isPanel(exhibit) {
  return ['curve', 'bars', 'network'].includes(exhibit.of) || (exhibit.of === 'field' && exhibit.frame === '');
}

/** One figure for each, made once. */
function makePanels(run) {
  const list = document.getElementById('panels');
  return run.exhibits.filter(isPanel).map((exhibit) => {
    const figure = document.createElement('figure');
    const caption = document.createElement('figcaption');
    const canvas = document.createElement('canvas');
    canvas.setAttribute('role', 'img');
    figure.append(caption, canvas);
    list.append(figure);
    return { exhibit, figure, caption, canvas };
  });
}

function named(axis) {
  const name = axis.title[language];
  return axis.unit ? `${name} [${axis.unit}]` : name;
}

function shortNumber(value) {
  return String(Number(value.toPrecision(3)));
}

/** Draws in the units of a panel: `x` and `y` take values to dots. */
function panelFrame(canvas, height, [left, top, right, bottom]) {
  canvas.style.height = `${height}px`;
  const fitted = fitCanvas(canvas);
  const area = { left, top, width: fitted.width - left - right, height: fitted.height - top - bottom };
  fitted.context.font = '12px sans-serif';
  fitted.context.textBaseline = 'middle';
  return { ...fitted, area };
}

function write(panel, colour, words, x, y, align = 'center', most = 400) {
  panel.context.fillStyle = colour;
  panel.context.textAlign = align;
  panel.context.fillText(words, x, y, most);
}

function line(panel, points, colour, width, dash) {
  panel.context.beginPath();
  for (const [x, y] of points) panel.context.lineTo(x, y);
  panel.context.strokeStyle = colour;
  panel.context.lineWidth = width;
  panel.context.setLineDash(dash || []);
  panel.context.stroke();
  panel.context.setLineDash([]);
}

function box(panel, colour) {
  const { left, top, width, height } = panel.area;
  panel.context.strokeStyle = colour;
  panel.context.lineWidth = 1;
  panel.context.strokeRect(left, top, width, height);
}

/** Lines of one role are told apart by looks, others by the role's. */
function lineLook(player, lines, i) {
  const { role } = lines[i];
  if (role !== 'plain' && lines.filter((one) => one.role === role).length === 1) {
    return [player.colours.roles[role], player.run.roles[role].dash];
  }
  return [player.colours.looks[i % PANEL_LOOKS], DASHES[i % PANEL_LOOKS]];
}

function extentOf(lines) {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const one of lines) {
    for (let i = 0; i + 1 < one.xy.length; i += 2) {
      [x0, x1] = [Math.min(x0, one.xy[i]), Math.max(x1, one.xy[i])];
      [y0, y1] = [Math.min(y0, one.xy[i + 1]), Math.max(y1, one.xy[i + 1])];
    }
  }
  if (!(x0 <= x1)) return [0, 0, 1, 1];
  const pad = y1 > y0 ? 0.06 * (y1 - y0) : 0.5;
  return [x0, y0 - pad, x1 > x0 ? x1 : x0 + 1, y1 + pad];
}

function drawCurve(player, { exhibit, canvas }, state) {
  const { colours } = player;
  const panel = panelFrame(canvas, 230, [64, 10, 150, 42]);
  const { area } = panel;
  const [x0, y0, x1, y1] = extentOf(state.lines);
  const x = (value) => area.left + (area.width * (value - x0)) / (x1 - x0);
  const y = (value) => area.top + area.height * (1 - (value - y0) / (y1 - y0));
  state.lines.forEach((one, i) => {
    const points = [];
    for (let k = 0; k + 1 < one.xy.length; k += 2) points.push([x(one.xy[k]), y(one.xy[k + 1])]);
    const [colour, dash] = lineLook(player, state.lines, i);
    line(panel, points, colour, 2, dash);
    const row = area.top + 10 + 18 * i;
    line(panel, [[panel.width - 140, row], [panel.width - 112, row]], colour, 2, dash);
    write(panel, colours.text, one.title[language], panel.width - 106, row, 'left', 104);
  });
  const cursor = state.cursor ? columnAt(player.run, exhibit.robot, state.cursor, player.t) : Number.NaN;
  if (cursor >= x0 && cursor <= x1) {
    line(panel, [[x(cursor), area.top], [x(cursor), area.top + area.height]], colours.roles.danger, 1.6, [4, 3]);
    write(panel, colours.muted, `${state.cursor} ${shortNumber(cursor)}`, panel.width - 140, area.top + area.height - 8, 'left', 138);
  }
  box(panel, colours.muted);
  for (const part of [0, 0.5, 1]) {
    write(panel, colours.text, shortNumber(x0 + part * (x1 - x0)), x(x0 + part * (x1 - x0)), area.top + area.height + 12);
    write(panel, colours.text, shortNumber(y0 + part * (y1 - y0)), area.left - 6, y(y0 + part * (y1 - y0)), 'right', 56);
  }
  write(panel, colours.text, named(state.across), area.left + area.width / 2, panel.height - 10);
  panel.context.save();
  panel.context.translate(10, area.top + area.height / 2);
  panel.context.rotate(-Math.PI / 2);
  write(panel, colours.text, named(state.up), 0, 0);
  panel.context.restore();
}

function drawBars(player, { canvas }, state) {
  const { colours } = player;
  const panel = panelFrame(canvas, 46 + 24 * Math.max(1, state.bars.length), [150, 6, 60, 34]);
  const { area } = panel;
  const values = state.bars.map((bar) => bar.value);
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  const shift = low < 0 ? 46 : 0;
  const x = (value) => area.left + shift + ((area.width - shift) * (value - low)) / (high - low || 1);
  state.bars.forEach((bar, i) => {
    const top = area.top + 24 * i;
    write(panel, colours.text, bar.title[language], area.left - 8, top + 12, 'right', 136);
    panel.context.fillStyle = colours.roles[bar.role];
    panel.context.fillRect(Math.min(x(0), x(bar.value)), top + 4, Math.max(1, Math.abs(x(bar.value) - x(0))), 16);
    const left = bar.value < 0;
    write(panel, colours.text, shortNumber(bar.value), x(bar.value) + (left ? -5 : 5), top + 12, left ? 'right' : 'left');
  });
  const bottom = area.top + 24 * state.bars.length;
  line(panel, [[x(0), area.top], [x(0), bottom]], colours.muted, 1);
  write(panel, colours.text, named(state.up), area.left + area.width / 2, bottom + 18);
}

function drawNetwork(player, { canvas }, state) {
  const { colours } = player;
  const panel = panelFrame(canvas, 260, [80, 30, 80, 46]);
  const { area } = panel;
  const span = (values) => [Math.min(...values), Math.max(...values)];
  const [x0, x1] = span(state.nodes.map((node) => node.x));
  const [y0, y1] = span(state.nodes.map((node) => node.y));
  const place = (node) => [
    area.left + area.width * (x1 > x0 ? (node.x - x0) / (x1 - x0) : 0.5),
    area.top + area.height * (y1 > y0 ? 1 - (node.y - y0) / (y1 - y0) : 0.5),
  ];
  const heaviest = Math.max(1e-12, ...state.edges.map((edge) => Math.abs(edge.weight)));
  for (const edge of state.edges) {
    const [[ax, ay], [bx, by]] = [place(state.nodes[edge.from]), place(state.nodes[edge.to])];
    const way = Math.hypot(bx - ax, by - ay);
    if (way < 24) continue;
    const [ux, uy] = [(bx - ax) / way, (by - ay) / way];
    const [tx, ty] = [bx - 14 * ux, by - 14 * uy];
    const colour = colours.roles[edge.role];
    const width = 0.8 + (3.2 * Math.abs(edge.weight)) / heaviest;
    line(panel, [[ax + 11 * ux, ay + 11 * uy], [tx - 6 * ux, ty - 6 * uy]], colour, width, player.run.roles[edge.role].dash);
    panel.context.beginPath();
    for (const [forth, aside] of [[0, 0], [-11, 5], [-11, -5]]) {
      panel.context.lineTo(tx + forth * ux - aside * uy, ty + forth * uy + aside * ux);
    }
    panel.context.fillStyle = colour;
    panel.context.fill();
  }
  for (const node of state.nodes) {
    const [x, y] = place(node);
    panel.context.beginPath();
    panel.context.arc(x, y, 11, 0, 2 * Math.PI);
    panel.context.fillStyle = node.role === 'plain' ? colours.card : colours.roles[node.role];
    panel.context.fill();
    panel.context.strokeStyle = colours.line;
    panel.context.lineWidth = 1.4;
    panel.context.stroke();
    write(panel, colours.text, node.title[language], x, y + 22, 'center', 150);
  }
}

/** Each layer beside the others, with its own name and scale. */
function drawTable(player, { exhibit, canvas }) {
  const { colours } = player;
  const now = fieldAt(exhibit, player.t);
  if (!now) return;
  const panel = panelFrame(canvas, 200, [86, 28, 10, 44]);
  const pitch = panel.area.width / exhibit.layers.length;
  const { top, height, left } = panel.area;
  exhibit.layers.forEach((layer, index) => {
    const [x0, width] = [left + index * pitch, pitch - 14];
    const [wide, high] = [width / now.columns, height / now.rows];
    now.cells[index].forEach((byte, cell) => {
      const [r, g, b, a] = cellColour(layer, byte, colours);
      panel.context.fillStyle = `rgba(${r}, ${g}, ${b}, ${a / 255})`;
      const row = Math.floor(cell / now.columns);
      panel.context.fillRect(x0 + (cell % now.columns) * wide, top + height - (row + 1) * high, wide + 0.5, high + 0.5);
    });
    const unit = layer.unit ? ` [${layer.unit}]` : '';
    const range = layer.classes.length > 0 ? '' : ` ${shortNumber(layer.low)} – ${shortNumber(layer.high)}`;
    write(panel, colours.text, `${layer.title[language]}${unit}${range}`, x0, top - 12, 'left', width);
    const ticks = exhibit.across?.ticks ?? [];
    ticks.forEach((tick, i) => write(panel, colours.text, tick[language], x0 + (i + 0.5) * wide, top + height + 12, 'center', wide - 2));
    if (exhibit.across) write(panel, colours.text, named(exhibit.across), x0 + width / 2, top + height + 32, 'center', width);
  });
  (exhibit.up?.ticks ?? []).forEach((tick, i) => {
    write(panel, colours.text, tick[language], left - 6, top + height - ((i + 0.5) * height) / now.rows, 'right', 78);
  });
  if (exhibit.up) write(panel, colours.text, named(exhibit.up), left - 80, top - 12, 'left', 76);
}

function drawPanels(player) {
  for (const panel of player.panels) {
    const { exhibit, figure, caption, canvas } = panel;
    const state = exhibit.of === 'field' ? fieldAt(exhibit, player.t) : stateAt(exhibit, player.t);
    figure.hidden = !isSeen(player, exhibit) || !state;
    if (figure.hidden) continue;
    const title = exhibit.owner ? `${exhibit.title[language]}: ${exhibit.owner}` : exhibit.title[language];
    caption.textContent = title;
    canvas.setAttribute('aria-label', title);
    if (exhibit.of === 'curve') drawCurve(player, panel, state);
    if (exhibit.of === 'bars') drawBars(player, panel, state);
    if (exhibit.of === 'network') drawNetwork(player, panel, state);
    if (exhibit.of === 'field') drawTable(player, panel);
  }
}
