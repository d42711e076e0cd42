# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation: every Markdown file of the project, its links and its code."""
import os
import re
import sys


def find_files(root, *endings):
    """Paths relative to root of the project's own files, without what a build leaves behind."""
    result = []
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders
                            if not f.startswith((".git", "build", "install", "__pycache__")))
        for name in sorted(files):
            if name.endswith(endings):
                result.append(os.path.relpath(os.path.join(folder, name), root))
    return result


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


class Page:
    """A Markdown file taken apart."""

    def __init__(self, root, path):
        self.path = path
        self.blocks = []  # (line number, language, code)
        self.links = []  # (line number, target)
        self.anchors = set()
        self.prose = []  # (line number, line) outside of code blocks
        self._take_apart(read(root, path).splitlines())

    def _take_apart(self, lines):
        block = None
        for number, line in enumerate(lines, 1):
            fence = re.match(r"\s*```(.*)$", line)
            if fence and block is None:
                block = (number, fence.group(1).strip(), [])
            elif fence:
                self.blocks.append((block[0], block[1], "\n".join(block[2]) + "\n"))
                block = None
            elif block is not None:
                block[2].append(line)
            else:
                self.prose.append((number, line))
        for number, line in self.prose:
            if line.startswith("#"):
                self._add_anchor(line.lstrip("#").strip())
            for name in re.findall(r'<a (?:id|name)="([^"]+)"', line):
                self.anchors.add(name)
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
                self.links.append((number, target))

    def _add_anchor(self, heading):
        """As GitHub and GitLab make them of headings."""
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        count = 0
        name = slug
        while name in self.anchors:
            count += 1
            name = f"{slug}-{count}"
        self.anchors.add(name)


def read_pages(root):
    return {path: Page(root, path) for path in find_files(root, ".md")}


def finish(errors, what):
    """Ends the program: with the errors, or with what was found to be right."""
    if errors:
        print("\n".join(errors), file=sys.stderr)
        sys.exit(1)
    print(what)
