"""A robot that drives: python3 example.py [PORT], then: ganglion run clients/python, in either pace."""

import math
import pathlib
import sys
import time

from ganglion_robot import Robot


class Cart(Robot):
    """Two wheels, and a wall 3 m ahead. On a real robot sense() and act() are all there is."""

    x_m, yaw_rad, duties, moved_s = 0.0, 0.0, [0, 0], None

    def sense(self):
        self.move()
        range_m = (3 - self.x_m) / max(math.cos(self.yaw_rad), 1e-9)
        return [range_m if range_m <= 3 else math.inf] * 2 + [self.yaw_rad]

    def act(self, values):
        self.move()
        self.duties = values

    def reset(self, seed, episode):
        self.x_m, self.yaw_rad = 0.0, 0.0

    def step(self, step_s):  # its world's time can stand still: lock-step
        left, right = self.duties
        self.x_m += 0.2 * (left + right) / 2 * math.cos(self.yaw_rad) * step_s
        self.yaw_rad = math.remainder(self.yaw_rad + 0.2 * (right - left) / 0.18 * step_s, 2 * math.pi)

    def move(self):  # the world goes on by itself when free-running
        before_s, self.moved_s = self.moved_s, time.monotonic()
        if self.free_running and before_s:
            self.step(self.moved_s - before_s)


if __name__ == "__main__":
    file = pathlib.Path(__file__).with_name("robot.toml")
    Cart(file).serve(port=int(sys.argv[1]) if sys.argv[1:] else 7007)
