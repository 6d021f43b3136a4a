import type { Locator, Page } from 'playwright-core';

/** One controller as data: what a user builds step by step, with mouse or keyboard. */
export interface Plan {
  robot: string;
  file: string;
  name: string;
  tick_s?: number;
  add: { label: string; id: string }[];
  wires: { from: string; id: string; port: string; previous?: boolean }[];
  set: { id: string; key: string; value: string }[];
  command: { id: string; name: string };
  /** Runs it in the simulation until its goal is reached, before it is saved. */
  run?: boolean;
}

/** Figure 6 of the paper, as experiments/pathfinder/controller.toml has it. */
export const kPathfinder: Plan = {
  robot: 'pathfinder/robot.toml',
  file: 'rebuilt',
  name: 'Pathfinder',
  add: [
    { label: 'trainer.goal', id: 'goal' },
    { label: 'trainer.direction', id: 'goal_direction' },
    { label: 'place.position', id: 'position' },
    { label: 'compass.heading', id: 'heading' },
    { label: 'bumper.contact', id: 'contact' },
    { label: 'GridCell', id: 'cell' },
    { label: 'App', id: 'app' },
    { label: 'DynamicMapRouter', id: 'router' },
  ],
  wires: [
    { from: 'position', id: 'cell', port: 'position' },
    { from: 'goal', id: 'app', port: 'request' },
    { from: 'app', id: 'router', port: 'goal' },
    { from: 'cell', id: 'router', port: 'cell' },
    { from: 'position', id: 'router', port: 'position' },
    { from: 'heading', id: 'router', port: 'heading' },
    { from: 'contact', id: 'router', port: 'contact' },
    { from: 'goal_direction', id: 'router', port: 'goal_direction' },
  ],
  set: [
    { id: 'cell', key: 'cell_m', value: '0.5' },
    { id: 'router', key: 'cell_m', value: '0.5' },
    { id: 'router', key: 'backward_weight', value: '1' },
  ],
  command: { id: 'router', name: 'step' },
  run: true,
};

/** Nimrod's three behaviours and their coordinator. */
export const kNimrod: Plan = {
  robot: 'nimrod/robot.toml',
  file: 'rebuilt',
  name: 'Nimrod',
  tick_s: 0.1,
  add: [
    { label: 'sonar_left.range', id: 'sonar_left' },
    { label: 'sonar_right.range', id: 'sonar_right' },
    { label: 'compass.heading', id: 'heading' },
    { label: 'SonarConditioner', id: 'clear_left' },
    { label: 'SonarConditioner', id: 'clear_right' },
    { label: 'Escape', id: 'escape' },
    { label: 'AvoidObstacle', id: 'avoid' },
    { label: 'HoldHeading', id: 'hold' },
    { label: 'Priority', id: 'arbiter' },
  ],
  wires: [
    { from: 'sonar_left', id: 'clear_left', port: 'raw_range' },
    { from: 'sonar_right', id: 'clear_right', port: 'raw_range' },
    { from: 'clear_left.range', id: 'escape', port: 'left' },
    { from: 'clear_right.range', id: 'escape', port: 'right' },
    { from: 'heading', id: 'escape', port: 'heading' },
    { from: 'avoid.side', id: 'escape', port: 'side', previous: true },
    { from: 'clear_left.range', id: 'avoid', port: 'left' },
    { from: 'clear_right.range', id: 'avoid', port: 'right' },
    { from: 'heading', id: 'hold', port: 'heading' },
    { from: 'escape.active', id: 'hold', port: 'displaced_by', previous: true },
    { from: 'avoid.active', id: 'hold', port: 'displaced_by', previous: true },
    { from: 'clear_left.range', id: 'hold', port: 'left' },
    { from: 'clear_right.range', id: 'hold', port: 'right' },
    { from: 'escape', id: 'arbiter', port: 'commands' },
    { from: 'avoid', id: 'arbiter', port: 'commands' },
    { from: 'hold', id: 'arbiter', port: 'commands' },
  ],
  set: [
    { id: 'clear_left', key: 'readings', value: '1' },
    { id: 'clear_right', key: 'readings', value: '1' },
    { id: 'escape', key: 'trigger_range_m', value: '0.1' },
    { id: 'avoid', key: 'trigger_range_m', value: '0.4' },
    { id: 'avoid', key: 'commit_range_m', value: '0.35' },
    { id: 'hold', key: 'hold_s', value: '3' },
    { id: 'hold', key: 'hold_growth', value: '3' },
    { id: 'hold', key: 'hold_return', value: '1' },
    { id: 'hold', key: 'slow_range_m', value: '0.4' },
  ],
  command: { id: 'arbiter', name: 'drive' },
};

/** A way of working: what each step is done with. */
export interface Hand {
  start(page: Page, plan: Plan): Promise<void>;
  add(page: Page, label: string, id: string, index: number): Promise<void>;
  wire(page: Page, wire: Plan['wires'][number]): Promise<void>;
  set(page: Page, id: string, key: string, value: string): Promise<void>;
  command(page: Page, id: string, name: string): Promise<void>;
  /** Configures the built-in simulation, as fast as can be, and runs. */
  run(page: Page): Promise<void>;
  save(page: Page): Promise<void>;
}

export function box(page: Page, id: string): Locator {
  return page.locator(`.box[data-component="${id}"]`);
}

export async function build(page: Page, plan: Plan, hand: Hand): Promise<void> {
  await hand.start(page, plan);
  for (const [index, one] of plan.add.entries()) await hand.add(page, one.label, one.id, index);
  for (const one of plan.wires) await hand.wire(page, one);
  for (const one of plan.set) await hand.set(page, one.id, one.key, one.value);
  await hand.command(page, plan.command.id, plan.command.name);
  if (plan.tick_s) await hand.set(page, '', 'tick_s', `${plan.tick_s}`);
  if (plan.run) {
    await hand.run(page);
    await page
      .locator('.events')
      .getByText(/goal 1 at cell .*: reached/)
      .waitFor({ timeout: 30_000 });
    await page.locator('.outcome.good').waitFor({ timeout: 30_000 });
  }
  await hand.save(page);
}
