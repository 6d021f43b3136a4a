import { decodeMessage, type Sample } from './samples';
import type { Hello, StudioEvent } from './types';

export interface Listener {
  hello(hello: Hello): void;
  event(event: StudioEvent): void;
  sample(sample: Sample): void;
  connected(yes: boolean): void;
}

const kTooFarBehind = 4001;
const kLongestWait_ms = 1000;

/** Keeps a connection: comes back by itself and asks for the events it missed. */
export class Connection {
  private socket: WebSocket | null = null;
  private session = '';
  private seq = 0;
  private wait_ms = 250;
  private closed = false;

  constructor(
    private readonly url: string,
    private readonly listener: Listener,
  ) {
    this.open();
  }

  close(): void {
    this.closed = true;
    this.socket?.close();
  }

  private open(): void {
    const resume = this.session ? `&session=${this.session}&after=${this.seq}` : '';
    const socket = new WebSocket(`${this.url}?bundles=1${resume}`, 'ganglion.studio.v1');
    this.socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.onmessage = (message) => this.receive(message.data);
    socket.onclose = (close) => {
      if (this.closed) return;
      if (close.code === kTooFarBehind) this.session = '';
      this.listener.connected(false);
      setTimeout(() => this.open(), this.wait_ms);
      this.wait_ms = Math.min(kLongestWait_ms, this.wait_ms * 2);
    };
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== 'string') {
      for (const sample of decodeMessage(data)) this.listener.sample(sample);
      return;
    }
    const message = JSON.parse(data);
    if (message.type === 'hello') this.welcome(message);
    if (message.type === 'event' && message.seq > this.seq) {
      this.seq = message.seq;
      this.listener.event(message);
    }
  }

  private welcome(hello: Hello): void {
    this.wait_ms = 250;
    this.listener.connected(true);
    this.session = hello.session;
    if (hello.resumed) return;
    this.seq = hello.seq;
    this.listener.hello(hello);
  }
}
