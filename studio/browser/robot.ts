// A robot in a process of its own, for the studio to be connected with: `ganglion sim EXPERIMENT --listen`.
import { type ChildProcess, spawn } from 'node:child_process';
import { join } from 'node:path';
import { kProgram } from './studio';

export class Robot {
  private constructor(
    private readonly program: ChildProcess,
    readonly address: string,
  ) {}

  static async start(folder: string, experiment: string): Promise<Robot> {
    const program = spawn(kProgram, ['sim', join(folder, experiment), '--listen', '127.0.0.1:0']);
    const address = await new Promise<string>((resolve, reject) => {
      let said = '';
      const listen = (data: Buffer) => {
        said += data.toString();
        const found = said.match(/listens at (\S+);/);
        if (found) resolve(found[1]);
      };
      program.stdout?.on('data', listen);
      program.stderr?.on('data', listen);
      program.on('exit', () => reject(new Error(`the robot ended: ${said}`)));
    });
    return new Robot(program, address);
  }

  /** As if its battery fell out. */
  async kill(): Promise<void> {
    if (this.program.exitCode !== null || this.program.signalCode !== null) return;
    const ended = new Promise((resolve) => this.program.once('exit', resolve));
    this.program.kill('SIGKILL');
    await ended;
  }
}
