// What was shown, by form: fields as they were at a time, shapes where their frames were.

const UNKNOWN = 255;

/** Bytes that were packed as runs: how many more than one, then which. */
function unpackRuns(text, count) {
  const runs = unpack(text, 'u8');
  const bytes = new Uint8Array(count);
  let at = 0;
  for (let i = 0; i + 1 < runs.length; i += 2) {
    bytes.fill(runs[i + 1], at, at + runs[i] + 1);
    at += runs[i] + 1;
  }
  return bytes;
}

function decodeExhibit(exhibit) {
  if (!exhibit.states) return exhibit;
  const decoded = { ...exhibit, times: exhibit.states.map((state) => state.t), shown: -1 };
  if (exhibit.of === 'field') {
    decoded.states = exhibit.states.map((state) => ({
      ...state,
      cells: state.cells.map((layer) => unpackRuns(layer, state.columns * state.rows)),
    }));
  }
  return decoded;
}

/** What held at t of an exhibit that is told whole each time; nothing before the first. */
function stateAt(exhibit, t) {
  return exhibit.states[indexAt(exhibit.times, t)];
}

function applyPatch(now, patch) {
  const [column, row] = patch.at;
  patch.cells.forEach((bytes, layer) => {
    for (let r = 0; r < patch.rows; r += 1) {
      now.cells[layer].set(bytes.subarray(r * patch.columns, (r + 1) * patch.columns), (row + r) * now.columns + column);
    }
  });
}

/** The field as it was at t: {x, y, columns, rows, cells}; null before the first. */
function fieldAt(field, t) {
  const wanted = indexAt(field.times, t);
  if (wanted < 0) return null;
  if (wanted < field.shown || field.shown < 0) {
    field.shown = -1;
    let whole = wanted;
    while (field.states[whole].at) whole -= 1;
    field.shown = whole - 1;
  }
  while (field.shown < wanted) {
    field.shown += 1;
    const state = field.states[field.shown];
    if (state.at) applyPatch(field.now, state);
    else field.now = { ...state, cells: state.cells.map((layer) => layer.slice()) };
  }
  return field.now;
}

/** What a column of a robot says at t; "robot1/truth.x_m" is another robot's. */
function columnAt(run, robot, name, t) {
  const other = /^robot(\d+)\/(.*)$/.exec(name);
  const from = run.robots[other ? Number(other[1]) : Math.max(0, robot)];
  const values = from?.columns[other ? other[2] : name];
  const row = from ? indexAt(from.t, t) : -1;
  return values && row >= 0 ? values[row] : Number.NaN;
}

function followedBy(pose, local) {
  const [c, s] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + c * local.x - s * local.y, y: pose.y + s * local.x + c * local.y, yaw: pose.yaw + local.yaw };
}

/** The frame of that name that counts for whoever shows something in it. */
function findFrame(run, owner, name) {
  const rank = (one) => {
    if (one.of !== 'frame' || one.name !== name) return 0;
    if (one.robot === owner.robot && one.owner === owner.owner) return 3;
    return one.robot === owner.robot ? 2 : one.robot < 0 ? 1 : 0;
  };
  let best = null;
  for (const one of run.exhibits) if (rank(one) > (best ? rank(best) : 0)) best = one;
  return best;
}

/** Where a frame is in the world at t; null where it leads nowhere or what leads it has no reading. */
function frameAt(run, owner, name, t) {
  let pose = { x: 0, y: 0, yaw: 0 };
  for (let depth = 0; name !== 'world'; depth += 1) {
    const frame = depth < 32 && name !== '' ? findFrame(run, owner, name) : null;
    const now = frame && stateAt(frame, t);
    if (!now) return null;
    const [x, y, yaw] = now.columns.map((column) => (column === '' ? 0 : columnAt(run, frame.robot, column, t)));
    if (!Number.isFinite(x + y + yaw)) return null;
    pose = followedBy(followedBy(now, { x, y, yaw }), pose);
    name = now.in;
  }
  return pose;
}

/** The shapes that are there at t, each with its place and radius. */
function shapesAt(run, t, wanted) {
  const placed = [];
  for (const exhibit of run.exhibits) {
    if (exhibit.of !== 'marks' || !wanted(exhibit)) continue;
    for (const shape of exhibit.shapes) {
      if (shape.t > t || (shape.until !== undefined && shape.until <= t)) continue;
      const pose = frameAt(run, exhibit, shape.frame, t);
      if (!pose) continue;
      const told = shape.column ? columnAt(run, exhibit.robot, shape.column, t) : (shape.radius ?? 0);
      placed.push({ shape, pose, radius: Number.isFinite(told) && told > 0 ? told : 0 });
    }
  }
  return placed;
}
