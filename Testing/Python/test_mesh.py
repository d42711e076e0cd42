# SPDX-License-Identifier: BSD-3-Clause
"""What is taken for a mesh, what comes out, and that what goes in stays as it is."""
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

import marrow
from shapes import prism, tetrahedron


class OtherPolyData(vtkPolyData):
    """As pyvista's: a subclass with attributes of its own under names that we use too."""

    points = "not an array"
    faces = "not an array"
    segments = "not an array"


def other(mesh):
    polydata = OtherPolyData()
    polydata.ShallowCopy(mesh.polydata)
    return polydata


class TestMesh(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = marrow.creature("biped", resolution=5000)
        cls.target = marrow.creature("biped", pose=0.5, seed=7, resolution=5000)

    def test_arrays_come_back_as_they_went_in(self):
        points, faces = prism()
        for kind in (np.float32, np.float64):
            for index in (np.int32, np.int64, np.uint16):
                measures = marrow.measure((points.astype(kind), faces.astype(index)))
                np.testing.assert_array_equal(measures.points, points.astype(kind))
                self.assertEqual(measures.points.dtype, kind)
                np.testing.assert_array_equal(measures.faces, faces)

    def test_lists_and_strided_arrays(self):
        points, faces = prism()
        plain = marrow.measure((points, faces)).msp
        wide = np.zeros((len(points), 6))
        wide[:, ::2] = points
        np.testing.assert_array_equal(marrow.measure((wide[:, ::2], faces)).msp, plain)
        np.testing.assert_array_equal(
            marrow.measure((points.tolist(), faces.tolist())).msp, plain)
        np.testing.assert_array_equal(
            marrow.measure((np.asfortranarray(points), np.asfortranarray(faces))).msp, plain)

    def test_every_form_of_a_mesh_gives_the_same(self):
        expected = marrow.transfer(self.source, self.target).segments
        arrays = [(mesh.points, mesh.faces) for mesh in (self.source, self.target)]
        for source, target in (
            (self.source.polydata, self.target.polydata),
            (other(self.source), other(self.target)),
            (arrays[0], arrays[1]),
            (other(self.source), arrays[1]),
        ):
            result = marrow.transfer(source, target, segments=self.source.segments)
            np.testing.assert_array_equal(result.segments, expected)
            # VTK 9.4 and later have a subclass of Python's for it.
            self.assertIs(type(result.polydata), type(vtkPolyData()))

    def test_inputs_are_not_changed(self):
        source, target = other(self.source), other(self.target)
        points = self.source.points.copy()
        before = [(mesh.GetMTime(), mesh.GetPointData().GetNumberOfArrays(),
                   mesh.GetCellData().GetNumberOfArrays()) for mesh in (source, target)]
        marrow.measure(source)
        marrow.skeleton(source)
        pair = marrow.correspond(source, target)
        marrow.transfer(source, target, segments=np.zeros(len(self.source.faces), int))
        marrow.transfer(pair.source, pair.target)
        marrow.evaluate(source, self.source.segments, segments=self.source.segments + 1)
        after = [(mesh.GetMTime(), mesh.GetPointData().GetNumberOfArrays(),
                  mesh.GetCellData().GetNumberOfArrays()) for mesh in (source, target)]
        self.assertEqual(before, after)
        np.testing.assert_array_equal(self.source.points, points)

    def test_arrays_of_the_user_are_copied(self):
        points, faces = prism()
        measures = marrow.measure((points, faces))
        points[:] = 0
        faces[:] = 0
        self.assertEqual(measures.points[:, 2].max(), 8.0)
        self.assertGreater(measures.faces.max(), 0)

    def test_views_outlive_their_mesh_and_cannot_be_written(self):
        msp = marrow.measure(prism()).msp
        self.assertGreater(msp.sum(), 0)
        with self.assertRaises(ValueError):
            msp[0] = 0

    def test_arrays_of_the_user_are_kept(self):
        kept = marrow.transfer(self.source, marrow.measure(self.target)).polydata.GetPointData()
        self.assertTrue(kept.HasArray("AGD"))
        self.assertTrue(kept.HasArray("SkeletonNodeId"))

    def test_a_mesh_without_segments(self):
        self.assertIsNone(marrow.measure(tetrahedron()).segments)

    def test_other_segments(self):
        mesh = marrow.measure(tetrahedron())
        np.testing.assert_array_equal(mesh.with_segments([4, 3, 2, 1]).segments, [4, 3, 2, 1])
        self.assertIsNone(mesh.segments)
        for wrong in ([4, 3, 2], [[4, 3, 2, 1]], 4):
            with self.assertRaisesRegex(marrow.Error, r"segments must have the shape \(4,\)"):
                mesh.with_segments(wrong)

    def test_what_is_no_mesh(self):
        points, faces = tetrahedron()
        for mesh, kind, text in (
            ((points[:, :2], faces), marrow.Error,
             r"points must have the shape \(n, 3\), not \(4, 2\)"),
            ((points, faces[0]), marrow.Error, r"faces must have the shape \(m, 3\) or \(m, k > 3\), not \(3,\)"),
            ((points, faces + 0.5), TypeError, "faces must be integers, not float64"),
            ((points, faces + 1), marrow.Error,
             "3 faces name a point that does not exist, the first is face 1: indices run from 0 to 3"),
            ((points, faces - 1), marrow.Error, "3 faces name a point that does not exist"),
            (points, TypeError, "a mesh is a vtkPolyData, .* not ndarray"),
            (None, TypeError, "not NoneType"),
        ):
            with self.assertRaisesRegex(kind, text):
                marrow.measure(mesh)

    def test_lines_are_no_faces(self):
        polydata = vtkPolyData()
        polydata.ShallowCopy(marrow.measure(tetrahedron()).polydata)
        polydata.SetLines(polydata.GetPolys())
        with self.assertRaisesRegex(marrow.Error, "cells that are no polygons"):
            marrow.Mesh(polydata).faces


if __name__ == "__main__":
    unittest.main()
