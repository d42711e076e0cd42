# SPDX-License-Identifier: BSD-3-Clause
"""The installed package works, and without the build tree."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

BUILD = os.environ["MARROW_BUILD"]
SCRIPT = """
import marrow
labelled = marrow.transfer(marrow.creature("biped"), marrow.creature("biped", seed=3))
assert len(set(labelled.segments)) == 7
marrow.vtk.vtkMarrowSideBySideScene()
print(marrow.__file__, marrow.__version__)
print(open("/proc/self/maps").read())
"""


class TestInstall(unittest.TestCase):
    def test_it_runs_from_where_it_was_moved(self):
        output = pathlib.Path(os.environ["MARROW_TEST_OUTPUT"])
        for folder in ("installed", "moved"):
            shutil.rmtree(output / folder, ignore_errors=True)
        subprocess.run(["cmake", "--install", BUILD, "--prefix", output / "installed"], check=True,
                       stdout=subprocess.DEVNULL)
        (output / "installed").rename(output / "moved")
        packages = output / "moved" / pathlib.Path(os.environ["PYTHONPATH"]).relative_to(BUILD)
        self.assertTrue((packages / "marrow" / "py.typed").exists())
        done = subprocess.run([sys.executable, "-c", SCRIPT], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(packages)}, check=True)
        path, _, libraries = done.stdout.partition("\n")
        path, version = path.split()
        self.assertEqual(pathlib.Path(path).parent, packages / "marrow")
        self.assertRegex(version, r"^\d+\.\d+\.\d+$")
        ours = {line.split()[-1] for line in libraries.splitlines() if "Marrow" in line}
        self.assertGreater(len(ours), 10)
        for library in ours:
            self.assertTrue(library.startswith(str(output / "moved")), library)


if __name__ == "__main__":
    unittest.main()
