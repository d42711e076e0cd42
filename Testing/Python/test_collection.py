# SPDX-License-Identifier: BSD-3-Clause
import tempfile
import unittest
import warnings

import numpy as np

import marrow


class TestCollection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.truth = {
            name: marrow.creature("biped", seed=seed, pose=0.5, proportion=0.5, resolution=5000)
            for seed, name in enumerate(["anna", "ben", "cleo"], 1)
        }
        cls.bare = {name: (mesh.points, mesh.faces) for name, mesh in cls.truth.items()}
        cls.segments = {"anna": cls.truth["anna"].segments}
        cls.result = list(marrow.collection(cls.bare, segments=cls.segments))

    def test_all_are_labelled_from_one(self):
        self.assertEqual([mesh.name for mesh in self.result], list(self.truth))
        self.assertEqual([mesh.is_source for mesh in self.result], [True, False, False])
        np.testing.assert_array_equal(self.result[0].segments, self.truth["anna"].segments)
        for mesh in self.result[1:]:
            evaluation = marrow.evaluate(mesh, self.truth[mesh.name])
            self.assertGreater(evaluation.label_accuracy, 0.9, mesh.name)
            self.assertEqual(mesh.source, "anna")
            self.assertTrue(0.0 <= mesh.confidence.min() <= mesh.confidence.max() <= 1.0)
            self.assertTrue(mesh.confidence.min() < mesh.sureness < mesh.confidence.max())

    def test_meshes_in_a_row_and_arrays_of_other_names(self):
        anna = self.truth["anna"].polydata.NewInstance()
        anna.DeepCopy(self.truth["anna"].polydata)
        anna.GetCellData().GetArray("SegmentId").SetName("parts")
        row = [anna, self.bare["ben"], self.bare["cleo"]]
        result = list(marrow.collection(row, segments={"0": "parts"}))
        self.assertEqual([mesh.name for mesh in result], ["0", "1", "2"])
        np.testing.assert_array_equal(result[1].segments, self.result[1].segments)

    def test_a_bad_mesh_comes_back_as_it_is(self):
        points, faces = self.bare["ben"]
        meshes = {**self.bare, "broken": (points * np.nan, faces)}
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = list(marrow.collection(meshes, segments=self.segments))
        self.assertIn("broken", str(caught[0].message))
        self.assertIsNone(result[3].segments)
        self.assertIsNone(result[3].confidence)
        self.assertTrue(result[3].remark)
        np.testing.assert_array_equal(result[1].segments, self.result[1].segments)

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(marrow.Error, "No mesh of the collection"):
            marrow.collection(self.bare)
        with self.assertRaisesRegex(marrow.Error, "'dora'"):
            marrow.collection(self.bare, segments={"dora": [1]})

    def test_files_remember(self):
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(2):
                result = list(
                    marrow.collection(self.bare, segments=self.segments, cache_folder=folder))
                np.testing.assert_array_equal(result[2].segments, self.result[2].segments)


class TestFuse(unittest.TestCase):
    def test_the_majority_wins(self):
        mesh = marrow.creature("biped")
        wrong = np.where(mesh.segments == 3, 4, mesh.segments)
        fused = marrow.fuse([mesh, mesh.with_segments(wrong), mesh])
        self.assertGreater(marrow.evaluate(fused, mesh).label_accuracy, 0.95)
        ids, shares = fused.shares
        self.assertEqual(shares.shape, (len(mesh.faces), len(ids)))
        np.testing.assert_allclose(shares.sum(axis=1), 1.0, atol=1e-5)
        np.testing.assert_allclose(fused.disagreement[mesh.segments == 3], 4.0 / 9.0, atol=1e-5)
        np.testing.assert_array_equal(fused.weights, 1.0)
        self.assertEqual(fused.confidence.shape, (len(mesh.faces),))

    def test_labellings_of_different_meshes_are_an_error(self):
        with self.assertRaisesRegex(marrow.Error, "Labelling 1"):
            marrow.fuse([marrow.creature("biped"), marrow.creature("snake")])
        with self.assertRaisesRegex(marrow.Error, "no labellings"):
            marrow.fuse([])


if __name__ == "__main__":
    unittest.main()
