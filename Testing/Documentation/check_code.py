#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Code in the pages is code of the project: C++ and Python are contained in programs that are built
and run, a C++ program with its main() is all of one, and shell commands name what exists.

    check_code.py PROJECT_FOLDER
"""
import json
import os
import re
import shlex
import sys

from pages import find_files, finish, read, read_pages

# Where code of a language must be found, word for word.
PROGRAMS_OF = {
    "cpp": (".cxx", ("Examples/", "Testing/Documentation/")),
    "python": (".py", ("Examples/", "Testing/")),
}
# Programs of the system that the pages may call.
PROGRAMS = {
    "apt-get", "cd", "cmake", "convert", "cp", "ctest", "export", "marrow", "mkdir", "mpiexec", "paraview", "pvbatch",
    "pvpython", "xvfb-run",
}


def plain(code):
    """Without indentation, empty lines and the ends of lines: an excerpt may be set differently."""
    return "\n".join(line.strip() for line in code.splitlines() if line.strip())


def stands_in(code, program):
    if "int main(" in code:
        # A page shows a program without the line of its licence.
        return code == program.removeprefix("// SPDX-License-Identifier: BSD-3-Clause\n")
    return plain(code) in plain(program)


class ShellCheck:
    def __init__(self, root):
        self.root = root
        presets = json.loads(read(root, "CMakePresets.json"))
        self.presets = {preset["name"] for kind in presets if kind.endswith("Presets")
                        for preset in presets[kind]}
        self.targets = {"all", "install"}
        for path in find_files(root, "CMakeLists.txt"):
            self.targets.update(re.findall(
                r"add_(?:executable|custom_target|library)\(\s*([\w-]+)", read(root, path)))

    def errors_of(self, command):
        """Sentences about one command, split in words."""
        while command and re.fullmatch(r"\w+=.*", command[0]):
            command = command[1:]  # a variable set for the command
        if not command:
            return
        program = command[0]
        if re.match(r"\.?/?build[\w-]*/bin/", program):
            if os.path.basename(program) not in self.targets:
                yield f"nothing builds {program}"
        elif "/" in program and not program.startswith(("/", "install")):
            path = os.path.join(self.root, program)
            if not os.access(path, os.X_OK) or os.path.isdir(path):
                yield f"{program} is no program of the project"
        elif os.path.basename(program) not in PROGRAMS | {"python3"}:
            yield f"{program} is not among the programs that the pages may call"
        if program == "cmake":
            for option, values, kind in (("--preset", self.presets, "preset"),
                                         ("--target", self.targets, "target")):
                for before, value in zip(command, command[1:]):
                    if before == option and value not in values:
                        yield f"there is no {kind} {value}"


def commands_of(code):
    """The commands of a block, as lists of words; a pipe or && ends a command."""
    text = code.replace("\\\n", " ")
    for line in text.splitlines():
        lexer = shlex.shlex(line, posix=True, punctuation_chars="|&;<>")
        lexer.whitespace_split = True
        lexer.commenters = "#"
        command = []
        for word in lexer:
            if word in ("|", "&&", "||", ";"):
                yield command
                command = []
            else:
                command.append(word)
        if command:
            yield command


def main(root):
    shell = ShellCheck(root)
    programs = {}
    for language, (ending, folders) in PROGRAMS_OF.items():
        programs[language] = [read(root, path) for path in find_files(root, ending)
                              if path.startswith(folders)]
    errors = []
    count = 0
    for path, page in read_pages(root).items():
        for number, language, code in page.blocks:
            count += 1
            where = f"{path}:{number}"
            if language in programs:
                if not any(stands_in(code, program) for program in programs[language]):
                    errors.append(f"{where}: no program in {' or '.join(PROGRAMS_OF[language][1])} has "
                                  f"this {language} code.")
            elif language == "sh":
                for command in commands_of(code):
                    errors.extend(f"{where}: {error}." for error in shell.errors_of(command))
            elif language == "cmake" and path == "README.md":
                pass  # build_project.py builds it
            elif language not in ("json", "text"):
                errors.append(f"{where}: nothing tests {language or 'unnamed'} code in this page.")
    finish(errors, f"{count} blocks of code")


if __name__ == "__main__":
    main(sys.argv[1])
