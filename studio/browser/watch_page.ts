import type { CDPSession, Page } from 'playwright-core';

/** Lives in the page: tells when what a key changed was painted. */
interface PageWatch {
  key_ms: number;
  changed: boolean;
  painted_ms: number;
}

const kQuiet_ms = 120;

/** From now on the page notes each key, each change of its elements and the end of each frame that shows one. */
export async function watchPage(page: Page): Promise<void> {
  await page.evaluate(() => {
    const watch: PageWatch = { key_ms: 0, changed: false, painted_ms: 0 };
    (window as unknown as { watch: PageWatch }).watch = watch;
    addEventListener(
      'keydown',
      (event) => {
        watch.key_ms = event.timeStamp;
      },
      true,
    );
    new MutationObserver(() => {
      watch.changed = true;
    }).observe(document.body, {
      subtree: true,
      childList: true,
      attributes: true,
      characterData: true,
    });
    // The task after a frame's callbacks begins when style, layout and paint of that frame are done.
    const painted = new MessageChannel();
    painted.port1.onmessage = () => {
      watch.painted_ms = performance.now();
    };
    const frame = () => {
      if (watch.changed) painted.port2.postMessage(0);
      watch.changed = false;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
}

export interface Taken {
  /** From the key's own time stamp to the end of the last frame that it changed. */
  shown_ms: number;
  /** What the page's main thread was busy with in that time, and until it was quiet. */
  busy_ms: number;
}

async function busy_s(session: CDPSession): Promise<number> {
  const { metrics } = await session.send('Performance.getMetrics');
  return metrics.find((one) => one.name === 'TaskDuration')?.value ?? 0;
}

/** Presses a key and waits until nothing changes any more. */
export async function timeKey(page: Page, session: CDPSession, key: string): Promise<Taken> {
  const before = await busy_s(session);
  await page.evaluate(() => {
    (window as unknown as { watch: PageWatch }).watch.painted_ms = 0;
  });
  await page.keyboard.press(key);
  const shown_ms = await page.evaluate(async (quiet_ms) => {
    const { watch } = window as unknown as { watch: PageWatch };
    const asked = performance.now();
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve, 20));
      const now = performance.now();
      if (watch.painted_ms > watch.key_ms && now - watch.painted_ms > quiet_ms) break;
      if (now - asked > 5000) throw new Error('the key changed nothing');
    }
    return watch.painted_ms - watch.key_ms;
  }, kQuiet_ms);
  return { shown_ms, busy_ms: 1000 * ((await busy_s(session)) - before) };
}
