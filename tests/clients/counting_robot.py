"""A robot for tests, described by bench_robot.toml: counting_robot.py PORT. It senses what it took between two looks at
its times to live, and when it was last told to stop; its horn breaks it."""

import pathlib
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "clients/python"))
from ganglion_robot import Robot  # noqa: E402


class Counting(Robot):
    drives, broken, stopped_s = False, 0, 0.0

    def sense(self):
        if self.broken > 1:
            raise RuntimeError("the sonar is unplugged")
        return [self.most_frames, self.most_bytes, self.stopped_s, len(self.connections)]

    def act(self, values):
        if self.broken > 0:
            self.broken -= 1
            raise RuntimeError("the motors are unplugged \ud800")
        if values[2] > 0:  # breaks now, when it is told to stop, and when it is told so again
            self.broken = 2
            raise RuntimeError("the horn is broken")
        if self.drives and values[0] == 0:
            self.stopped_s = time.monotonic()
        self.drives = values[0] != 0


if __name__ == "__main__":
    Counting(pathlib.Path(__file__).with_name("bench_robot.toml")).serve(port=int(sys.argv[1]))
