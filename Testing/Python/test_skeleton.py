# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import marrow


class TestSkeleton(unittest.TestCase):
    def test_terminals_are_the_extremities(self):
        for shape, terminals in (("biped", 5), ("quadruped", 6), ("octopus", 9), ("snake", 2)):
            skeleton = marrow.skeleton(marrow.creature(shape))
            self.assertEqual(len(skeleton.terminals), terminals, shape)
            # A tree: branches join it, and it has no loop.
            ends = len(skeleton.terminals) + len(skeleton.junctions)
            self.assertEqual(len(skeleton.branches), ends - 1, shape)

    def test_a_ring_has_one_closed_branch(self):
        skeleton = marrow.skeleton(marrow.creature("torus"))
        self.assertEqual(len(skeleton.branches), 1)
        self.assertEqual(skeleton.branches[0][0], skeleton.branches[0][-1])
        self.assertEqual(len(skeleton.terminals), 0)

    def test_branches_lead_from_end_to_end(self):
        skeleton = marrow.skeleton(marrow.creature("biped"))
        ends = (marrow.NodeType.TERMINAL, marrow.NodeType.JUNCTION)
        self.assertEqual(skeleton.branch_length.shape, (len(skeleton.branches),))
        for branch, length in zip(skeleton.branches, skeleton.branch_length):
            self.assertIn(skeleton.node_type[branch[0]], ends)
            self.assertIn(skeleton.node_type[branch[-1]], ends)
            self.assertTrue((skeleton.node_type[branch[1:-1]] == marrow.NodeType.REGULAR).all())
            steps = np.diff(skeleton.nodes[branch], axis=0)
            self.assertAlmostEqual(np.linalg.norm(steps, axis=1).sum(), length)

    def test_every_vertex_belongs_to_a_node_that_is_near(self):
        skeleton = marrow.skeleton(marrow.creature("biped"))
        node = skeleton.node_of_vertex
        self.assertEqual(node.shape, (len(skeleton.mesh.points),))
        self.assertGreaterEqual(node.min(), 0)
        distance = np.linalg.norm(skeleton.mesh.points - skeleton.nodes[node], axis=1)
        mean = np.bincount(node, distance) / np.bincount(node)
        np.testing.assert_allclose(skeleton.radius, mean)

    def test_the_mesh_keeps_its_segments_and_has_measures(self):
        creature = marrow.creature("biped")
        skeleton = marrow.skeleton(creature)
        np.testing.assert_array_equal(skeleton.mesh.segments, creature.segments)
        self.assertEqual(skeleton.mesh.msp.shape, (len(creature.points),))

    def test_measures_that_are_there_are_used(self):
        coarse = marrow.measure(marrow.creature("biped"), number_of_slices=2)
        skeleton = marrow.skeleton(coarse)
        np.testing.assert_array_equal(skeleton.mesh.msp, coarse.msp)

    def test_parameters_reach_the_filter(self):
        creature = marrow.creature("biped")
        coarse = marrow.skeleton(creature, node_spacing=0.05)
        self.assertLess(len(coarse.nodes), len(marrow.skeleton(creature).nodes) / 2)

    def test_the_peer(self):
        try:
            skeleton = marrow.mean_curvature_skeleton(marrow.creature("snake", resolution=5000))
        except marrow.Error as error:
            self.assertIn("built without CGAL", str(error))
            self.skipTest(str(error))
        self.assertGreaterEqual(len(skeleton.terminals), 2)
        with self.assertRaisesRegex(marrow.Error, "^mean_curvature_skeleton: .*border"):
            mesh = marrow.creature("snake", resolution=5000)
            marrow.mean_curvature_skeleton((mesh.points, mesh.faces[len(mesh.faces) // 2:]))


if __name__ == "__main__":
    unittest.main()
