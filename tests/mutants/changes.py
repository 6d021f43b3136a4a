"""Single changes to C++ sources, each a change of behaviour as a slip of a programmer would make it."""

import dataclasses
import re

OPERATORS = {}


@dataclasses.dataclass(frozen=True)
class Change:
    """Columns `begin` to `end` of a line are replaced."""

    file: str
    line: int
    kind: str
    begin: int
    end: int
    to: str

    def key(self, text):
        """What it is, whatever line it stands on: how equivalents are listed."""
        return f"{self.file} | {text.strip()} | {self.kind} {text[self.begin : self.end].strip()} -> {self.to.strip()}"


def operator(kind):
    def keep(find):
        OPERATORS[kind] = find
        return find

    return keep


def blanked(text):
    """The same text, lines and columns with comments and the contents of strings as spaces."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)

    def blank(match):
        found = match.group()
        if found[0] == "'" and match.start() > 0 and text[match.start() - 1].isalnum():
            return found  # 1'000
        return "".join(c if c == "\n" else " " for c in found)

    return pattern.sub(blank, text)


def swaps(pattern, table, group=0):
    """Replaces what `pattern` finds by what the table has for it."""

    def find(line):
        for match in re.finditer(pattern, line):
            if to := table.get(match.group(group)):
                yield match.start(group), match.end(group), to

    return find


operator("boundary")(swaps(r" (<=|>=|<|>) (?=[\w(-])", {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}, 1))
operator("sign")(swaps(r"(?<=[\w)\]]) ([+-]) (?=[\w(])", {"+": "-", "-": "+"}, 1))
operator("factor")(swaps(r"(?<=[\w)\]]) ([*/]) (?=[\w(])", {"*": "/", "/": "*"}, 1))
operator("and or")(swaps(r" (&&|\|\|) ", {"&&": "||", "||": "&&"}, 1))
operator("equal")(swaps(r" (==|!=) ", {"==": "!=", "!=": "=="}, 1))
operator("extreme")(swaps(r"std::(min|max)\(", {"min": "max", "max": "min"}, 1))
operator("truth")(swaps(r"(?<![\w.])(true|false)(?=[;,)}])", {"true": "false", "false": "true"}, 1))


@operator("constant")
def constants(line):
    if re.match(r"\s*(static_assert|case |template|#)", line):
        return
    for match in re.finditer(r"(?<![\w.'\"<])(\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w.'])", line):
        value = match.group(1)
        if line[match.end() : match.end() + 1] == ">":
            continue  # an argument of a template
        to = "1" if float(value) == 0 else "0" if value == "1" else f"({value} * 2)"
        yield match.start(1), match.end(1), to


@operator("condition")
def conditions(line):
    """Of an if that stands on one line: the other way round."""
    match = re.match(r"\s*(?:} else )?if \((?!const|auto)(.*)\) (?:\{|return|continue|break)", line)
    if match and "=" not in re.sub(r"[=!<>]=", "", match.group(1)) and ";" not in match.group(1):
        yield match.start(1), match.end(1), f"!({match.group(1)})"


@operator("check")
def checks(line):
    """A check that leaves early is not made."""
    match = re.match(r"\s*(if \((?!const|auto).*\) (?:return\b[^;]*|continue|break);)$", line)
    if match:
        yield match.start(1), match.end(1), ";"


@operator("statement")
def statements(line):
    """A call or an assignment is left out."""
    match = re.match(r"\s+((?:\+\+|--)?[a-z_][\w.\->\[\]]*(?:\([^;]*\)| [+-]?= [^;]*|)?;)$", line)
    if match and not re.match(r"(return|break|continue|using|throw|delete|public|private)\b", match.group(1)):
        if "(" in match.group(1) or "=" in match.group(1) or match.group(1)[:2] in ("++", "--"):
            yield match.start(1), match.end(1), ";"


@operator("arguments")
def arguments(line):
    """The first two arguments of a call change places."""
    for match in re.finditer(r"(?<=[\w>])\(([a-z_][\w.]*), ([a-z_][\w.]*)(?=[,)])", line):
        if match.group(1) != match.group(2):
            yield match.start(1), match.end(2), f"{match.group(2)}, {match.group(1)}"


def changes_of(file, text):
    """Every change that can be made to a source, in its order."""
    found = []
    for number, line in enumerate(blanked(text).split("\n")):
        # What is no behaviour: preconditions, which a slip elsewhere would have to break, and words for people.
        if re.match(r"\s*(#|//|static_assert|using |namespace |template|expects\()", line) or ".ours" in line:
            continue
        for kind, find in OPERATORS.items():
            found += [Change(file, number, kind, begin, end, to) for begin, end, to in find(line)]
    return found


def applied(change, text):
    lines = text.split("\n")
    line = lines[change.line]
    lines[change.line] = line[: change.begin] + change.to + line[change.end :]
    return "\n".join(lines)
