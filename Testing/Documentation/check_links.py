#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Links and pictures of all pages lead to something, and every page and picture is linked to.

    check_links.py PROJECT_FOLDER
"""
import os
import sys

from pages import find_files, finish, read_pages


def main(root):
    pages = read_pages(root)
    errors = []
    linked = {path: set() for path in pages}  # page: what it links to
    count = 0
    for path, page in pages.items():
        for number, target in page.links:
            if "://" in target or target.startswith("mailto:"):
                continue
            count += 1
            name, _, anchor = target.partition("#")
            where = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
            if where.startswith("..") or not os.path.exists(os.path.join(root, where)):
                errors.append(f"{path}:{number}: there is no {target}.")
                continue
            if os.path.isdir(os.path.join(root, where)):
                where = os.path.normpath(os.path.join(where, "README.md"))
            linked[path].add(where)
            if anchor and (where not in pages or anchor not in pages[where].anchors):
                errors.append(f"{path}:{number}: {where} has no heading for #{anchor}.")

    reached = {"README.md"}
    waiting = ["README.md"]
    while waiting:
        for where in linked.get(waiting.pop(), ()):
            if where not in reached:
                reached.add(where)
                waiting.append(where)
    for path in pages:
        if path not in reached:
            errors.append(f"{path}: no links lead here from README.md.")
    for path in find_files(root, ".png"):
        if path.startswith(os.path.join("Documentation", "images")) and path not in reached:
            errors.append(f"{path}: no page shows it.")
    finish(errors, f"{count} links in {len(pages)} pages")


if __name__ == "__main__":
    main(sys.argv[1])
