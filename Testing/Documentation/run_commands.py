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
MESHES = ["animals/bull.off", "animals/camel.off", "bull.off", "camel.off", "cow.off", "herd/bull.off", "herd/camel.off",
          "herd/cow.off", "meshes/camel.off", "meshes/dino.off"]
SEGMENTS = ["animals/camel.seg", "by-hand.seg", "camel.seg", "cow.seg", "cow_by_hand.seg", "herd/camel.seg",
            "human_0.seg", "human_1.seg", "human_2.seg", "truth.seg"]
# Makes what the examples of some subcommands read.
LABELLED = ["marrow transfer camel.off cow.off bull.off --segments camel.seg --skeletons -o .",
            "marrow transfer cow.off camel.off --segments cow.seg -o camel.vtp"]


def prepare(folder, write_animal):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    # All are the same creature, so any segments fit any mesh.
    subprocess.run([write_animal, "animal.off", "animal.seg"], cwd=folder, check=True)
    for name in MESHES + SEGMENTS:
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        shutil.copy(os.path.join(folder, "animal" + name[-4:]), path)


def commands_of_pages(root):
    for path, page in read_pages(root).items():
        found = []
        for number, language, code in page.blocks:
            if language == "sh":
                found += [(f"{path}:{number}", command) for command in commands_of(code)
                          if command and command[0] == "marrow"]
        yield path, found


def commands_of_help(marrow):
    overview = subprocess.run([marrow, "--help"], capture_output=True, text=True, check=True).stdout
    for name in re.findall(r"^  (\w+) ", overview.split("Subcommands:")[1], re.M):
        text = subprocess.run([marrow, name, "--help"], capture_output=True, text=True,
                              check=True).stdout
        # Each subcommand's examples stand alone: what they read is made first.
        yield "help " + name, [(f"marrow {name} --help", shlex.split(command)) for command in [
            *(LABELLED if name in ("evaluate", "render") else []), *re.findall(r"^  (marrow .*)$", text, re.M)]]


def main(root, marrow, write_animal, work):
    errors = []
    count = 0
    prepare(work, write_animal)
    for name, commands in [*commands_of_pages(root), *commands_of_help(marrow)]:
        if not commands:
            continue
        folder = os.path.join(work, "run", re.sub(r"\W", "_", name))
        shutil.copytree(work, folder, ignore=shutil.ignore_patterns("run"))
        for where, command in commands:
            count += 1
            run = subprocess.run([marrow, *command[1:]], cwd=folder, capture_output=True, text=True)
            if run.returncode != 0:
                errors.append(f"{where}: {shlex.join(command)} ends with {run.returncode}:\n"
                              f"{run.stderr.strip()}")
    finish(errors, f"{count} commands")


if __name__ == "__main__":
    main(*sys.argv[1:])
