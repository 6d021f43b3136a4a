"""Writes the files that a page tells its reader to make, <!-- file to make: PATH --> and a code block: PAGE ROOT."""
import pathlib
import re
import sys

page, root = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
blocks = re.findall(r"<!-- file to make: (\S+) -->\n+```\w*\n(.*?)^```$", page.read_text(), re.S | re.M)
if not blocks:
    sys.exit(f"{page} tells to make no file")
for path, text in blocks:
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    (root / path).write_text(text)
