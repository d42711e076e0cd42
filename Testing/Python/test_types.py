# SPDX-License-Identifier: BSD-3-Clause
"""The type hints agree with the code, and with what a user writes (needs Debian's mypy)."""
import importlib.util
import os
import re
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
OPTIONS = ["--strict", "--ignore-missing-imports", "--allow-untyped-calls",
           "--allow-subclassing-any", "--enable-incomplete-feature=Unpack", "--no-error-summary"]


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class TestTypes(unittest.TestCase):
    # The difference from nothing is what mypy found.
    maxDiff = None

    def mypy(self, *arguments):
        package = os.environ["PYTHONPATH"].split(os.pathsep)[0]
        cache = os.path.join(os.environ["MARROW_TEST_OUTPUT"], "mypy")
        return subprocess.run(
            [sys.executable, "-m", "mypy", "--cache-dir", cache, *OPTIONS, *arguments],
            env={**os.environ, "MYPYPATH": package}, text=True, capture_output=True).stdout

    def test_the_package(self):
        self.assertEqual(self.mypy("-p", "marrow"), "")

    def test_a_program(self):
        program = os.path.join(HERE, "typed_program.py")
        with open(program) as file:
            expected = {number for number, line in enumerate(file, 1) if line.endswith("# error\n")}
        output = self.mypy(program)
        found = {int(number) for number in re.findall(r"program\.py:(\d+): error", output)}
        self.assertEqual(found, expected, output)


if __name__ == "__main__":
    unittest.main()
