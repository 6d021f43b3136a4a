// A studio of its own for each test file: the built program on a copy of the examples, and a browser to use it with.
import { type ChildProcess, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';

const kHere = dirname(fileURLToPath(import.meta.url));
const kRoot = join(kHere, '..', '..');
export const kShots = join(kHere, '..', 'screenshots');

export const kProgram = process.env.GANGLION_PROGRAM ?? join(kRoot, 'build', 'release', 'bin', 'ganglion');

const kPatience_ms = 6_000;

export interface Looks {
  name: string;
  options: BrowserContextOptions;
}

/** The four looks every page is made for. */
export const kLooks: Looks[] = [
  { name: 'light', options: { viewport: { width: 1280, height: 800 }, locale: 'en', colorScheme: 'light' } },
  { name: 'dark', options: { viewport: { width: 1280, height: 800 }, locale: 'en', colorScheme: 'dark' } },
  { name: 'spanish', options: { viewport: { width: 1280, height: 800 }, locale: 'es', colorScheme: 'light' } },
  {
    name: 'phone',
    options: {
      viewport: { width: 390, height: 844 },
      locale: 'en',
      colorScheme: 'light',
      hasTouch: true,
      isMobile: true,
    },
  },
];

function chromiumPath(): string {
  const found = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(
    (path) => path && existsSync(path),
  );
  if (!found) throw new Error('there is no Chromium: install the package chromium, or name it in CHROMIUM');
  return found;
}

export async function urlOf(server: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = '';
    server.stdout?.on('data', (data: Buffer) => {
      said += data.toString();
      const url = said.match(/http:\/\/\S+/);
      if (url) resolve(url[0]);
    });
    server.stderr?.on('data', (data: Buffer) => {
      said += data.toString();
    });
    server.on('exit', () => reject(new Error(`the studio's server ended: ${said}`)));
  });
}

export class Studio {
  private constructor(
    readonly folder: string,
    private server: ChildProcess,
    public url: string,
    private readonly browser: Browser,
  ) {}

  /** `programs`: what the user's own studio.toml holds. */
  static async start(programs = ''): Promise<Studio> {
    const folder = mkdtempSync(join(tmpdir(), 'ganglion_studio_'));
    cpSync(join(kRoot, 'experiments'), folder, { recursive: true });
    mkdirSync(kShots, { recursive: true });
    mkdirSync(join(folder, '.config', 'ganglion'), { recursive: true });
    if (programs) writeFileSync(join(folder, '.config', 'ganglion', 'studio.toml'), programs);
    const server = Studio.serve(folder);
    const url = await urlOf(server);
    const browser = await chromium.launch({ executablePath: chromiumPath(), args: ['--no-sandbox'] });
    return new Studio(folder, server, url, browser);
  }

  private static serve(folder: string, listen = '127.0.0.1:0'): ChildProcess {
    const roots = process.env.GANGLION_WEB_ROOT ? ['--web-root', process.env.GANGLION_WEB_ROOT] : [];
    const listed = { ...process.env, XDG_CONFIG_HOME: join(folder, '.config') };
    return spawn(kProgram, ['studio', folder, '--listen', listen, ...roots, '--no-browser'], { env: listed });
  }

  /** Of the server. */
  get pid(): number {
    return this.server.pid ?? 0;
  }

  /** The browser's processes, the busiest page's first. */
  async browserPids(): Promise<number[]> {
    const session = await this.browser.newBrowserCDPSession();
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    await session.detach();
    const rank = (one: { type: string; cpuTime: number }) => (one.type === 'renderer' ? 1e6 : 0) + one.cpuTime;
    return processInfo.sort((a, b) => rank(b) - rank(a)).map((one) => one.id);
  }

  /** As if the machine had failed: nothing is said goodbye to. */
  async kill(): Promise<void> {
    const ended = new Promise((resolve) => this.server.once('exit', resolve));
    this.server.kill('SIGKILL');
    await ended;
  }

  /** On the same port as before, so that pages that are open find it again. */
  async restart(): Promise<void> {
    this.server = Studio.serve(this.folder, new URL(this.url).host);
    this.url = await urlOf(this.server);
  }

  /** A page that complains to the test of every error in it. */
  page(options: BrowserContextOptions = kLooks[0].options): Promise<Page> {
    return this.visit(this.url, options);
  }

  /** The same of another server. */
  async visit(url: string, options: BrowserContextOptions = kLooks[0].options): Promise<Page> {
    const context = await this.browser.newContext(options);
    const page = await context.newPage();
    page.setDefaultTimeout(kPatience_ms);
    page.on('pageerror', (error) => {
      throw error;
    });
    await page.goto(url);
    await page.locator('.shell').waitFor();
    return page;
  }

  async stop(): Promise<void> {
    await this.browser.close();
    this.server.kill('SIGKILL');
    rmSync(this.folder, { recursive: true, force: true });
  }
}

export async function open(page: Page, path: string): Promise<void> {
  if ((page.viewportSize()?.width ?? 0) <= 900) {
    await page.locator('.phone-tabs button').first().click();
  } else {
    await page.locator('.left .tabs button').first().click();
  }
  await page.locator('.file-list button', { hasText: path }).first().click();
  await page.locator('.box').first().waitFor();
}

/** Starts what is drawn. Until the page has heard of the new run, it still shows the one before. */
export async function runDrawn(page: Page): Promise<void> {
  const started = page.waitForResponse((response) => response.url().endsWith('/api/run/start'));
  await page.locator('.canvas').focus();
  await page.keyboard.press('F5');
  const { run } = await (await started).json();
  await page.locator(`.run-now[data-run="${run}"]`).waitFor();
}

export async function shot(page: Page, name: string): Promise<void> {
  await page.screenshot({ path: join(kShots, `${name}.png`) });
}
