#!/usr/bin/env python3
"""What a cycle needs has no text, no list and no formatting in it: a microcontroller has none.

tick_side_test.py COMPILER SOURCE
"""

import pathlib
import subprocess
import sys

compiler, source = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
forbidden = ("/fmt/", "/basic_string.h", "/stl_vector.h", "/iostream", "/functional ")
found = []
headers = sorted((source / "ganglion/module/tick").glob("*.h")) + [source / "tests/tree/bare_cycle/main.cpp"]
if len(headers) < 5:
    sys.exit(f"only {len(headers)} files to look at: where is ganglion/module/tick?")
for header in headers:
    call = [compiler, "-std=c++20", "-x", "c++", f"-I{source}", "-M", str(header)]
    read = subprocess.run(call, capture_output=True, text=True, check=True).stdout.replace("\\\n", " ").split()
    found += [f"{header.relative_to(source)} reads {name}" for name in read if any(word in name + " " for word in forbidden)]
if found:
    sys.exit("\n".join(found))
print(f"{len(headers)} files")
