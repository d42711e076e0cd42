# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the examples and of the pages share: Debian's meshes, and how to run a script."""
import os
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(os.environ["MARROW_SOURCE"])
OUTPUT = pathlib.Path(os.environ["MARROW_TEST_OUTPUT"])
EXAMPLES = SOURCE / "Examples" / "Python"
MESHES = pathlib.Path(os.environ["MARROW_BUILD"]) / "demo" / "meshes"


def camels_segments():
    """The segments of the camel, as Examples/demo.sh makes them."""
    path = OUTPUT / "camel.seg"
    if not path.exists():
        folder = SOURCE / "Examples" / "Segments"
        subprocess.run([sys.executable, folder / "cut-segments.py", MESHES / "camel.off",
                        folder / "camel.txt", path], check=True)
    return path


def run(*command, **options):
    """What a script writes to stdout; it must end well."""
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ends with {done.returncode}:\n{done.stderr}")
    return done.stdout
