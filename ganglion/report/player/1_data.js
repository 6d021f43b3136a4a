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
    columns: Object.fromEntries(Object.entries(robot.columns).map(([name, values]) => [name, unpack(values, 'f32')])),
  };
}

function decodeScene(scene) {
  if (!scene.map) return scene;
  const map = { ...scene.map, occupied: unpack(scene.map.occupied, 'u16'), unknown: unpack(scene.map.unknown, 'u16') };
  return { ...scene, map };
}

/** The run from the page's data block. */
function decodeRun(json) {
  return {
    ...json,
    scene: decodeScene(json.scene),
    robots: json.robots.map(decodeRobot),
    exhibits: json.exhibits.map(decodeExhibit),
  };
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

/** The candidate that drives at a row: its index, or -1. */
function activeAt(coordination, row) {
  return coordination && row >= 0 && row < coordination.active.length ? coordination.active[row] : -1;
}
