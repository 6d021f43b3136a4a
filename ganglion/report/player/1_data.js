// The run as the page carries it: decoded once into typed arrays, asked by time afterwards.

const NO_READING = 65535;
const NOTHING_IN_RANGE = 65534;
const TOO_CLOSE = 65533;

/** Little-endian numbers packed as base64: 'f32', 'u16', 'i8', 'u8' or 'u32'. */
function unpack(text, type) {
  const bytes = Uint8Array.from(atob(text || ''), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const readers = {
    f32: [4, Float32Array, (i) => view.getFloat32(i, true)],
    u32: [4, Uint32Array, (i) => view.getUint32(i, true)],
    u16: [2, Uint16Array, (i) => view.getUint16(i, true)],
    i8: [1, Int8Array, (i) => view.getInt8(i)],
    u8: [1, Uint8Array, (i) => view.getUint8(i)],
  };
  const [size, Kind, read] = readers[type];
  const values = new Kind(Math.floor(bytes.length / size));
  for (let i = 0; i < values.length; i += 1) values[i] = read(i * size);
  return values;
}

/** Index of the last entry not later than t; -1 before the first. `times` ascends. */
function indexAt(times, t) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

function decodeMap(map) {
  const frames = map.frames.map((frame) => ({ t: frame.t, changes: unpack(frame.changes, 'u32') }));
  const cells = map.columns * map.rows;
  return {
    ...map,
    frames,
    times: frames.map((frame) => frame.t),
    shown: -1,
    label: new Uint8Array(cells),
    risk: new Uint8Array(cells),
    dynamic: new Uint8Array(cells),
    inhibited: new Uint8Array(cells),
  };
}

function decodeRobot(robot) {
  return {
    ...robot,
    t: unpack(robot.t, 'f32'),
    x: unpack(robot.x, 'f32'),
    y: unpack(robot.y, 'f32'),
    yaw: unpack(robot.yaw, 'f32'),
    touching: unpack(robot.touching, 'u8'),
    sensors: robot.sensors.map((sensor) => ({ ...sensor, readings: unpack(sensor.readings, 'u16') })),
    coordinations: robot.coordinations.map((c) => ({
      ...c,
      active: unpack(c.active, 'i8'),
      wanted: unpack(c.wanted, 'u8'),
      shares: unpack(c.shares, 'u8'),
    })),
    maps: robot.maps.map(decodeMap),
  };
}

function decodeScene(scene) {
  if (!scene.map) return scene;
  const map = { ...scene.map, occupied: unpack(scene.map.occupied, 'u16'), unknown: unpack(scene.map.unknown, 'u16') };
  return { ...scene, map };
}

/** The run from the page's data block. */
function decodeRun(json) {
  return { ...json, scene: decodeScene(json.scene), robots: json.robots.map(decodeRobot) };
}

/** A reading in metres; the three that are no range as NaN, Infinity and -Infinity. */
function reading(sensor, row) {
  const packed = sensor.readings[row];
  if (packed === undefined || packed === NO_READING) return Number.NaN;
  if (packed === NOTHING_IN_RANGE) return Number.POSITIVE_INFINITY;
  if (packed === TOO_CLOSE) return Number.NEGATIVE_INFINITY;
  return packed * sensor.unit_m;
}

function between(a, b, part) {
  return a + (b - a) * part;
}

function turnBetween(a, b, part) {
  const turn = Math.atan2(Math.sin(b - a), Math.cos(b - a));
  return a + turn * part;
}

/** Where a robot is at t, between two rows too where `smooth`; null where that is unknown. */
function poseAt(robot, t, smooth) {
  const row = indexAt(robot.t, t);
  if (row < 0 || !Number.isFinite(robot.x[row] + robot.y[row])) return null;
  const pose = { row, x: robot.x[row], y: robot.y[row], yaw: robot.yaw[row] || 0, touching: robot.touching[row] === 1 };
  const next = row + 1;
  if (!smooth || next >= robot.t.length || !Number.isFinite(robot.x[next] + robot.y[next])) return pose;
  const part = (t - robot.t[row]) / (robot.t[next] - robot.t[row]);
  if (!(part > 0 && part < 1)) return pose;
  pose.x = between(pose.x, robot.x[next], part);
  pose.y = between(pose.y, robot.y[next], part);
  pose.yaw = turnBetween(pose.yaw, robot.yaw[next] || 0, part);
  return pose;
}

function applyChanges(map, changes) {
  for (let i = 0; i + 1 < changes.length; i += 2) {
    const cell = changes[i];
    const packed = changes[i + 1];
    map.risk[cell] = packed & 255;
    map.inhibited[cell] = (packed >>> 8) & 255;
    map.label[cell] = (packed >>> 16) & 3;
    map.dynamic[cell] = (packed >>> 18) & 1;
  }
}

/** Brings a map to what was known at t. */
function showMapAt(map, t) {
  const wanted = indexAt(map.times, t);
  if (wanted < map.shown) {
    for (const layer of [map.label, map.risk, map.dynamic, map.inhibited]) layer.fill(0);
    map.shown = -1;
  }
  while (map.shown < wanted) {
    map.shown += 1;
    applyChanges(map, map.frames[map.shown].changes);
  }
}

/** The candidate that drives at a row: its index, or -1. */
function activeAt(coordination, row) {
  return coordination && row >= 0 && row < coordination.active.length ? coordination.active[row] : -1;
}
