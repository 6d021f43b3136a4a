import { connect, type Socket } from 'node:net';

/** Watches a run as a page does, and only counts what it is sent. */
export class Viewer {
  bytes = 0;
  private constructor(private readonly socket: Socket) {}

  static async come(url: string): Promise<Viewer> {
    const { hostname, port, host, searchParams } = new URL(url);
    const socket = connect(Number(port), hostname);
    const viewer = new Viewer(socket);
    await new Promise<void>((resolve, reject) => {
      socket.once('data', (data) => {
        if (data.toString('latin1').startsWith('HTTP/1.1 101')) resolve();
        else reject(new Error(data.toString('latin1')));
      });
      socket.once('error', reject);
      socket.write(
        `GET /ws?bundles=1 HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nAuthorization: Bearer ${searchParams.get('token')}\r\n` +
          'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n' +
          'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n',
      );
    });
    socket.on('data', (data) => {
      viewer.bytes += data.length;
    });
    return viewer;
  }

  leave(): void {
    this.socket.destroy();
  }
}

/** Asks as a script does. */
export async function ask<T>(url: string, path: string, body?: object): Promise<T> {
  const { origin, searchParams } = new URL(url);
  const headers = { Authorization: `Bearer ${searchParams.get('token')}`, Origin: origin };
  const answer = await fetch(
    origin + path,
    body ? { method: 'POST', headers, body: JSON.stringify(body) } : { headers },
  );
  if (!answer.ok) throw new Error(await answer.text());
  return (await answer.json()) as T;
}
