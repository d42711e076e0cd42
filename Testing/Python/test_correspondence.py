# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import marrow


def segment_of_nodes(skeleton):
    """The segment that most faces of a node's part of the surface have."""
    nodes = skeleton.node_of_vertex[skeleton.mesh.faces[:, 0]]
    votes = np.zeros((len(skeleton.nodes), skeleton.mesh.segments.max() + 1))
    np.add.at(votes, (nodes, skeleton.mesh.segments), 1)
    return votes.argmax(axis=1)


class TestCorrespondence(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = marrow.skeleton(marrow.creature("quadruped"))
        cls.target = marrow.skeleton(marrow.creature("quadruped", pose=0.5, proportion=0.5, seed=7))
        cls.pair = marrow.correspond(cls.source, cls.target)

    def test_extremities_are_matched_with_their_like(self):
        source, target = segment_of_nodes(self.source), segment_of_nodes(self.target)
        tips = [match for match in self.pair.nodes if match.source[0] in self.source.terminals]
        self.assertEqual(len(tips), 6)
        for match in tips:
            self.assertEqual(source[match.source].tolist(), target[match.target].tolist())

    def test_matches_are_those_of_the_arrays(self):
        nodes = self.pair.source.polydata.GetPointData().GetArray("CorrespondenceId")
        for match in self.pair.nodes:
            self.assertTrue(all(nodes.GetValue(i) == match.id for i in match.source))
        branches = self.pair.target.polydata.GetCellData().GetArray("BranchCorrespondenceId")
        self.assertEqual(len(self.pair.branches), 7)
        for match in self.pair.branches:
            self.assertTrue(all(branches.GetValue(i) == match.id for i in match.target))
            self.assertEqual((len(match.source), len(match.target)), (1, 1))

    def test_meshes_do_as_well(self):
        again = marrow.correspond(self.source.mesh, self.target.mesh.polydata)
        self.assertEqual(
            [match.target.tolist() for match in again.nodes],
            [match.target.tolist() for match in self.pair.nodes])

    def test_answers_from_the_best_to_the_worst(self):
        costs = self.pair.answers["GlobalCost"]
        self.assertGreater(len(costs), 1)
        self.assertTrue((np.diff(costs) >= 0).all())
        self.assertAlmostEqual(self.pair.answers["Confidence"][0], self.pair.confidence)
        second = marrow.correspond(self.source, self.target, leaf_index=1)
        self.assertAlmostEqual(second.confidence, self.pair.answers["Confidence"][1])
        with self.assertRaisesRegex(marrow.Error, "^correspond: .*LeafIndex"):
            marrow.correspond(self.source, self.target, leaf_index=len(costs))

    def test_the_error_names_the_side(self):
        mesh = marrow.creature("snake", resolution=5000)
        broken = (mesh.points * np.nan, mesh.faces)
        with self.assertRaisesRegex(marrow.Error, "^correspond: target: .*not finite"):
            marrow.correspond(mesh, broken)


if __name__ == "__main__":
    unittest.main()
