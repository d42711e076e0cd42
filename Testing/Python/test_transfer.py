# SPDX-License-Identifier: BSD-3-Clause
import unittest
import warnings

import numpy as np

import marrow
from shapes import prism


class TestTransfer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = marrow.creature("quadruped")
        cls.target = marrow.creature("quadruped", pose=0.5, proportion=0.5, seed=7)
        cls.result = marrow.transfer(cls.source, cls.target)

    def test_parts_arrive_in_their_places(self):
        evaluation = marrow.evaluate(self.result, self.target)
        self.assertGreater(evaluation.label_accuracy, 0.94)
        self.assertEqual(set(self.result.segments), set(self.source.segments))
        self.assertEqual(self.result.segments.shape, (len(self.target.faces),))
        np.testing.assert_array_equal(self.result.faces, self.target.faces)

    def test_confidence(self):
        self.assertEqual(self.result.confidence.shape, self.result.segments.shape)
        self.assertTrue(0 <= self.result.confidence.min() <= self.result.confidence.max() <= 1)

    def test_numbers_are_names(self):
        renamed = 1000 - 7 * self.source.segments
        result = marrow.transfer(self.source, self.target, segments=renamed)
        np.testing.assert_array_equal(result.segments, 1000 - 7 * self.result.segments)

    def test_segments_by_the_name_of_an_array(self):
        polydata = marrow.Mesh(self.source.polydata).polydata.NewInstance()
        polydata.DeepCopy(self.source.polydata)
        polydata.GetCellData().GetArray("SegmentId").SetName("parts")
        result = marrow.transfer(polydata, self.target, segments="parts")
        np.testing.assert_array_equal(result.segments, self.result.segments)

    def test_skeletons_and_their_correspondence_are_used(self):
        pair = marrow.correspond(self.source, self.target)
        result = marrow.transfer(pair.source, pair.target)
        np.testing.assert_array_equal(result.segments, self.result.segments)
        # With a correspondence that exchanges the hind legs, so are their labels.
        skeleton = pair.target
        legs = sorted(skeleton.terminals, key=lambda node: skeleton.nodes[node][1])[:4]
        hind = sorted(legs, key=lambda node: skeleton.nodes[node][0])[:2]
        ends = [next(i for i, branch in enumerate(skeleton.branches) if node in branch)
                for node in hind]
        labels = [self.most_frequent_segment(skeleton, node) for node in hind]
        for values, (first, second) in (
                (skeleton.polydata.GetPointData().GetArray("CorrespondenceId"), hind),
                (skeleton.polydata.GetCellData().GetArray("BranchCorrespondenceId"), ends)):
            kept = values.GetValue(first)
            values.SetValue(first, values.GetValue(second))
            values.SetValue(second, kept)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            astray = marrow.transfer(pair.source, skeleton)
        for label, other in (labels, labels[::-1]):
            self.assertGreater((astray.segments[result.segments == label] == other).mean(), 0.8)

    def most_frequent_segment(self, skeleton, node):
        """The segment of the most faces round a node of the target's skeleton."""
        own = (skeleton.node_of_vertex == node)[self.target.faces].all(axis=1)
        return np.bincount(self.result.segments[own]).argmax()

    def middle_of(self, mesh, segment):
        """The point of a segment that is nearest to its middle."""
        points = np.unique(mesh.faces[mesh.segments == segment])
        distances = np.linalg.norm(mesh.points[points] - mesh.points[points].mean(axis=0), axis=1)
        return int(points[distances.argmin()])

    def test_a_hint_turns_the_mesh_round(self):
        head, tail = 2, self.source.segments.max()
        hint = (self.middle_of(self.source, head), self.middle_of(self.target, tail))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            turned = marrow.transfer(self.source, self.target, hints=[hint])
            forbidden = marrow.transfer(self.source, self.target, forbidden=[
                (self.middle_of(self.source, head), self.middle_of(self.target, head))])
        self.assertGreater((turned.segments[self.target.segments == tail] == head).mean(), 0.5)
        self.assertLess((forbidden.segments[self.target.segments == head] == head).mean(), 0.5)
        pair = marrow.correspond(self.source, self.target, hints=[hint])
        plain = marrow.correspond(self.source, self.target)
        self.assertNotEqual(pair.nodes, plain.nodes)

    def test_hints_name_points_that_there_are(self):
        with self.assertRaisesRegex(marrow.Error, "the target has no point 1000000, only 0 to"):
            marrow.transfer(self.source, self.target, hints=[(0, 1000000)])

    def test_the_next_answer(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            second = marrow.transfer(self.source, self.target, answer_index=1)
        self.assertTrue((second.segments != self.result.segments).any())
        with self.assertRaisesRegex(marrow.Error, "the number of answers is"):
            marrow.transfer(self.source, self.target, answer_index=1000)

    def test_chosen_segments_and_those_of_the_target(self):
        head = marrow.transfer(self.source, self.target, carried=[2])
        np.testing.assert_array_equal(
            head.segments, np.where(self.result.segments == 2, 2, -1))
        own = np.where(self.target.segments == 3, 50, -1)
        kept = marrow.transfer(
            self.source, self.target.with_segments(own), keep_target_segments=True)
        np.testing.assert_array_equal(kept.segments == 50, own == 50)

    def test_cut_along_boundaries(self):
        smooth = marrow.cut(self.result)
        whole = np.bincount(smooth.original_faces, minlength=len(self.result.faces)) == 1
        self.assertTrue(0 < (~whole).sum() < 0.2 * len(whole))
        np.testing.assert_array_equal(smooth.points[:len(self.result.points)], self.result.points)
        self.assertEqual(set(smooth.segments), set(self.result.segments))
        np.testing.assert_array_equal(
            marrow.cut(self.target, segments=self.result.segments).segments, smooth.segments)
        with self.assertRaisesRegex(marrow.Error, "no cell array"):
            marrow.cut((self.target.points, self.target.faces))

    def test_boundaries_correspond_point_by_point(self):
        source, target = self.result.source_boundaries, self.result.target_boundaries
        self.assertEqual(len(target.loops), 7)
        self.assertEqual(target.segments.shape, (7, 2))
        for index, (number, loop) in enumerate(zip(target.ids, target.loops)):
            other = int(np.flatnonzero(source.ids == number)[0])
            self.assertEqual(loop.shape, source.loops[other].shape)
            np.testing.assert_array_equal(loop[0], loop[-1])
            self.assertEqual(set(target.segments[index]), set(source.segments[other]))

    def test_errors_say_what_is_wrong(self):
        arrays = (self.source.points, self.source.faces)
        for source, segments, text in (
            (arrays, None, '^transfer: Source: the mesh has no cell array "SegmentId"'),
            (self.source, "parts", 'no cell array "parts" of segments; it has "SegmentId"'),
            (arrays, [1, 2, 3], r"has 3 tuples of 1 components but the mesh has \d+ cells"),
            (arrays, self.source.segments + 0.5, "is no integer at cell 0"),
        ):
            with self.assertRaisesRegex(marrow.Error, text):
                marrow.transfer(source, self.target, segments=segments)

    def test_what_cannot_be_matched_gives_a_warning(self):
        tube = prism()
        with self.assertWarnsRegex(marrow.MarrowWarning, "^transfer: .* missing altogether") as caught:
            marrow.transfer(self.source, tube)
        self.assertEqual(caught.filename, __file__)  # the user's line, not one of ours


if __name__ == "__main__":
    unittest.main()
