#!/usr/bin/env python3
"""What controllers did on a day that is kept: the digest of every shipped experiment must stay.

golden_test.py PROGRAM SOURCE         compares with digests.txt
golden_test.py PROGRAM SOURCE --write writes it anew: only where a change of behaviour is meant, and said in the CHANGELOG
"""

import json
import pathlib
import subprocess
import sys
import tempfile

program, source = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
kept = pathlib.Path(source) / "tests/golden/digests.txt"

listing = "controller=experiments/nimrod/controller.listing.toml"
raw_listing = "controller=experiments/nimrod/controller.listing_raw.toml"
moving = "application.world=experiments/pathfinder/rooms_moving.toml"

# What is called how: seeds 1 to 5 of each.
cases = {
    "nimrod": ["experiments/nimrod"],
    "nimrod listing": ["experiments/nimrod", "--set", listing],
    "nimrod listing raw": ["experiments/nimrod", "--set", raw_listing],
    "nimrod box": ["experiments/nimrod/box.toml"],
    "nimrod, two robots": ["experiments/nimrod", "--set", "application.robots=2", "--set", "run.free_ground=false"],
    "nimrod, dead sonar": ["experiments/nimrod", "--set", "application.robot.sensor.sonar_left.fault=dead"],
    "pathfinder": ["experiments/pathfinder"],
    "pathfinder, moving": ["experiments/pathfinder", "--set", moving],
    "yard": ["experiments/yard"],
    "last tick": ["examples/05_last_tick"],
    "a fault": ["examples/06_a_fault"],
    "learn a map": ["examples/07_learn_a_map"],
}


def told(*arguments):
    call = subprocess.run([program, *arguments], cwd=source, capture_output=True, text=True, timeout=300)
    if call.returncode not in (0, 1):  # 1: the robot failed its task
        sys.exit(f"{' '.join(call.args)}\nended with {call.returncode}: {call.stderr}")
    return json.loads(call.stdout)


def digests_of(arguments):
    runs = told("run", *arguments, "--seeds", "1..5", "--json", "--no-record", "--no-report")["runs"]
    return [run["digest"] for run in runs]


def over_the_link(folder):
    """The robots served by one process and driven by another: the same digest as in one."""
    serving = subprocess.Popen([program, "sim", "experiments/nimrod", "--listen", "127.0.0.1:0", "--once"], cwd=source,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        address = serving.stdout.readline().split("listens at ")[1].split(";")[0]
        run = told("run", "experiments/nimrod", "--robot", address, "--seed", "1", "--json", "--no-report", "--out", folder)
        serving.wait(timeout=60)
        return run["runs"][0]["digest"]
    finally:
        serving.kill()


def main():
    found = {name: digests_of(arguments) for name, arguments in cases.items()}
    with tempfile.TemporaryDirectory() as folder:
        found["nimrod over the link"] = [over_the_link(folder)]
    lines = [f"{name}: {' '.join(digests)}" for name, digests in found.items()]
    if "--write" in sys.argv:
        kept.write_text("\n".join(lines) + "\n")
        return
    expected = kept.read_text().splitlines()
    wrong = [f"expected {one}\nfound    {other}" for one, other in zip(expected, lines) if one != other]
    if len(expected) != len(lines):
        wrong.append(f"{len(expected)} cases are kept, {len(lines)} were run")
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{len(lines)} cases, the same digests")


main()
