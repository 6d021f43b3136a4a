"""Strangers and watchers who talk to a robot without pause: strangers.py PORT COUNT, until it is killed. One in two says
nothing but `{}`, line upon line, and comes again when it is sent away; the others watch, send heartbeats and never read
what they get."""

import json
import selectors
import socket
import sys

WATCH = json.dumps({"hello": {"major": 1, "role": "WATCH"}}).encode() + b"\n"
LINES = (b"{}\n" * 20000, b'{"beat":{"number":1}}\n{}\n' * 3000)


class Talker:
    def __init__(self, port: int, watches: bool):
        self.port, self.watches = port, watches
        self.stream, self.rest = None, b""

    def connect(self) -> bool:
        self.rest = (WATCH if self.watches else b"") + LINES[self.watches]
        self.stream = socket.socket()
        try:
            self.stream.connect(("127.0.0.1", self.port))
        except OSError:
            self.stream.close()
            self.stream = None
            return False
        self.stream.setblocking(False)
        return True

    def talk(self) -> None:
        try:
            sent = self.stream.send(self.rest)
            self.rest = self.rest[sent:] or LINES[self.watches]
            if not self.watches and not self.stream.recv(4096):
                raise ConnectionResetError
        except BlockingIOError:
            pass


def main() -> None:
    port, count = int(sys.argv[1]), int(sys.argv[2])
    selector = selectors.DefaultSelector()
    talkers = [Talker(port, n % 2 == 1) for n in range(count)]
    for one in talkers:
        if one.connect():
            selector.register(one.stream, selectors.EVENT_WRITE, one)
    print("talking", flush=True)
    while True:
        for key, _ in selector.select(0.01):
            try:
                key.data.talk()
            except OSError:
                selector.unregister(key.fileobj)
                key.fileobj.close()
                key.data.stream = None
        for one in talkers:
            if one.stream is None and one.connect():
                selector.register(one.stream, selectors.EVENT_WRITE, one)


if __name__ == "__main__":
    main()
