# SPDX-License-Identifier: BSD-3-Clause
"""Whatever a file has wrong, however its mesh lies and in whatever format it comes: the same labels."""
import pathlib
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

import marrow
from example_runs import MESHES, camels_segments

MESHES_IN_ALL_FORMATS = ("cow", "bull", "dino", "hand", "homer", "pinion_small", "mushroom",
                         "elephant-with-holes", "cube_poly")


def rotation(seed):
    axes, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return axes * np.linalg.det(axes)


class TestMendedMeshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = marrow.creature("quadruped", resolution=5000)
        target = marrow.creature("quadruped", resolution=5000, seed=3, pose=0.4, proportion=0.5)
        cls.points = target.points.astype(float)
        cls.faces = target.faces
        cls.expected = cls.labels(cls.points, cls.faces)
        # What the other tests hold on to is right.
        assert marrow.evaluate(target.with_segments(cls.expected), target.segments).label_accuracy > 0.95

    @classmethod
    def transfer(cls, points, faces):
        return marrow.transfer(cls.source, (points, faces))

    @classmethod
    def labels(cls, points, faces):
        return cls.transfer(points, faces).segments

    def test_order(self):
        random = np.random.default_rng(1)
        new_of_old = random.permutation(len(self.points))
        points = np.empty_like(self.points)
        points[new_of_old] = self.points
        order = random.permutation(len(self.faces))
        corners = np.array([np.roll(face, turn) for face, turn in zip(
            new_of_old[self.faces][order], random.integers(0, 3, len(self.faces)))])
        np.testing.assert_array_equal(self.labels(points, corners), self.expected[order])

    def test_place_direction_and_unit(self):
        for points in (self.points @ rotation(2).T, self.points * 1000.0, self.points * 1e-200,
                       self.points * 1e200, self.points + [3, -40, 9]):
            np.testing.assert_array_equal(self.labels(points, self.faces), self.expected)

    def test_coordinates_of_a_map(self):
        labels = self.labels(self.points + [448262.0, 5411932.0, 112.0], self.faces)
        # Nine digits of each coordinate are left of sixteen.
        self.assertGreater((labels == self.expected).mean(), 0.97)

    def test_faces_that_look_inwards(self):
        np.testing.assert_array_equal(
            self.labels(self.points, self.faces[:, ::-1]), self.expected)
        some = self.faces.copy()
        some[::7] = some[::7, ::-1]
        mended = self.transfer(self.points, some)
        np.testing.assert_array_equal(mended.segments, self.expected)
        self.assertEqual(mended.note, f"turned {len(self.faces[::7])} faces")

    def test_seams(self):
        faces = np.arange(3 * len(self.faces)).reshape(-1, 3)
        mended = self.transfer(self.points[self.faces].reshape(-1, 3), faces)
        np.testing.assert_array_equal(mended.segments, self.expected)
        self.assertRegex(mended.note, "^merged [0-9,]+ equal points$")

    def test_points_that_no_face_uses(self):
        mended = self.transfer(np.vstack([[[900.0, 0.0, 0.0]], self.points]), self.faces + 1)
        np.testing.assert_array_equal(mended.segments, self.expected)
        self.assertEqual(mended.note, "left out 1 unused point")

    def test_a_face_twice(self):
        mended = self.transfer(self.points, np.vstack([self.faces, self.faces[:1, ::-1]]))
        np.testing.assert_array_equal(mended.segments[:-1], self.expected)
        self.assertEqual(mended.segments[-1], self.expected[0])

    def test_two_bodies(self):
        beside = self.points + [2.5 * np.ptp(self.points[:, 0]), 0.0, 0.0]
        labels = self.labels(
            np.vstack([self.points, beside]), np.vstack([self.faces, self.faces + len(self.points)]))
        np.testing.assert_array_equal(labels, np.tile(self.expected, 2))

    def test_bodies_that_share_a_point(self):
        top = self.points[:, 1].argmax()
        below = np.linalg.norm(self.points - [0, self.points[:, 1].min(), 0], axis=1).argmin()
        beside = self.points + (self.points[top] - self.points[below]) * [1, 1.0, 1]
        second = np.where(self.faces == below, top - len(self.points), self.faces)
        labels = self.labels(
            np.vstack([self.points, beside]), np.vstack([self.faces, second + len(self.points)]))
        self.assertEqual(set(labels), set(self.expected))

    def test_quads(self):
        # Each triangle as three quadrilaterals around its middle.
        edges = np.sort(self.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, edge_of_corner = np.unique(edges, axis=0, return_inverse=True)
        middles = len(self.points) + edge_of_corner.reshape(-1, 3)
        centers = len(self.points) + len(edges) + np.arange(len(self.faces))
        points = np.vstack([self.points, self.points[edges].mean(axis=1),
                            self.points[self.faces].mean(axis=1)])
        quads = np.stack([
            np.column_stack([self.faces[:, k], middles[:, k], centers, middles[:, k - 1]])
            for k in range(3)], axis=1).reshape(-1, 4)
        labels = self.labels(points, quads)
        self.assertEqual(len(labels), len(quads))
        self.assertGreater((labels == np.repeat(self.expected, 3)).mean(), 0.97)

    def test_the_source_may_need_mending_too(self):
        faces = np.vstack([self.source.faces[::-1], self.source.faces[-1:]])
        segments = np.append(self.source.segments[::-1], 77)
        labels = marrow.transfer(
            (self.source.points, faces), (self.points, self.faces), segments=segments).segments
        np.testing.assert_array_equal(labels, self.expected)


class TestFormats(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.camel = marrow.read(MESHES / "camel.off", segments=camels_segments())

    def write(self, writer, polydata, name, binary):
        path = self.folder / name
        writer.SetFileName(str(path))
        writer.SetInputData(polydata)
        getattr(writer, "SetFileTypeToBinary" if binary else "SetFileTypeToASCII")()
        writer.Write()
        return path

    def test_all_formats_give_the_same_labels(self):
        for name in MESHES_IN_ALL_FORMATS:
            mesh = marrow.read(MESHES / f"{name}.off")
            # What a file in single precision can hold.
            held = (mesh.points.astype(np.float32), mesh.faces)
            files = [self.folder / f"mesh.{ending}" for ending in ("off", "obj", "vtk", "vtp")]
            for path in files:
                marrow.write(held, path)
            polydata = marrow.read(files[-1]).polydata
            files.append(self.write(vtkPLYWriter(), polydata, "binary.ply", True))
            files.append(self.write(vtkPLYWriter(), polydata, "ascii.ply", False))
            if mesh.faces.shape[1] == 3:
                files.append(self.write(vtkSTLWriter(), polydata, "binary.stl", True))
            expected = None
            for path in files:
                read = marrow.read(path)
                self.assertEqual(len(read.faces), len(mesh.faces), path)
                labels = marrow.transfer(self.camel, read).segments
                expected = labels if expected is None else expected
                np.testing.assert_array_equal(labels, expected, f"{name} as {path.name}")


if __name__ == "__main__":
    unittest.main()
