"""What the program does when the system denies it memory, threads or descriptors: it says so and ends, never by a signal.

denied_test.py PROGRAM SOURCE DENY_LIBRARY

GANGLION_DENIALS=2000 for more than a build can wait for: so many of the first allocations, and a quarter as many later ones.
"""

import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

PROGRAM, SOURCE, LIBRARY = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
DENIALS = int(os.environ.get("GANGLION_DENIALS", "40"))
CODES = (0, 1, 2, 3, 4)  # as --help promises
PATIENCE_S = 60


def environment(**denied):
    return dict(os.environ, LANG="C", LD_PRELOAD=LIBRARY, **{name: str(value) for name, value in denied.items()})


def indices(first, later):
    """Of the allocations that are denied: some of the first, some of the later ones."""
    draw = random.Random(7)
    step = max(1, first // DENIALS)
    return [*range(0, first, step), *sorted(draw.sample(range(first, later), DENIALS // 4))]


class Denied(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_with(self, words, **denied):
        done = subprocess.run([PROGRAM, *words], cwd=SOURCE, capture_output=True, text=True, errors="replace", timeout=PATIENCE_S,
                              env=environment(**denied))  # fmt: skip
        self.assertIn(done.returncode, CODES, f"{denied} {done.stderr[-500:]}")
        if done.returncode > 1:
            self.assertNotEqual(done.stderr.strip(), "", f"{denied} ended without a word")
        return done

    def a_run(self, *more):
        return ["run", "experiments/nimrod", "--set", "run.duration_s=1", "--out", self.folder.name, *more]

    def test_memory_of_the_first_words(self):
        for at in range(0, 60, 1 if DENIALS > 60 else 5):
            self.assertEqual(self.run_with(["--version"], DENY_MEMORY=at).returncode, 2)

    def test_memory_of_a_run(self):
        said = [self.run_with(self.a_run(), DENY_MEMORY=at) for at in indices(2000, 60000)]
        self.assertGreater(sum("out of memory" in one.stderr for one in said), len(said) // 4)

    def test_threads_of_a_batch(self):
        for at in range(4):
            done = self.run_with(self.a_run("--seeds", "1..3", "--threads", "2", "--no-record", "--json"), DENY_THREADS=at)
            self.assertEqual(len(json.loads(done.stdout)["runs"]), 3, "fewer threads do as well")

    def test_descriptors_of_a_run(self):
        for most in range(3, 24):
            self.run_with(self.a_run(), DENY_FILES=most)

    def studio(self, **denied):
        """Whether it served, how it ended, what it said."""
        words = [PROGRAM, "studio", "experiments", "--no-browser"]
        log = pathlib.Path(self.folder.name) / "said"
        with open(log, "w") as out:
            server = subprocess.Popen(words, cwd=SOURCE, stdout=out, stderr=out, env=environment(**denied))
        served = False
        try:
            url = self.url_of(server, log)
            if url:
                asked = [self.ask(url, path) for path in ["/api/files", "/api/kinds"] * 3]
                served = 200 in asked[-2:]
        finally:
            server.send_signal(signal.SIGTERM)
            code = server.wait(PATIENCE_S)
        self.assertIn(code, CODES, f"{denied}: {log.read_text()[-500:]}")
        return served, code, log.read_text()

    def url_of(self, server, log):
        until = time.monotonic() + PATIENCE_S
        while time.monotonic() < until and server.poll() is None:
            if found := re.search(r"http://\S+", log.read_text()):
                return found.group()
            time.sleep(0.005)
        return None

    def ask(self, url, path):
        base, key = re.match(r"(http://[^/]+).*token=(\w+)", url).groups()
        request = urllib.request.Request(base + path, headers={"Authorization": f"Bearer {key}"})
        try:
            with urllib.request.urlopen(request, timeout=5) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code
        except OSError:
            return None

    def test_threads_of_the_studio(self):
        for at in range(3):
            served, code, said = self.studio(DENY_THREADS=at)
            if not served:
                self.assertNotEqual(said.strip(), "")
                self.assertNotEqual(code, 0)

    def memory_of_the_studio(self):
        """Only in the large campaign: about one in a thousand ends it in the copy of a file's value (docs/results.md)."""
        served = 0
        for at in indices(4000, 60000):
            served += self.studio(DENY_MEMORY=at)[0]
        self.assertGreater(served, 0, "what is denied once it serves costs an answer, not the server")

    def test_descriptors_of_the_studio(self):
        for most in range(3, 24):
            self.studio(DENY_FILES=most)


if "GANGLION_DENIALS" in os.environ:
    Denied.test_memory_of_the_studio = Denied.memory_of_the_studio

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
