# SPDX-License-Identifier: BSD-3-Clause
import dataclasses
import unittest

import numpy as np

import marrow
from shapes import tetrahedron


class TestEvaluation(unittest.TestCase):
    def test_equal_segments(self):
        creature = marrow.creature("biped")
        values = dataclasses.asdict(marrow.evaluate(creature, creature))
        self.assertEqual(values.pop("label_accuracy"), 1.0)
        self.assertEqual(set(values.values()), {0.0})
        self.assertEqual(len(values), 8)

    def test_known_answer(self):
        # Faces 0, 1 and 3 have the area 1/2, face 2 has sqrt(3)/2.
        mesh, area = tetrahedron(), 1.5 + np.sqrt(3) / 2
        result = marrow.evaluate(mesh, [0, 0, 1, 1], segments=[0, 0, 0, 1])
        self.assertAlmostEqual(result.label_accuracy, 1.5 / area)
        # Of the 6 pairs of faces 3 are together here and 2 there, 1 of them in both.
        self.assertAlmostEqual(result.rand_error, 0.5)

    def test_reference_as_a_mesh(self):
        creature = marrow.creature("biped")
        other = creature.segments.copy()
        other[other == 2] = 1
        by_array = marrow.evaluate(creature, other)
        polydata = marrow.transfer(creature, creature).polydata.NewInstance()
        polydata.DeepCopy(creature.polydata)
        for i, segment in enumerate(other):
            polydata.GetCellData().GetArray("SegmentId").SetValue(i, segment)
        self.assertEqual(marrow.evaluate(creature, polydata), by_array)
        self.assertGreater(by_array.rand_error, 0.0)
        # One refines the other.
        self.assertEqual(by_array.global_consistency_error, 0.0)

    def test_errors(self):
        with self.assertRaisesRegex(marrow.Error, "^evaluate: .*3"):
            marrow.evaluate(tetrahedron(), [0, 0, 1], segments=[0, 0, 0, 1])
        with self.assertRaisesRegex(marrow.Error, "SegmentId"):
            marrow.evaluate(tetrahedron(), [0, 0, 1, 1])


if __name__ == "__main__":
    unittest.main()
