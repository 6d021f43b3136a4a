#!/usr/bin/env python3
"""Files of an older day still serve: run files open, are drawn and repeat to the bit; what was learned is taken on; a batch
is compared. kept_test.py PROGRAM SOURCE
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
kept = source / "tests/golden/kept"


def told(*arguments):
    call = subprocess.run([program, *arguments], cwd=source, capture_output=True, text=True, timeout=120)
    if call.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, call.args))}\nended with {call.returncode}: {call.stderr}{call.stdout}")
    return call.stdout


def expect(holds, what):
    if not holds:
        sys.exit(what)


def pathfinder(*experience):
    run = told("run", "experiments/pathfinder", "--seed", "2", "--set", "run.duration_s=120", "--json", "--no-record",
               "--no-report", *experience)
    return json.loads(run)["runs"][0]


with tempfile.TemporaryDirectory() as folder:
    for name in ("nimrod", "pathfinder", "yard", "touched"):
        said = told("replay", kept / f"{name}.mcap")
        expect(said.strip().splitlines()[-1].startswith("same: digest "), f"{name} does not repeat: {said}")
        told("plot", kept / f"{name}.mcap", "--out", f"{folder}/{name}")
        expect(list(pathlib.Path(folder, name).glob("*trajectory*.svg")), f"{name}: no picture of its way")
    store = pathlib.Path(folder, "map.sqlite")
    shutil.copy(kept / "map.sqlite", store)
    expect("DynamicMapRouter" in told("experience", "show", store), "the kept map is not listed")
    expect(pathfinder("--experience", store)["digest"] != pathfinder()["digest"], "the kept map changed nothing")
    told("runs", "compare", kept / "batch.json", kept / "batch.json", "--out", f"{folder}/page.html")
print("4 run files, a map and a batch still serve")
