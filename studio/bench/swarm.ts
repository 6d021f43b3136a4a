// A hundred robots, each with a controller of sixty components, in a walled yard with room for all.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const kSonars = 8;
const kRobot = `format = 1
name = "Swarmer"
tick_s = 0.03333333333333333

[body]
length_m = 0.24
width_m = 0.20

[drive]
kind = "Tracked"
full_scale_mps = 0.20
track_m = 0.18

[[sensor]]
id = "compass"
kind = "Compass"
noise_deg = 1.0

[[sensor]]
id = "place"
kind = "Position"
`;

function component(part: string, id: string, lines: string[]): string {
  return `\n[[${part}]]\nid = "${id}"\n${lines.join('\n')}\n`;
}

function robot(): string {
  let toml = kRobot;
  for (let i = 0; i < kSonars; i += 1)
    toml += component('sensor', `sonar${i}`, [
      'kind = "Sonar"',
      'x_m = 0.1',
      `yaw_deg = ${(i * 360) / kSonars - 157.5}`,
    ]);
  return toml;
}

/** Ten sensations, sixteen conditioners and the like, thirty-three behaviours and their coordinator. */
function controller(): string {
  let toml = 'format = 1\nname = "Sixty"\nrobot = "robot.toml"\n';
  const sensation = (id: string, channel: string) => component('sensation', id, [`channel = "${channel}"`]);
  toml += sensation('heading', 'compass.heading') + sensation('position', 'place.position');
  for (let i = 0; i < kSonars; i += 1) toml += sensation(`sonar${i}`, `sonar${i}.range`);
  for (let i = 0; i < kSonars; i += 1) {
    toml += component('sensing', `clear${i}`, ['kind = "SonarConditioner"', `in.raw_range = "sonar${i}"`]);
    toml += component('sensing', `closing${i}`, ['kind = "ClosingSpeed"', `in.range = "clear${i}.range"`]);
  }
  const eyes = (i: number) => [
    `in.left = "clear${(i + 4) % kSonars}.range"`,
    `in.right = "clear${(i + 3) % kSonars}.range"`,
  ];
  for (let i = 0; i < 11; i += 1) {
    toml += component('acting', `escape${i}`, [
      'kind = "Escape"',
      ...eyes(i),
      'in.heading = "heading"',
      `in.side = "avoid${i}.side@previous"`,
    ]);
  }
  for (let i = 0; i < 11; i += 1)
    toml += component('acting', `avoid${i}`, [
      'kind = "AvoidObstacle"',
      ...eyes(i),
      `in.escaping = "escape${i}.active"`,
    ]);
  for (let i = 0; i < 11; i += 1) {
    toml += component('acting', `hold${i}`, [
      'kind = "HoldHeading"',
      'in.heading = "heading"',
      `in.displaced_by = ["escape${i}.active@previous", "avoid${i}.active@previous"]`,
      ...eyes(i),
    ]);
  }
  const all = ['escape', 'avoid', 'hold'].flatMap((name) => Array.from({ length: 11 }, (_, i) => `"${name}${i}"`));
  return (
    toml +
    component('coordinator', 'arbiter', ['kind = "Priority"', `in.commands = [${all.join(', ')}]`, 'command = "drive"'])
  );
}

export const kComponents = 60;

/** Writes the experiment and names its controller. */
export function writeSwarm(folder: string, robots: number, duration_s: number): string {
  const at = join(folder, 'swarm');
  mkdirSync(at);
  writeFileSync(join(at, 'robot.toml'), robot());
  writeFileSync(join(at, 'controller.toml'), controller());
  writeFileSync(
    join(at, 'yard.toml'),
    'format = 1\n\n[[wall]]\npoints = [[-15, -15], [15, -15], [15, 15], [-15, 15]]\nclosed = true\n',
  );
  writeFileSync(
    join(at, 'experiment.toml'),
    `format = 1\nname = "Swarm"\ncontroller = "controller.toml"\n
[application]\nrobot = "robot.toml"\nworld = "yard.toml"\nrobots = ${robots}\n
[run]\nduration_s = ${duration_s}\nseed = 1\n`,
  );
  return 'swarm/controller.toml';
}
