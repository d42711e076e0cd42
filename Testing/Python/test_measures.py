# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import marrow
from shapes import prism

SIDES, RADIUS, HEIGHT = 24, 1.5, 12.0


class TestMeasures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.measures = marrow.measure(prism(SIDES, 31, RADIUS, HEIGHT))
        z = cls.measures.points[:, 2]
        cls.middle = (z > 0.25 * HEIGHT) & (z < 0.75 * HEIGHT)

    def test_perimeter_and_its_center(self):
        polygon = 2 * SIDES * RADIUS * np.sin(np.pi / SIDES)
        msp = self.measures.msp[self.middle]
        np.testing.assert_allclose(msp, polygon, rtol=1e-6)
        center = self.measures.msp_center[self.middle]
        np.testing.assert_allclose(center[:, :2], 0.0, atol=1e-6)
        np.testing.assert_allclose(center[:, 2], self.measures.points[self.middle, 2], atol=1e-6)
        normal = self.measures.msp_normal[self.middle]
        np.testing.assert_allclose(np.abs(normal), [[0, 0, 1]] * len(normal), atol=1e-6)

    def test_the_thickness_does_not_change(self):
        self.assertLess(np.abs(self.measures.msp_gradient[self.middle]).max(), 1e-6)
        self.assertEqual(self.measures.msp_gradient.shape, (len(self.measures.points), 3))

    def test_middle_and_ends(self):
        agd = self.measures.agd
        self.assertEqual((agd.min(), agd.max()), (0.0, 1.0))
        z = self.measures.points[:, 2]
        self.assertAlmostEqual(z[agd.argmin()], HEIGHT / 2, delta=HEIGHT / 20)

    def test_convex_is_positive(self):
        self.assertEqual(self.measures.dihedral_angle.shape, (len(self.measures.points),))
        self.assertGreater(self.measures.dihedral_angle[self.middle].min(), 0.0)
        self.assertTrue(self.measures.msp_valid[self.middle].all())
        self.assertEqual(self.measures.msp_valid.dtype, bool)

    def test_parameters_reach_the_filter(self):
        creature = marrow.creature("capsule")
        two = marrow.measure(creature, number_of_slices=2).msp
        many = marrow.measure(creature, number_of_slices=48).msp
        self.assertLess(many.mean(), two.mean())
        exact = marrow.measure(creature, agd_method="all_pairs").agd
        sampled = marrow.measure(creature, agd_method="sampled").agd
        self.assertTrue(0 < np.abs(exact - sampled).max() < 0.05)


if __name__ == "__main__":
    unittest.main()
