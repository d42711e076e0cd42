#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the marrow commands of the pages, and the examples of its own help, as they are written.

    run_commands.py PROJECT_FOLDER MARROW WRITE_ANIMAL WORK_FOLDER

The meshes and segments that they name are creatures, so only what the commands do is tested and not
how well.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys

from check_code import commands_of
from pages import finish, read_pages

# What the commands read and no earlier one has written.
MESHES = ["bull.off", "camel.off", "cow.off", "meshes/camel.off", "meshes/dino.off"]
SEGMENTS = ["animals/camel.seg", "by-hand.seg", "camel.seg", "cow.seg", "cow_by_hand.seg",
            "human_0.seg", "human_1.seg", "human_2.seg", "truth.seg"]


def prepare(folder, write_animal):
    shutil.rmtree(folder, ignore_errors=True)
    for name in MESHES + SEGMENTS:
        os.makedirs(os.path.join(folder, os.path.dirname(name)), exist_ok=True)
    # All are the same creature, so any segments fit any mesh.
    subprocess.run([write_animal, "animal.off", "animal.seg"], cwd=folder, check=True)
    for name in MESHES + SEGMENTS:
        shutil.copy(os.path.join(folder, "animal" + name[-4:]), os.path.join(folder, name))


def commands_of_pages(root):
    for path, page in read_pages(root).items():
        found = []
        for number, language, code in page.blocks:
            if language == "sh":
                found += [(f"{path}:{number}", command) for command in commands_of(code)
                          if command and command[0] == "marrow"]
        yield path, found


def commands_of_help(marrow):
    # Each subcommand's examples stand alone, so what they draw is made first.
    found = [("run_commands.py", shlex.split("marrow transfer camel.off cow.off bull.off "
                                             "--segments camel.seg --skeletons -o ."))]
    overview = subprocess.run([marrow, "--help"], capture_output=True, text=True, check=True).stdout
    for name in re.findall(r"^  (\w+) ", overview.split("Subcommands:")[1], re.M):
        text = subprocess.run([marrow, name, "--help"], capture_output=True, text=True,
                              check=True).stdout
        found += [(f"marrow {name} --help", shlex.split(line))
                  for line in re.findall(r"^  (marrow .*)$", text, re.M)]
    return "help", found


def main(root, marrow, write_animal, work):
    errors = []
    count = 0
    for name, commands in [*commands_of_pages(root), commands_of_help(marrow)]:
        if not commands:
            continue
        folder = os.path.join(work, re.sub(r"\W", "_", name))
        prepare(folder, write_animal)
        for where, command in commands:
            count += 1
            run = subprocess.run([marrow, *command[1:]], cwd=folder, capture_output=True, text=True)
            if run.returncode != 0:
                errors.append(f"{where}: {shlex.join(command)} ends with {run.returncode}:\n"
                              f"{run.stderr.strip()}")
    finish(errors, f"{count} commands")


if __name__ == "__main__":
    main(*sys.argv[1:])
