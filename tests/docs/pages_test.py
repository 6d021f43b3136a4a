"""Holds every Markdown page to the tree: links lead somewhere, files it names are there, texts it shows are theirs.

A code block shows a shipped file where a comment stands before it: <!-- file: PATH --> for the whole file,
<!-- part of: PATH --> for lines that stand so, one after the other, in the file. PATH is from the root of the project.
"""
import pathlib
import re
import sys
import tempfile

FOLDERS = ("apps", "bench", "clients", "cmake", "docs", "examples", "experiments", "fuzz", "ganglion", "studio", "tests")
LINK = re.compile(r"(?<!\\)!?\[[^\]]*\]\(([^)\s]+)\)")
NAMED = re.compile(r"(?<![\w./-])(?:%s)/[\w./-]*[\w/]" % "|".join(FOLDERS))
SHOWN = re.compile(r"<!-- (file|part of): (\S+) -->\n+```\w*\n(.*?)^```$", re.S | re.M)
MARK = re.compile(r"<!-- (?:file|part of): \S+ -->")


def pages(root):
    left_out = {"build", "node_modules", "runs", ".git"}
    return sorted(path for path in root.rglob("*.md") if not left_out & set(path.relative_to(root).parts))


def without_code(text):
    return re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M)


def anchors(text):
    """Names of the headings in links, as GitHub makes them."""
    names, found = {}, set()
    for title in re.findall(r"^#{1,6} (.*)$", without_code(text), re.M):
        title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title).strip().lower()
        name = re.sub(r"[^\w\- ]", "", title).replace(" ", "-")
        found.add(name if name not in names else f"{name}-{names[name]}")
        names[name] = names.get(name, 0) + 1
    return found


def wrong_links(page, text):
    for target in LINK.findall(without_code(re.sub(r"`[^`\n]*`", "", text))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        goal = (page.parent / path).resolve() if path else page
        if not goal.exists():
            yield f"link to {target}: there is no such file"
        elif anchor and goal.suffix == ".md" and anchor not in anchors(goal.read_text()):
            yield f"link to {target}: there is no such heading"


def wrong_names(root, page, text):
    """Files that a page names in code, `experiments/nimrod` or in a block of commands."""
    code = re.findall(r"`([^`\n]+)`", without_code(text)) + re.findall(r"^```\w*\n(.*?)^```$", text, re.S | re.M)
    for name in sorted({name for piece in code for name in NAMED.findall(piece)}):
        if not (root / name).exists() and not (page.parent / name).exists() and not planned(text, name.rstrip("/")):
            yield f"{name}: there is no such file"


def planned(text, name):
    """What a page speaks of as something to be made: <!-- not here: PATH -->, or before a block <!-- file to make: PATH -->."""
    made = re.findall(r"<!-- (?:not here|file to make): (\S+) -->", text)
    return any(f"{path}/".startswith(f"{name}/") or name.startswith(f"{path}/") for path in made)


def wrong_blocks(root, text):
    for how, path, shown in SHOWN.findall(text):
        if not (root / path).exists():
            yield f"shows {path}: there is no such file"
            continue
        file = (root / path).read_text()
        if how == "file" and shown != file:
            yield f"shows {path} otherwise than it is"
        if how == "part of" and "\n" + shown not in "\n" + file:
            yield f"shows lines of {path} that do not stand so in it"
    if len(MARK.findall(text)) != len(SHOWN.findall(text)):
        yield "a comment that announces a file has no code block right behind it"


def complaints(root):
    for page in pages(root):
        text = page.read_text()
        for found in (*wrong_links(page, text), *wrong_names(root, page, text), *wrong_blocks(root, text)):
            yield f"{page.relative_to(root)}: {found}"
    yield from reasons(root)
    yield from versions(root)


def versions(root):
    """The build, the citation and the changelog speak of one version."""
    if not (root / "CITATION.cff").exists():
        return
    version = re.search(r"project\(ganglion VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text())[1]
    if f"\nversion: {version}\n" not in (root / "CITATION.cff").read_text():
        yield f"CITATION.cff: the version is {version}"
    if f"\n## {version}\n" not in (root / "CHANGELOG.md").read_text():
        yield f"CHANGELOG.md: has no heading for {version}"


def reasons(root):
    """The table of reasons in the manual has every code of the program, and its number."""
    header, page = root / "ganglion/module/command.h", root / "docs/manual/controller_toml.md"
    if not header.exists():
        return
    body = re.search(r"enum class ReasonCode[^{]*\{(.*?)\};", header.read_text(), re.S)[1]
    for number, name in enumerate(re.findall(r"^\s*(\w+)\b[^/\n]*,", body, re.M)):
        words = re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower()
        if f"| {number} | `{words}` |" not in page.read_text():
            yield f"docs/manual/controller_toml.md: has no row for reason {number}, {words}"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "docs").mkdir()
        (root / "docs/a.toml").write_text("a = 1\nb = 2\nc = 3\n")
        (root / "good.md").write_text("# One `two`\n[x](docs/a.toml) [y](#one-two) `docs/a.toml`\n"
                                      "<!-- file: docs/a.toml -->\n```toml\na = 1\nb = 2\nc = 3\n```\n"
                                      "<!-- part of: docs/a.toml -->\n```toml\nb = 2\nc = 3\n```\n")
        assert not list(complaints(root)), list(complaints(root))
        for text in ("[x](docs/b.toml)", "[x](#two)", "`docs/b.toml`", "```\nrun docs/b.toml\n```\n",
                     "<!-- file: docs/a.toml -->\n```\na = 1\n```\n", "<!-- part of: docs/a.toml -->\n```\na = 1\nc = 3\n```\n",
                     "<!-- file: docs/a.toml -->\nword\n```\na = 1\n```\n"):
            (root / "good.md").write_text(text)
            assert len(list(complaints(root))) == 1, (text, list(complaints(root)))


def main():
    if "--self-test" in sys.argv[2:]:
        self_test()
        return
    found = list(complaints(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
