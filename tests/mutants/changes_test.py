"""Of the changes that mutants.py makes: each operator finds what it should, and nothing in comments and texts."""

import unittest

from changes import applied, blanked, changes_of


def made(line):
    return sorted((change.kind, applied(change, line)) for change in changes_of("a.cpp", line))


class Changes(unittest.TestCase):
    def test_each_operator(self):
        for line, kind, expected in [
            ("  x = a < b;", "boundary", "  x = a <= b;"),
            ("  x = a + b;", "sign", "  x = a - b;"),
            ("  x = a / b;", "factor", "  x = a * b;"),
            ("  x = a && b;", "and or", "  x = a || b;"),
            ("  x = a == b;", "equal", "  x = a != b;"),
            ("  x = std::min(a, b);", "extreme", "  x = std::max(a, b);"),
            ("  x = f(a, b);", "arguments", "  x = f(b, a);"),
            ("  x = f(true);", "truth", "  x = f(false);"),
            ("  x = 0.5;", "constant", "  x = (0.5 * 2);"),
            ("  x = 0;", "constant", "  x = 1;"),
            ("  if (a > b) {", "condition", "  if (!(a > b)) {"),
            ("  if (a > b) return;", "check", "  ;"),
            ("  go(a);", "statement", "  ;"),
            ("  ++x;", "statement", "  ;"),
        ]:
            self.assertIn((kind, expected), made(line), line)

    def test_leaves_what_is_no_behaviour(self):
        for line in ["// x = a < b;", '  say("a < b && 3 + 4"', "  expects(a < b);", "#if A == 1", "  return x;", "std::vector<int> a;"]:
            self.assertEqual([kind for kind, _ in made(line)], [], line)

    def test_blanks_keep_columns(self):
        text = 'a("x\\"y", \'"\', 1\'000); // b\nR"(c)" d'
        self.assertEqual(len(blanked(text)), len(text))
        self.assertEqual(blanked(text).split(), ["a(", ",", ",", "1'000);", "d"])


if __name__ == "__main__":
    unittest.main()
