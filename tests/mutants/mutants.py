"""Makes single changes to the code at random, builds, runs the tests of the area, and lists what nobody saw.

mutants.py SOURCE WORK [AREA] [--seed N] [--count N] [--list] [--here]

SOURCE is the project, WORK a folder for a copy of it and its build. What is equivalent to the code as it is stands in
equivalents.txt beside this file, a line each with its reason, and is left out.
"""

import argparse
import filecmp
import json
import pathlib
import random
import shutil
import subprocess
import sys

from changes import applied, changes_of

HERE = pathlib.Path(__file__).parent

# Area: folders below ganglion/ or files, and the test programs that must see a change, the nearest first.
AREAS = {
    "acting": (["acting", "module", "coordination", "goal"], ["acting", "module", "coordination", "goal", "graph", "kinds", "run"]),
    "sensing": (["sensing"], ["sensing", "kinds", "run"]),
    "grid": (["grid"], ["grid", "acting", "kinds", "run"]),
    "graph": (["graph/controller.cpp", "graph/goal_arbiter.cpp", "graph/order.cpp", "graph/digest.cpp"], ["graph", "kinds", "run"]),
    "link": (["link/controller", "link/robot", "link/wire"], ["link", "run"]),
    "record": (["record/mcap", "record"], ["record", "run", "endings"]),
    "experience": (["experience"], ["experience", "run", "endings"]),
    "guard": (["studio/server/guard.cpp", "studio/folder"], ["studio"]),
    "sim": (["sim/simulation", "sim/drive", "sim/sensor"], ["sim", "kinds", "run"]),
    "plant": (["plant", "task"], ["plant", "task", "kinds", "run"]),
}


def sources(root, places):
    files = set()
    for place in places:
        at = root / "ganglion" / place
        files.update([at] if at.is_file() else at.rglob("*.cpp"))
    return sorted(str(f.relative_to(root)) for f in files if not f.name.endswith("_test.cpp") and "/testing/" not in str(f))


def equivalents():
    lines = (HERE / "equivalents.txt").read_text().splitlines()
    return {line.rsplit(" # ", 1)[0] for line in lines if " # " in line}


def run(command, cwd, limit_s):
    """Whether it ends well; what takes too long does not."""
    try:
        return subprocess.run(command, cwd=cwd, capture_output=True, timeout=limit_s).returncode == 0
    except subprocess.TimeoutExpired:
        return False


class Checkout:
    """Where changes are made: a copy of the project, so that nobody's work is touched whatever happens."""

    def __init__(self, source, work, here):
        self.root = source if here else work / "source"
        self.build = self.root / "build" / "release"
        if not here:
            self.copy(source)
        (self.root / "build").mkdir(exist_ok=True)
        if not run(["cmake", "--preset", "release", "-DGANGLION_TESTS=ON", "-DGANGLION_STUDIO=ON"], self.root, 600):
            sys.exit("the copy cannot be configured")

    def copy(self, source):
        """Only what changed, so that what was built before stays built."""
        list_files = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(list_files, cwd=source, capture_output=True, text=True, check=True).stdout.splitlines()
        for name in names:
            here, there = source / name, self.root / name
            if here.is_file() and not (there.is_file() and filecmp.cmp(here, there, shallow=False)):
                there.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(here, there)
        for there in self.root.rglob("*"):
            name = there.relative_to(self.root)
            if there.is_file() and name.parts[0] in ("ganglion", "apps", "tests") and str(name) not in names:
                there.unlink()

    def compiles(self, tests):
        return run(["ninja", "-C", self.build, *[f"test_{test}" for test in tests]], self.root, 3600)

    def seen_by(self, tests):
        """The first test program that fails twice, since a busy machine may fail one of the real clock's once."""
        for test in tests:
            command = [self.build / "bin" / f"test_{test}", "--gtest_brief=1", "--gtest_fail_fast"]
            if not run(command, self.root, 300) and not run(command, self.root, 300):
                return test
        return None


def verdict(checkout, change, tests):
    """The test program that saw a change, "unseen", or "does not compile"."""
    path = checkout.root / change.file
    before = path.read_text()
    path.write_text(applied(change, before))
    try:
        for at in range(len(tests)):
            if not checkout.compiles(tests[at : at + 1]):
                return "does not compile"
            if seen := checkout.seen_by(tests[at : at + 1]):
                return seen
        return "unseen"
    finally:
        path.write_text(before)


def chosen(root, areas, seed, count):
    """As many changes of each area, kinds and files mixed."""
    draw = random.Random(seed)
    known = equivalents()
    result = []
    for area in areas:
        found = {}
        for file in sources(root, AREAS[area][0]):
            text = (root / file).read_text()
            lines = text.split("\n")
            for change in changes_of(file, text):
                if change.key(lines[change.line]) not in known:
                    found.setdefault(change.kind, []).append(change)
        kinds = sorted(found)
        for _ in range(count // len(areas) + 1):
            kind = draw.choice(kinds)
            result.append((area, draw.choice(found[kind])))
    return result[:count]


def main():
    parser = argparse.ArgumentParser(prog="./dev mutants", description=__doc__.split("\n")[0])
    parser.add_argument("source", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("work", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("area", nargs="?", choices=sorted(AREAS), help="all areas unless told otherwise")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=40, help="changes to make")
    parser.add_argument("--list", action="store_true", help="print the changes and make none")
    parser.add_argument("--here", action="store_true", help="change this checkout itself, and change it back: for one that "
                        "is thrown away, since it spares the first build")  # fmt: skip
    args = parser.parse_args()
    areas = [args.area] if args.area else sorted(AREAS)
    changes = chosen(args.source, areas, args.seed, args.count)
    if args.list:
        for area, change in changes:
            line = (args.source / change.file).read_text().split("\n")[change.line]
            print(f"{area}: {change.file}:{change.line + 1}: {change.key(line)}")
        return 0
    checkout = Checkout(args.source, args.work, args.here)
    for area in areas:
        if not checkout.compiles(AREAS[area][1]):
            sys.exit(f"{area}: the tests do not build as they are")
        if broken := checkout.seen_by(AREAS[area][1]):
            sys.exit(f"{area}: test_{broken} fails before anything is changed")
    seen = unseen = 0
    for area, change in changes:
        line = (checkout.root / change.file).read_text().split("\n")[change.line]
        by = verdict(checkout, change, AREAS[area][1])
        print(json.dumps({"area": area, "seen_by": by, "line": change.line + 1, "change": change.key(line)}), flush=True)
        seen += by not in ("unseen", "does not compile")
        unseen += by == "unseen"
    print(f"{seen} of {seen + unseen} changes were seen, {100 * seen / max(1, seen + unseen):.0f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main())
