# SPDX-License-Identifier: BSD-3-Clause
"""Each example runs, on real meshes, says what it should and leaves its picture."""
import contextlib
import io
import re
import sys
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import marrow
from example_runs import EXAMPLES, MESHES, OUTPUT, camels_segments, run

CAMEL, COW = MESHES / "camel.off", MESHES / "cow.off"


class TestExamples(unittest.TestCase):
    def run_example(self, name, *arguments, picture=None):
        """Runs it; the picture must show something."""
        picture = picture or OUTPUT / f"{name}.png"
        picture.unlink(missing_ok=True)
        text = run(EXAMPLES / f"{name}.py", *arguments)
        reader = vtkPNGReader()
        reader.SetFileName(str(picture))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        drawn = (pixels != pixels[0]).any(axis=1).mean()
        self.assertTrue(0.05 < drawn < 0.9, f"{name}: {drawn:.0%} of the picture is not background")
        return text

    def test_measures(self):
        text = self.run_example("measures", CAMEL, OUTPUT / "measures.png")
        self.assertRegex(text, r"9770 vertices, 100\.0% with a closed slice")

    def test_skeleton(self):
        text = self.run_example("skeleton", CAMEL, OUTPUT / "skeleton.png")
        self.assertRegex(text, "6 of the ends are free")  # head, feet, tail
        limbs = re.findall(r"^ *\d+ +[\d.]+ +[\d.]+ +(\d+)$", text, re.M)
        self.assertEqual(len(limbs), 6)
        self.assertTrue(all(int(faces) > 100 for faces in limbs))

    def test_correspondence(self):
        text = self.run_example("correspondence", CAMEL, COW, OUTPUT / "correspondence.png")
        self.assertGreaterEqual(len(re.findall(r"^  branch \d+: [\d.]+ and [\d.]+$", text, re.M)), 6)

    def test_transfer(self):
        text = self.run_example("transfer", CAMEL, camels_segments(), COW, OUTPUT / "transfer.png")
        self.assertEqual(len(re.findall(r"^ +\d+ +\d+ +[01]\.\d\d$", text, re.M)), 8)
        self.assertGreaterEqual(text.count("between segments"), 6)

    def test_collection(self):
        folder = OUTPUT / "collection"
        bad = OUTPUT / "bad.off"
        bad.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n")
        text = self.run_example(
            "collection", CAMEL, camels_segments(), folder,
            *(MESHES / f"{name}.off" for name in ("cow", "bull", "triceratops", "dino")), bad,
            picture=folder / "collection.png")
        for name in ("cow", "bull", "triceratops", "dino"):
            self.assertIn(f"{name}: confidence", text)
            mesh = marrow.read(MESHES / f"{name}.off", segments=folder / f"{name}.seg")
            self.assertEqual(set(mesh.segments), set(range(1, 9)))
        self.assertIn("bad: transfer: Target: None of the mesh's faces has an area", text)
        self.assertFalse((folder / "bad.seg").exists())

    def test_pick_branch(self):
        text = self.run_example("pick_branch", CAMEL, COW, OUTPUT / "pick_branch.png")
        self.assertRegex(text, r"^branches \[\d+\] of the source, \[\d+\] of the target$")


class TestPicking(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(EXAMPLES))
        import pick_branch
        cls.picker = pick_branch.BranchPicker(marrow.correspond(
            marrow.creature("biped"), marrow.creature("biped", pose=0.3, seed=4)))
        cls.picker.window.OffScreenRenderingOn()
        cls.picker.window.Render()

    def click(self, x, y):
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            self.picker.interactor.SetEventInformation(x, y)
            self.picker.interactor.InvokeEvent("LeftButtonPressEvent")
            self.picker.interactor.InvokeEvent("LeftButtonReleaseEvent")
        return told.getvalue()

    def test_a_click_on_a_branch_selects_it_and_its_match(self):
        self.assertEqual(len(self.picker.pair.branches), 6)
        for match in self.picker.pair.branches:
            with contextlib.redirect_stdout(io.StringIO()) as told:
                self.picker.click_on(match.source[0])
            self.assertEqual(
                told.getvalue(),
                f"branches {list(match.source)} of the source, {list(match.target)} of the target\n")
            target = self.picker.selected[1].GetLines().GetNumberOfCells()
            self.assertEqual(target, len(match.target))

    def test_a_click_beside_them_selects_nothing(self):
        self.assertEqual(self.click(3, 3), "")


if __name__ == "__main__":
    unittest.main()
