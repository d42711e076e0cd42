#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds and runs the project that the README shows, a C++ file and its CMakeLists.txt, as somebody
does who has installed Marrow.

    build_project.py PROJECT_FOLDER WORK_FOLDER CMAKE_ARGUMENT...
"""
import os
import re
import shutil
import subprocess
import sys

from pages import Page


def main(root, work, *arguments):
    code = {}
    for _, language, text in Page(root, "README.md").blocks:
        code.setdefault(language, text)
    name = re.search(r"add_executable\((\w+) (\S+)\)", code["cmake"])
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    for file, text in (("CMakeLists.txt", code["cmake"]), (name.group(2), code["cpp"])):
        with open(os.path.join(work, file), "w", encoding="utf-8") as stream:
            stream.write(text)
    for command in (["cmake", "-S", ".", "-B", "build", "-Werror=dev", *arguments],
                    ["cmake", "--build", "build"],
                    [os.path.join("build", name.group(1))]):
        subprocess.run(command, cwd=work, check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
