# SPDX-License-Identifier: BSD-3-Clause
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import marrow
from shapes import prism

SMALL = {"tile_width": 160, "tile_height": 120}


def color_of(label):
    rgb = [0.0, 0.0, 0.0]
    marrow.vtk.vtkMarrowLabelColors.GetColor(label, rgb)
    return np.array(rgb)


class TestPicture(unittest.TestCase):
    def test_equal_segments_have_equal_colors(self):
        mesh = prism()
        zero = marrow.transfer(mesh, mesh, segments=np.zeros(len(mesh[1]), int))
        five = marrow.transfer(mesh, mesh, segments=np.full(len(mesh[1]), 5))
        picture = marrow.render(zero, five, zero, **SMALL)
        self.assertEqual((picture.shape, picture.dtype), ((120, 480, 3), np.uint8))
        tiles = np.split(picture, 3, axis=1)
        np.testing.assert_array_equal(tiles[0], tiles[2])
        for tile, label in zip(tiles, (0, 5)):
            center = tile[60, 80] / np.linalg.norm(tile[60, 80])
            expected = color_of(label) / np.linalg.norm(color_of(label))
            self.assertLess(np.abs(center - expected).max(), 0.15)

    def test_the_top_row_comes_first(self):
        creature = marrow.creature("biped")
        picture = marrow.render(creature, captions=["below"], **SMALL)
        background = picture[0, 0]
        rows = np.flatnonzero((picture != background).any(axis=(1, 2)))
        # The head touches the upper edge more closely than the feet the caption's space.
        self.assertLess(rows[0], 120 - 1 - rows[-1] + 20)
        dark = (picture.max(axis=2) < 90).any(axis=1)
        self.assertGreater(np.flatnonzero(dark).mean(), 60)

    def test_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.png"
            picture = marrow.render(marrow.creature("snake"), path=path, **SMALL)
            reader = vtkPNGReader()
            reader.SetFileName(str(path))
            reader.Update()
            pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
            np.testing.assert_array_equal(pixels.reshape(120, 160, 3)[::-1], picture)
            with self.assertRaisesRegex(marrow.Error, "must end in .png"):
                marrow.render(marrow.creature("snake"), path=path.with_suffix(".jpg"))
            with self.assertRaises(FileNotFoundError):
                marrow.render(marrow.creature("snake"), path=path.parent / "absent" / "a.png")

    def test_a_skeleton_shows_through_its_mesh(self):
        pair = marrow.correspond(marrow.creature("biped"), marrow.creature("biped", seed=2, pose=1))
        pictures = [
            marrow.render(pair.source.mesh, pair.target.mesh, **SMALL),
            marrow.render(pair.source, pair.target, **SMALL),
            marrow.render(
                pair.source, pair.target, color_skeleton_by="correspondence", **SMALL),
            marrow.render(pair.source, pair.target, show_links=True, **SMALL),
            marrow.render(pair.source, pair.target, surface_opacity=1.0, **SMALL),
            marrow.render(pair.source.mesh, pair.target.mesh, surface_array="MSP", **SMALL),
        ]
        for i, picture in enumerate(pictures):
            for other in pictures[:i]:
                self.assertTrue((picture != other).any(), i)

    def test_errors(self):
        creature = marrow.creature("snake")
        with self.assertRaisesRegex(marrow.Error, "render: .*mesh"):
            marrow.render()
        with self.assertRaisesRegex(marrow.Error, "captions: there are 2 for 1 meshes"):
            marrow.render(creature, captions=["one", "two"])
        with self.assertRaisesRegex(marrow.Error, "'node_type', 'correspondence'.* not 'height'"):
            marrow.render(creature, color_skeleton_by="height")
        with self.assertRaisesRegex(marrow.Error, "render: .*Height"):
            marrow.render(creature, surface_array="Height")

    def test_without_a_display(self):
        # VTK would end the process.
        without = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        script = (
            "import marrow\n"
            "try: marrow.render(marrow.creature('snake', resolution=5000))\n"
            "except marrow.Error as error: print(error)"
        )
        for environment in (without, {**without, "DISPLAY": ":987"}):
            done = subprocess.run([sys.executable, "-c", script], env=environment, text=True,
                                  capture_output=True, check=True)
            self.assertIn("no X display", done.stdout)


if __name__ == "__main__":
    unittest.main()
