#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy over every source that build/ compiles, by the rules of .clang-tidy.

A source that was found clean is not looked at again until it, a file that it includes, its compile
command, the rules or clang-tidy change: what decides that is kept in the folder of ccache's kind,
~/.cache/marrow-tidy. Needs a finished build in build/; arguments restrict the run to the named sources.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build"
CACHE = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache"), "marrow-tidy")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def included_files():
    """Per object file what its compilation read, as ninja recorded it."""
    files, current = {}, None
    for line in output_of("ninja", "-C", BUILD, "-t", "deps").splitlines():
        if line.startswith("    "):
            current.append(line.strip())
        elif ": #deps" in line:
            current = files.setdefault(line.split(": #deps")[0], [])
    return files


def compile_commands():
    """The compilations of this project's own sources; what CMake generates is left out."""
    for entry in json.loads(output_of("ninja", "-C", BUILD, "-t", "compdb")):
        path = pathlib.Path(entry["file"])
        if path.suffix == ".cxx" and path.is_relative_to(SOURCE) and not path.is_relative_to(BUILD):
            words = shlex.split(entry["command"])
            # Without ccache before the compiler.
            first = next(i for i, word in enumerate(words) if word.endswith(("c++", "g++")))
            # GCC's warnings are the build's business.
            entry["command"] = shlex.join(w for w in words[first:] if not w.startswith("-W"))
            yield entry


class Key:
    """What decides about the findings in a source, as one number."""

    def __init__(self):
        self.common = (SOURCE / ".clang-tidy").read_text() + output_of("clang-tidy", "--version")
        self.files = included_files()
        self.known = {}

    def of_file(self, path):
        if path not in self.known:
            file = BUILD / path
            # Files of the system are told by their date: they come from packages.
            self.known[path] = (hashlib.sha256(file.read_bytes()).hexdigest()
                                if file.is_relative_to(SOURCE) else str(file.stat().st_mtime_ns))
        return self.known[path]

    def of_entry(self, entry):
        relative = [entry["command"].replace(str(SOURCE), "."), self.common]
        relative += [self.of_file(path) for path in self.files.get(entry["output"], [entry["file"]])]
        return hashlib.sha256("\n".join(relative).encode()).hexdigest()


def main():
    CACHE.mkdir(parents=True, exist_ok=True)
    named = {(pathlib.Path.cwd() / name).resolve() for name in sys.argv[1:]}
    key = Key()
    waiting = {}
    for entry in compile_commands():
        stamp = CACHE / key.of_entry(entry)
        if not stamp.exists() and (not named or pathlib.Path(entry["file"]) in named):
            waiting[entry["file"]] = (entry, stamp)
    print(f"clang-tidy: {len(waiting)} sources to look at", flush=True)

    with tempfile.TemporaryDirectory() as folder:
        database = pathlib.Path(folder, "compile_commands.json")
        database.write_text(json.dumps([entry for entry, _ in waiting.values()]))

        def check(item):
            path, (_, stamp) = item
            run = subprocess.run(["clang-tidy", "--quiet", "-p", folder, path],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            if run.returncode == 0:
                stamp.touch()
                return ""
            return run.stdout or run.stderr

        # A finding in a header comes once per source that includes it; it is printed once.
        seen = set()
        findings = 0
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            # As they end: one source that takes a minute holds back no other's findings.
            for done in concurrent.futures.as_completed(pool.submit(check, item) for item in waiting.items()):
                text = done.result()
                findings += bool(text)
                for line in text.splitlines():
                    if "error:" not in line or line not in seen:
                        print(line, flush=True)
                    seen.add(line)
    if findings:
        sys.exit(f"clang-tidy: findings in {findings} sources, see above.")


if __name__ == "__main__":
    main()
