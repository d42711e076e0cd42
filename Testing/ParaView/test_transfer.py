# SPDX-License-Identifier: BSD-3-Clause
"""The transfer between two creatures: two meshes are enough, and every stage can be taken apart."""
from paraview import simple

import plugin
from plugin import expect, expect_between, expect_equal, fetch, share_of_equal, values


def middle_of(mesh, segment):
    """The mean of the centres of a segment's faces."""
    labels = mesh.GetCellData().GetArray("SegmentId")
    cells = [i for i in range(mesh.GetNumberOfCells()) if labels.GetTuple1(i) == segment]
    corners = [mesh.GetPoint(mesh.GetCell(i).GetPointId(0)) for i in cells]
    return [sum(corner[axis] for corner in corners) / len(corners) for axis in range(3)]


# Not at the top: the script of a Programmable Filter runs there and brings names of its own.
def main():
    source = simple.Creature(Resolution=6000)
    target = simple.Creature(Resolution=7000, Pose=0.5, Proportion=0.5, Seed=7)
    # Nothing is updated before the filter is made: its default array must be right all the same.
    transfer = simple.SegmentationTransfer(SourceMesh=source, TargetMesh=target)
    expect_equal(list(transfer.Segments), ["CELLS", "SegmentId"], "the array at first")
    truth = fetch(target).GetCellData().GetArray("SegmentId")
    labelled = fetch(transfer)
    labels = labelled.GetCellData().GetArray("SegmentId")
    expect_between(share_of_equal(labels, truth), 0.93, 1.0, "share of right labels")
    confidence = labelled.GetCellData().GetArray("SegmentConfidence").GetRange()
    expect(0.0 <= confidence[0] < confidence[1] <= 1.0, f"confidence ranges over {confidence}")
    for port in (1, 2):
        boundaries = fetch(transfer, port)
        expect_equal(boundaries.GetNumberOfCells(), 7, f"boundaries of output {port}")

    # With the skeletons and their correspondence given, the result is the same.
    skeletons = [simple.MSPSkeleton(Mesh=mesh) for mesh in (source, target)]
    matched = simple.SkeletonCorrespondence(
        SourceSkeleton=skeletons[0], TargetSkeleton=skeletons[1])
    staged = simple.SegmentationTransfer(
        SourceMesh=simple.OutputPort(skeletons[0], 1), TargetMesh=simple.OutputPort(skeletons[1], 1),
        SourceSkeleton=simple.OutputPort(matched, 0), TargetSkeleton=simple.OutputPort(matched, 1))
    again = fetch(staged).GetCellData().GetArray("SegmentId")
    expect_equal(values(again), values(labels), "the labels by stages")
    # As by "(none)" in the panel.
    staged.SourceSkeleton = staged.TargetSkeleton = None
    staged.UpdatePipeline()
    algorithm = staged.SMProxy.GetClientSideObject()
    connections = [algorithm.GetNumberOfInputConnections(port) for port in range(6)]
    expect_equal(connections, [1, 1, 0, 0, 0, 0], "connections without the skeletons")

    # A point picked on the head of the one and on the tail of the other turns the creature round.
    head, tail = 2, max(values(truth))
    staged.HintsontheSource = simple.PointSource(Center=middle_of(fetch(source), head))
    staged.HintsontheTarget = simple.PointSource(Center=middle_of(fetch(target), tail))
    turned = values(fetch(staged).GetCellData().GetArray("SegmentId"))
    hits = [got == head for got, wanted in zip(turned, values(truth)) if wanted == tail]
    expect(sum(hits) > 0.5 * len(hits), "the hint turns the creature round")
    staged.HintsontheSource = staged.HintsontheTarget = None
    staged.Answer = 1
    expect(values(fetch(staged).GetCellData().GetArray("SegmentId")) != values(labels),
           "the second answer is the first")
    staged.Answer = 0
    staged.CarriedSegments = [2, 3]
    expect_equal(set(values(fetch(staged).GetCellData().GetArray("SegmentId"))), {-1, 2, 3},
                 "the carried segments")

    cut = fetch(simple.SegmentCutter(Mesh=transfer))
    expect(cut.GetNumberOfCells() > labelled.GetNumberOfCells(), "no face was cut")
    expect_equal(set(values(cut.GetCellData().GetArray("SegmentId"))), set(values(labels)),
                 "segments of the cut mesh")

    # Another array, chosen by its name, among several.
    renamed = simple.ProgrammableFilter(Input=source, Script="""
segments = inputs[0].CellData["SegmentId"]
output.CellData.append(segments * 0, "Aside")
output.CellData.append(segments + 20, "Parts")
""")
    by_name = simple.SegmentationTransfer(SourceMesh=renamed, TargetMesh=target, Segments=["CELLS", "Parts"])
    parts = values(fetch(by_name).GetCellData().GetArray("SegmentId"))
    expect_equal(parts, [v + 20 for v in values(labels)], "labels of the chosen array")

    # The snake draws strict boundaries only.
    transfer.StrictBoundaries = 1
    strict = values(fetch(transfer).GetCellData().GetArray("SegmentId"))
    transfer.SearchRegion = 0.0
    expect(values(fetch(transfer).GetCellData().GetArray("SegmentId")) != strict,
           "the snake's search region has no effect")
    transfer.SearchRegion = 0.02
    transfer.StrictBoundaries = 0

    # One picture of both: equal parts have equal colours, without a hand.
    view = plugin.new_view(500, 300)
    for proxy, place in ((source, [0.0, 0.0, 0.0]), (transfer, [0.0, 0.0, 2.0])):
        display = simple.Show(proxy, view)
        expect_equal(list(display.ColorArrayName), ["CELLS", "SegmentId"], "colours at once")
        display.Position = place
    plugin.look_from(view, (0.4, 0.4, 1.0))
    plugin.expect_picture(view, "ParaViewTransfer")
    plugin.finish()


main()
