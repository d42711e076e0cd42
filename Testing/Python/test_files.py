# SPDX-License-Identifier: BSD-3-Clause
import os
import pathlib
import tempfile
import unittest

import numpy as np

import marrow
from shapes import tetrahedron


class TestFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write_off(self, faces="3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"):
        path = self.folder / "mesh.off"
        path.write_text(f"OFF\n4 {faces.count(chr(10))} 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{faces}")
        return path

    def test_off_with_segments(self):
        points, faces = tetrahedron()
        (self.folder / "mesh.seg").write_text("3\n1\n4\n1\n")
        mesh = marrow.read(self.write_off(), segments=self.folder / "mesh.seg")
        np.testing.assert_array_equal(mesh.points, points)
        np.testing.assert_array_equal(mesh.faces, faces)
        np.testing.assert_array_equal(mesh.segments, [3, 1, 4, 1])

    def test_round_trip(self):
        mesh = marrow.creature("snake")
        for extension in (".vtp", ".vtk"):
            path = self.folder / ("snake" + extension)
            marrow.write(mesh, path)
            again = marrow.read(str(path))
            np.testing.assert_array_equal(again.points, mesh.points)
            np.testing.assert_array_equal(again.faces, mesh.faces)
            np.testing.assert_array_equal(again.segments, mesh.segments)

    def test_labels_of_any_name(self):
        mesh = marrow.creature("snake")
        for ending, labels in ((".ply", "SegmentId"), (".obj", "groups"), (".off", "colors")):
            path = self.folder / ("snake" + ending)
            marrow.write(mesh, path)
            again = marrow.read(path, segments=labels)
            np.testing.assert_array_equal(again.points, mesh.points)
            np.testing.assert_array_equal(again.segments, mesh.segments)
        with self.assertRaisesRegex(marrow.Error, 'snake.obj: .*no labels "part"; it has "groups"'):
            marrow.read(self.folder / "snake.obj", segments="part")

    def test_full_disk(self):
        os.symlink("/dev/full", self.folder / "full.vtp")
        with self.assertRaisesRegex(marrow.Error, "No space left"):
            marrow.write(tetrahedron(), self.folder / "full.vtp")

    def test_segments_alone(self):
        path = self.folder / "mesh.seg"
        marrow.write(tetrahedron(), path, segments=[7, -1, 7, 2])
        self.assertEqual(path.read_text().split(), ["7", "-1", "7", "2"])

    def test_skeleton(self):
        skeleton = marrow.skeleton(marrow.creature("snake"))
        path = self.folder / "skeleton.vtp"
        marrow.write(skeleton, path)
        self.assertGreater(path.stat().st_size, 1000)

    def test_polygons_stay_and_repeated_corners_become_one(self):
        (self.folder / "quad.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        self.assertEqual(marrow.read(self.folder / "quad.obj").faces.tolist(), [[0, 1, 2, 3]])
        (self.folder / "house.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\n"
                                               "f 1 2 3 4\nf 4 3 5\n")
        house = marrow.read(self.folder / "house.obj")
        self.assertEqual(house.faces.tolist(), [[0, 1, 2, 3], [3, 2, 4, -1]])
        measured = marrow.measure((house.points, house.faces))
        self.assertEqual(measured.faces.tolist(), house.faces.tolist())
        self.assertEqual(measured.note, "cut 1 polygon into triangles")
        facet = "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n"
        corners = ["vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n",
                   "vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"]
        (self.folder / "quad.stl").write_text(
            "solid\n" + "".join(facet.format(corner) for corner in corners) + "endsolid\n")
        self.assertEqual(len(marrow.read(self.folder / "quad.stl").points), 4)

    def test_errors(self):
        off = self.write_off()
        with self.assertRaises(FileNotFoundError):
            marrow.read(self.folder / "absent.off")
        with self.assertRaises(IsADirectoryError):
            os.mkdir(self.folder / "folder.off")
            marrow.read(self.folder / "folder.off")
        with self.assertRaisesRegex(marrow.Error, "must end in one of .off, .ply"):
            marrow.read(self.folder / "mesh.txt")
        with self.assertRaisesRegex(marrow.Error, "must end in one of .off, .ply, .obj, .vtp, .vtk, .seg"):
            marrow.write(tetrahedron(), self.folder / "mesh.stl")
        with self.assertRaises(FileNotFoundError):
            marrow.write(tetrahedron(), self.folder / "absent" / "mesh.vtp")
        (self.folder / "short.seg").write_text("3\n1\n")
        with self.assertRaisesRegex(marrow.Error, r"short\.seg.* 2 .* 4 "):
            marrow.read(off, segments=self.folder / "short.seg")
        with self.assertRaisesRegex(marrow.Error, "mesh.seg: .*SegmentId"):
            marrow.write(tetrahedron(), self.folder / "mesh.seg")
        with self.assertRaisesRegex(marrow.Error, r"mesh\.off"):
            marrow.read(self.write_off("3 0 1 9\n"))


if __name__ == "__main__":
    unittest.main()
