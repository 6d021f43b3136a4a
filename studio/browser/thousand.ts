import type { Page } from 'playwright-core';

/** Five hundred sonars' readings, each conditioned. */
export function thousand(): string {
  let toml = 'format = 1\nname = "Thousand"\nrobot = "robot.toml"\n';
  for (let i = 0; i < 500; i += 1) {
    toml += `\n[[sensation]]\nid = "s${i}"\nchannel = "sonar_left.range"\n`;
    toml += `\n[[sensing]]\nid = "c${i}"\nkind = "SonarConditioner"\nin.raw_range = "s${i}"\n`;
  }
  return toml;
}

/** Frames a second while something is moved about by the mouse. */
export async function framesWhile(page: Page, move: (step: number) => Promise<void>): Promise<number> {
  await page.evaluate(() => {
    const counter = { frames: 0, since: performance.now() };
    (window as unknown as { counter: typeof counter }).counter = counter;
    const count = () => {
      counter.frames += 1;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  for (let step = 0; step < 60; step += 1) await move(step);
  return page.evaluate(() => {
    const { counter } = window as unknown as { counter: { frames: number; since: number } };
    return (1000 * counter.frames) / (performance.now() - counter.since);
  });
}
