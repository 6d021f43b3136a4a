"""Time before bytes: strangers_test.py GANGLION SOURCE. Strangers and watchers talk to the robot in Python without pause:
GANGLION_STRANGERS of them (default 12), while it stops GANGLION_STOPS times (default 5). What is asserted is counted by
the robot; with GANGLION_STOPS from 100 on the delays are asserted as well, those of `ganglion sim` too."""

import os
import pathlib
import statistics
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from python_test import GANGLION, SOURCE, Program, Session  # noqa: E402

HERE = pathlib.Path(__file__).parent
STRANGERS = int(os.environ.get("GANGLION_STRANGERS", "12"))
STOPS = int(os.environ.get("GANGLION_STOPS", "5"))
MOST_FRAMES, MOST_BYTES = 64, 65536
TTL_MS = 100


def counting() -> Program:
    return Program(sys.executable, str(HERE / "counting_robot.py"), "PORT")


class Talking:
    """Strangers, as long as the block."""

    def __init__(self, program: Program, count: int):
        self.words = [sys.executable, str(HERE / "strangers.py"), str(program.port), str(count)]

    def __enter__(self):
        self.process = subprocess.Popen(self.words, stdout=subprocess.PIPE, text=True)
        self.process.stdout.readline()
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()


def stops(session: Session, count: int, acts: list) -> list[float]:
    """Seconds from an Act to the stop that its time to live brings, by the robot's own look at the clock."""
    delays_s = []
    for _ in range(count):
        seen = session.hear("sense")
        acts.append(time.monotonic())
        session.say("act", tick=seen["tick"], values=[1, 0.25, 0], ttl_ms=TTL_MS)
        while seen["values"][2] < acts[-1]:
            seen = session.hear("sense")
        delays_s.append(seen["values"][2] - acts[-1])
    return delays_s


def stops_of_sim(session: Session, count: int) -> list[float]:
    """The same until a Sense comes in which the simulated robot stands."""
    delays_s = []
    for _ in range(count):
        seen = session.hear("sense")
        begun_s = time.monotonic()
        session.say("act", tick=seen["tick"], values=[0.3 if len(delays_s) % 2 else -0.3] * 2, ttl_ms=TTL_MS)
        moved, before = False, seen["truth_values"][:2]
        while True:
            now = session.hear("sense")["truth_values"][:2]
            if moved and now == before:
                break
            moved, before = moved or now != before, now
        delays_s.append(time.monotonic() - begun_s)
    return delays_s


class Strangers(unittest.TestCase):
    def judge(self, name: str, alone_s: list[float], beset_s: list[float]):
        later_s = statistics.median(beset_s) - statistics.median(alone_s), max(beset_s) - max(alone_s)
        print(f"{name}: {len(beset_s)} stops, {STRANGERS} strangers: median {later_s[0]:.4f} s later, worst "
              f"{later_s[1]:.4f} s later", flush=True)  # fmt: skip
        if STOPS >= 100:
            self.assertLessEqual(later_s[0], 0.05)
            self.assertLessEqual(later_s[1], 0.25)

    def test_hold_no_look_at_the_time_to_live_off(self):
        with counting() as program, Session(program, pace=1) as session:
            alone_s = stops(session, STOPS, [])
            with Talking(program, STRANGERS):
                beset_s = stops(session, STOPS, [])
                most_frames, most_bytes, _, connections = session.hear("sense")["values"]
        self.assertGreater(connections, 1, "they do talk to it")
        self.assertTrue(1 <= most_frames <= MOST_FRAMES, most_frames)
        self.assertTrue(1 <= most_bytes <= MOST_BYTES, most_bytes)
        self.judge("the robot in Python", alone_s, beset_s)

    def test_are_sent_away_unless_they_say_hello(self):
        with counting() as program:
            for line in ("{}", '{"telepathy":{}}', '{"beat":{}}', '{"bye":{}}', '{"hello":3}', "[]"):
                with Session(program) as session:
                    session.type(line)
                    self.assertEqual(session.hear("bye")["code"], 3, line)
                    self.assertEqual(session.line(), {}, line)

    def test_that_watch_are_heard_to_the_last_line(self):
        with counting() as program, Session(program, pace=1) as session, Session(program, role="WATCH") as watcher:
            watcher.type("{}\n" * 1000 + '{"beat":{"number":7}}')
            session.say("beat", number=1)
            while "beat" not in session.line():
                pass
            while "beat" not in (line := watcher.line()):
                self.assertIn("sense", line)
            self.assertEqual(line["beat"]["number"], 7)

    @unittest.skipIf(STOPS < 100, "of the program, only with GANGLION_STOPS=100 or more")
    def test_hold_no_stop_of_the_simulation_off(self):
        words = (GANGLION, "sim", str(SOURCE / "experiments/nimrod/box.toml"), "--listen", "127.0.0.1:PORT", "--quiet")
        with Program(*words) as program, Session(program, pace=1, truth=True) as session:
            alone_s = stops_of_sim(session, STOPS)
            with Talking(program, STRANGERS):
                beset_s = stops_of_sim(session, STOPS)
        self.judge("ganglion sim", alone_s, beset_s)


class Survives(unittest.TestCase):
    def test_a_name_that_is_no_text(self):
        with counting() as program:
            with Session(program) as session:
                session.type('{"hello":{"major":1,"pace":1,"name":"\\ud800\\u0007"}}')
                session.hear("hello")
                with Session(program) as other:
                    other.say("hello", major=1, pace=1)
                    self.assertIn("?? commands this robot", other.hear("bye")["reason"])
            self.greet_again(program)
        self.assertIn("?? commands, free-running", program.printed)

    def test_numbers_that_json_cannot_tell(self):
        with counting() as program:
            with Session(program, pace=1) as session:
                session.type('{"reset":{"seed":"1","episode":2,"mood":NaN}}')
                while "reset" not in (line := session.line()):
                    pass
                self.assertEqual(line["reset"], {"seed": "1", "episode": 2})
                session.type('{"act":{"tick":1,"values":[' + "9" * 5000 + ",0,0]}}")
                while "bye" not in (line := session.line()):
                    pass
                self.assertEqual(line["bye"]["code"], 3)
            self.greet_again(program)

    def test_a_robot_that_fails(self):
        """Its act() fails at the command and twice more at the safe values: it is asked until it did them."""
        with counting() as program:
            with Session(program, pace=1) as session:
                session.say("act", tick=1, values=[1, 0.25, 1])
                while "bye" not in (line := session.line()):
                    pass
                self.assertEqual(line["bye"]["code"], 8)
                self.assertIn("the horn is broken", line["bye"]["reason"])
            self.greet_again(program)
        self.assertIn("the robot's program failed: RuntimeError", program.printed)

    def greet_again(self, program: Program):
        for _ in range(100):  # the place of a commander may be held for a moment
            with Session(program) as session:
                session.say("hello", major=1, pace=1)
                if "hello" in session.line():
                    self.assertIn("describe", session.line())
                    return self.assertIn("sense", session.line())
            time.sleep(0.1)
        self.fail("nobody may command any more")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
