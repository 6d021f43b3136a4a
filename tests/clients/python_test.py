"""Robots in Python: python_test.py GANGLION SOURCE. Driven by the program, and asked line by line."""

import json
import math
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest

GANGLION, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
PYTHON = SOURCE / "clients/python"
MANUAL = SOURCE / "docs/manual/own_robot.md"
PATIENCE_S = 60


def free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


class Program:
    """A program that listens at a port; ended with the block."""

    def __init__(self, *words: str, port: int | None = None):
        self.port = port or free_port()
        self.words = [word.replace("PORT", str(self.port)) for word in words]

    def __enter__(self):
        self.process = subprocess.Popen(self.words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.printed = self.process.communicate()[0]

    def connect(self) -> socket.socket:
        end_s = time.monotonic() + PATIENCE_S
        while True:
            try:
                stream = socket.create_connection(("127.0.0.1", self.port))
                stream.settimeout(PATIENCE_S)
                return stream
            except ConnectionRefusedError:
                if self.process.poll() is not None or time.monotonic() > end_s:
                    raise


def robot(name: str) -> Program:
    return Program(sys.executable, str(PYTHON / name), "PORT")


class Session:
    """A connection to a robot, line by line."""

    def __init__(self, program: Program, **hello):
        self.stream = program.connect()
        self.file = self.stream.makefile()  # for reading only: writing to it would drop what was read ahead
        if hello:
            self.say("hello", major=1, **hello)
            self.hello, self.describe, self.first = self.hear("hello"), self.hear("describe"), self.hear("sense")

    def say(self, kind: str, **content):
        self.type(json.dumps({kind: content}))

    def type(self, line: str):
        self.stream.sendall(line.encode() + b"\n")

    def line(self) -> dict:
        text = self.file.readline()
        return json.loads(text) if text else {}

    def hear(self, kind: str) -> dict:
        line = self.line()
        assert kind in line, line
        return line[kind]

    def act(self, tick: int, left, right, **more) -> dict:
        self.say("act", tick=tick, values=[left, right], **more)
        return self.hear("sense")

    def close(self):
        self.file.close()
        self.stream.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Driven(unittest.TestCase):
    """By Nimrod's controller, with the experiment beside the robots: up to the wall, and not into it."""

    def drive(self, name: str, *more: str):
        with robot(name) as program, tempfile.TemporaryDirectory() as folder:
            program.connect().close()
            address = f"tcp://127.0.0.1:{program.port}"
            run = subprocess.run([GANGLION, "run", PYTHON, "--robot", address, "--out", folder, "--no-report", "--json", *more],
                                 capture_output=True, text=True, timeout=PATIENCE_S * 3)  # fmt: skip
            self.assertEqual(run.returncode, 0, run.stderr)
            of_run = json.loads(run.stdout)["runs"][0]
            self.assertEqual((of_run["success"], of_run["reason"]), (None, "duration over"), "it names no criterion")
            for attempt in range(100):  # the place of a commander may be held for a moment
                with Session(program) as session:
                    session.say("hello", major=1, pace="LOCK_STEP", role="COMMAND")
                    if "hello" in session.line():
                        session.hear("describe")
                        return session.hear("sense")["values"]
            self.fail("nobody may command any more")

    def test_by_hand_in_lock_step(self):
        ranges = self.drive("by_hand.py")
        self.assertLess(ranges[0] if ranges[0] != "Infinity" else 0, 3)

    def test_example_in_lock_step(self):
        values = self.drive("example.py", "--set", "run.duration_s=20")
        self.assertGreater(values[0], 0.1)
        self.assertLess(values[0], 3 - 20 * 0.2 / 3 + 0.2, "Nimrod drives at a third of 0.2 m/s and more")

    def test_example_free_running(self):
        values = self.drive("example.py", "--set", "application.pace=free_running", "--set", "run.duration_s=3")
        self.assertTrue(0.1 < values[0] < 2.95, values)


class Asked(unittest.TestCase):
    def test_keeps_limits_and_stops_within_a_long_step(self):
        with robot("example.py") as program, Session(program, pace=0) as session:
            self.assertTrue(session.describe["lock_step"] and session.describe["free_running"])
            self.assertEqual(session.first["values"], [3.0, 3.0, 0.0])
            self.assertAlmostEqual(session.act(0, 70, 70)["values"][0], 2.98)
            self.assertEqual(session.act(1, "NaN", "Infinity")["values"][0], session.act(2, 0, 0)["values"][0])
            there_m = session.act(3, 1, 1, step_s=10, ttl_ms=500)["values"][0]
            self.assertAlmostEqual(there_m, 2.98 - 0.5 * 0.2)

    def test_does_no_tick_twice_and_none_to_come(self):
        with robot("example.py") as program, Session(program, pace="LOCK_STEP") as session:
            once = session.act(0, 1, 1)
            self.assertEqual(session.act(0, 1, 1), once)
            session.say("act", tick=5, values=[1, 1])
            self.assertEqual(session.hear("bye")["code"], 3)

    def test_goes_on_with_a_session_whose_connection_broke(self):
        with robot("example.py") as program:
            with Session(program, pace=0) as session:
                before = session.act(0, 1, 1)
                token = session.hello["token"]
            with Session(program, pace=0, token=token, last_tick=1) as session:
                self.assertTrue(session.hello["resumed"])
                self.assertEqual(session.first, before)
                self.assertEqual(session.act(1, 1, 1)["tick"], 2)
                with Session(program) as other:
                    other.say("hello", major=1, token="of another time")
                    self.assertEqual(other.hear("bye")["code"], 6)

    def test_has_one_commander_and_lets_others_watch(self):
        with robot("example.py") as program, Session(program, pace=0) as session:
            with Session(program) as second:
                second.say("hello", major=1)
                self.assertEqual(second.hear("bye")["code"], 2)
            with Session(program, role="WATCH") as watcher:
                seen = session.act(0, 1, 1)
                self.assertEqual(watcher.hear("sense"), seen)
                watcher.say("act", tick=1, values=[1, 1])
                self.assertEqual(watcher.hear("bye")["code"], 3)

    def test_stops_by_itself_when_the_socket_is_closed(self):
        with robot("example.py") as program:
            with Session(program, pace=1) as session:
                session.say("act", tick=1, values=[1, 1], ttl_ms=200)
                before = session.first["values"][0]
                while (now := session.hear("sense"))["values"][0] == before:
                    pass
                token = session.hello["token"]
            moved = [now]
            with Session(program, pace=1, token=token) as session:
                moved.append(session.first)
                while moved[-1]["values"][0] != moved[-2]["values"][0] or moved[-1]["time_s"] == moved[-2]["time_s"]:
                    moved.append(session.hear("sense"))
                    self.assertLess(before - moved[-1]["values"][0], 0.5, "it does not stop")
            way_m = before - moved[-1]["values"][0]
            self.assertGreater(way_m, 0)
            self.assertLess(way_m, 0.3, "0.2 m/s for 0.2 s make 0.04 m; this machine may be busy")

    def test_answers_beats_and_resets(self):
        with robot("example.py") as program, Session(program, pace=0) as session:
            session.say("beat", number=7)
            self.assertEqual((lambda beat: (beat["number"], beat["answer"]))(session.hear("beat")), (7, True))
            session.act(0, 1, 1)
            session.say("reset", seed="18446744073709551615", episode=2)
            self.assertEqual(session.hear("reset"), {"seed": "18446744073709551615", "episode": 2})
            self.assertEqual(session.hear("sense")["values"][0], 3.0)

    def test_tells_who_breaks_the_rules_and_goes_on(self):
        rubbish = ("{", "{}[", '{"act":{}}', '{"hello":{"major":9}}', '{"hello":{"major":[]}}', "nonsense", "\0\0\0\2",
                   '{"hello":' + "[" * 3000, '{"a":"' + "x" * 5000 + '"}')  # fmt: skip
        with robot("example.py") as program:
            for line in rubbish:
                with Session(program) as session:
                    session.type(line)
                    self.assertTrue(session.hear("bye")["reason"], line)
            bad = ({"values": [1]}, {"values": [1, []]}, {"values": "1"}, {"values": [1, 1], "step_s": -1},
                   {"values": [1, 1], "tick": 1.5}, {"values": [1, 1], "ttl_s": [1, 2, 3]})  # fmt: skip
            for act in bad:
                with Session(program, pace=0) as session:
                    session.say("act", **({"tick": 0} | act))
                    self.assertEqual(session.hear("bye")["code"], 3, act)


class Manual(unittest.TestCase):
    def block(self, begins: str) -> str:
        blocks = re.findall(r"^```\w*\n(.*?)^```", MANUAL.read_text(), re.S | re.M)
        return next(block for block in blocks if block.startswith(begins))

    def test_shows_the_robot_of_thirty_lines(self):
        file = (PYTHON / "by_hand.py").read_text()
        self.assertEqual(self.block(file.splitlines()[0]), file)

    def test_shows_what_the_program_says_to_nc(self):
        lines = self.block("$ ganglion sim").splitlines()
        words = lines[0].removeprefix("$ ganglion ").replace("7007", "PORT").split()
        words = [str(SOURCE / word) if word.startswith("experiments/") else word for word in words]
        with Program(GANGLION, *words) as program, Session(program) as session:
            for line in lines[2:]:
                if line.startswith("> "):
                    session.type(line[2:])
                    continue
                pattern = re.escape(line).replace(re.escape("..."), ".*")
                self.assertRegex(session.file.readline(), f"^{pattern}\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
