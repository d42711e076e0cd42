# SPDX-License-Identifier: BSD-3-Clause
"""The four lines of the README and the code of the guide."""
import os
import re
import tempfile
import unittest

import numpy as np

import marrow
from example_runs import EXAMPLES, MESHES, SOURCE, camels_segments, run


def blocks_of(page):
    return re.findall(r"^```python\n(.*?)^```$", (SOURCE / page).read_text("utf-8"), re.M | re.S)


class TestDocumentation(unittest.TestCase):
    def setUp(self):
        """A folder as Examples/demo.sh leaves it."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.symlink(MESHES, os.path.join(self.folder, "meshes"))
        os.mkdir(os.path.join(self.folder, "animals"))
        os.symlink(camels_segments(), os.path.join(self.folder, "animals", "camel.seg"))

    def test_four_lines_transfer_a_segmentation(self):
        lines = (EXAMPLES / "four_lines.py").read_text()
        self.assertEqual(lines.count("\n"), 4)
        self.assertIn(lines, blocks_of("README.md"))
        run("-c", lines, cwd=self.folder)
        cow = marrow.read(os.path.join(self.folder, "cow.vtp"))
        np.testing.assert_array_equal(cow.faces, marrow.read(MESHES / "cow.off").faces)
        self.assertEqual(set(cow.segments), set(range(1, 9)))
        # The camel's neck and head are carried to the front, its tail to the back.
        center = {number: cow.points[cow.faces[cow.segments == number]].mean(axis=(0, 1))
                  for number in range(1, 9)}
        body = center[8] - center[1]
        places = [center[number] @ body for number in (1, 2, 3, 8)]
        self.assertEqual(places, sorted(places))

    def test_the_guide(self):
        code = "\n".join(blocks_of("Documentation/python.md"))
        guide = (SOURCE / "Testing" / "Python" / "guide.py").read_text()
        # Documentation.Code looks for the blocks in files: here they are, in order and nothing else.
        self.assertEqual(guide.partition('"""\n\n')[2], code)
        run(SOURCE / "Testing" / "Python" / "guide.py", cwd=self.folder)


if __name__ == "__main__":
    unittest.main()
