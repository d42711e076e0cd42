#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every number that somebody set by hand in the algorithms (Filters/*/Private) has a name and a reason.

A number is a constexpr with a comment behind or above it; several in succession share one comment.
Documentation/numbers.md lists them all: --write makes it, and without that this fails where the page is not
what the code says, a number has no reason, or a literal stands in the code without a name.

Not looked at: creatures (shapes for tests, set by hand as such), readers and writers (their numbers are the
formats'), progress fractions, whole numbers up to 16, simple fractions, the widths of types, and 1e-300, which
keeps a divisor from being zero.
"""
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGE = SOURCE / "Documentation" / "numbers.md"
LITERAL = re.compile(r"(?<![\w.])(\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+|\d+)(?![\w.])")
NAMED = re.compile(r"constexpr\s+[\w:<>, ]*?\b(\w+)(?:\[\])?\s*(?:=\s*|(?=\{))(.*)")
MEMBER = re.compile(r"^\s*(?:double|int|std::size_t)\s+(\w+)()\s*=\s*([\d.e-]+);")
STRUCTURAL = {0.25, 0.5, 1.5, 21, 31, 32, 33, 42, 60, 63, 64, 127, 255, 1e-300}
PROGRESS = re.compile(r"\b(Report|SubProgress|watched|ofBody)\(")
HEAD = """# Numbers

What was set by hand in the algorithms, and why. Defaults that can be set are in [Parameters](parameters.md). This
page is made from the comments in the code: `.ci/checks/numbers.py --write`. The same script fails where
a number has neither a name nor a reason. How the weights of the matching were found, and on what, is told in
[How the weights were found](limitations.md#how-the-weights-were-found).
"""


def sources():
    names = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard", "Filters/*/Private/*.cxx", "Filters/*/Private/*.h"],
        cwd=SOURCE, check=True, capture_output=True, text=True).stdout.split()
    return sorted(name for name in set(names) if not re.search("/Creatures/|/IO/|Palette|Constants.h", name))


def statements(lines):
    """(first line, code without comments, comment behind or above) of each line; a constexpr whole."""
    above, index, is_used = "", 0, False
    while index < len(lines):
        first = index
        code, _, behind = lines[index].partition("//")
        if code.strip().startswith("constexpr") or "inline constexpr" in code:
            while ";" not in code and index + 1 < len(lines):
                index += 1
                more, _, comment = lines[index].partition("//")
                code, behind = code + " " + more.strip(), behind + comment
        if not code.strip():
            above = ("" if is_used else above) + " " + behind.lstrip("/<! ") if behind else ""
            is_used = False
        else:
            yield first + 1, code, behind.lstrip("/<! ").strip(), above.strip()
            is_used = True
            if not re.search(r"\bconstexpr\b", code):
                above = ""
        index += 1


def is_structural(text):
    value = float(text)
    return value in STRUCTURAL or (value == int(value) and value <= 16)


def read(name):
    """The named numbers of a file, and the literals in it without a name, as (line, ...)."""
    named, bare = [], []
    text = (SOURCE / name).read_text()
    text = re.sub(r'"(\\.|[^"\\\n])*"' + r"|'(\\.|[^'\\\n])'", '""', text)
    for line, code, behind, above in statements(text.split("\n")):
        if code.lstrip().startswith("#"):
            continue
        found = NAMED.search(code) or MEMBER.search(code)
        value = found.group(found.lastindex).rstrip("; ").strip() if found else ""
        if re.fullmatch(r"-[12]|\{\}", value):
            continue  # stands for none
        is_default = found and "constexpr" not in code
        if found and LITERAL.search(value) and not (is_default and is_structural(value)):
            why = behind or above
            if not why.startswith("of the progress"):
                named.append((line, found.group(1), value, why))
        elif not PROGRESS.search(code):
            bare += [(line, x) for x in LITERAL.findall(code) if not is_structural(x)]
    return named, bare


def main():
    errors, page, total, module = [], [HEAD], 0, None
    for name in sources():
        named, bare = read(name)
        errors += [f"{name}:{line}: {value} has no name" for line, value in bare]
        errors += [f"{name}:{line}: {number} has no reason" for line, number, _, why in named if not why]
        if named and name.split("/")[1] != module:
            module = name.split("/")[1]
            page.append(f"\n## {module}\n\n| number | value | file | reason |\n| --- | --- | --- | --- |\n")
        for _, number, value, why in named:
            why = why.replace("|", "\\|")
            page.append(f"| `{number}` | {value} | {pathlib.Path(name).name} | {why} |\n")
        total += len(named)
    page = "".join(page)
    if "--write" in sys.argv[1:]:
        PAGE.write_text(page)
    elif not PAGE.exists() or PAGE.read_text() != page:
        errors.append("Documentation/numbers.md is not what the code says: .ci/checks/numbers.py --write")
    print("\n".join(errors + [f"numbers: {total} with a reason, {len(errors)} findings"]))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
