# SPDX-License-Identifier: BSD-3-Clause
"""mesh.marrow of pyvista's meshes, found by its entry point (with a stand-in where pyvista is missing)."""
import os
import pathlib
import sys
import tomllib
import unittest
from importlib.metadata import entry_points, version

import pyvista_stand_in

pyvista_stand_in.provide()
import pyvista  # noqa: E402

import marrow  # noqa: E402


class TestPyvista(unittest.TestCase):
    def setUp(self):
        self.biped = marrow.creature("biped")
        self.other = marrow.creature("biped", pose=0.5, seed=7)
        self.mesh = pyvista.wrap(self.biped.polydata)

    def test_nothing_is_imported_before_it_is_asked_for(self):
        self.assertNotIn("pyvista", sys.modules["marrow"].__dict__)

    def test_the_results_are_those_of_the_functions(self):
        skeleton = self.mesh.marrow.skeleton(finest_area=0.01)
        self.assertIsInstance(skeleton, pyvista.PolyData)
        expected = marrow.skeleton(self.biped, finest_area=0.01)
        self.assertEqual(skeleton.GetNumberOfCells(), len(expected.branches))
        measured = self.mesh.marrow.measure(number_of_slices=6)
        self.assertTrue(
            (measured.point_data["MSP"] == marrow.measure(self.biped, number_of_slices=6).msp).all())

    def test_segments_are_carried(self):
        expected = marrow.transfer(self.biped, self.other).segments
        target = pyvista.wrap(self.other.polydata)
        labelled = self.mesh.marrow.transfer_to(target)
        self.assertIsInstance(labelled, pyvista.PolyData)
        self.assertTrue((labelled.cell_data["SegmentId"] == expected).all())
        moved = self.mesh.marrow.transfer_to(target, segments=self.biped.segments + 10)
        self.assertTrue((moved.cell_data["SegmentId"] == expected + 10).all())

    def test_errors_are_marrows(self):
        with self.assertRaisesRegex(marrow.Error, "^skeleton: "):
            pyvista.PolyData().marrow.skeleton()
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'finest'"):
            self.mesh.marrow.skeleton(finest=1)

    def test_the_wheel_says_the_same_as_the_build(self):
        with open(pathlib.Path(os.environ["MARROW_SOURCE"], "pyproject.toml"), "rb") as file:
            project = tomllib.load(file)["project"]
        found = {entry.name: entry.value for entry in entry_points(group="pyvista.accessors")
                 if entry.dist.name == project["name"]}
        self.assertEqual(found, project["entry-points"]["pyvista.accessors"])
        self.assertEqual(version(project["name"]), marrow.__version__)


if __name__ == "__main__":
    unittest.main()
