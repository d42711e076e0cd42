# SPDX-License-Identifier: BSD-3-Clause
"""The correspondence of two creatures' skeletons."""
from paraview import simple

import plugin
from plugin import expect, expect_equal, fetch, values

source = simple.MSPSkeleton(Mesh=simple.Creature(Resolution=6000))
target = simple.MSPSkeleton(
    Mesh=simple.Creature(Resolution=6000, Pose=0.5, Proportion=0.5, Seed=7))
matched = simple.SkeletonCorrespondence(SourceSkeleton=source, TargetSkeleton=target)
sides = [fetch(matched, side) for side in (0, 1)]
terminals = []
for side in sides:
    types = values(side.GetPointData().GetArray("NodeType"))
    ids = values(side.GetPointData().GetArray("CorrespondenceId"))
    terminals.append(sorted(i for i, t in zip(ids, types) if t == 1))
expect_equal(len(set(terminals[0])), 6, "terminals with a partner of their own")
expect_equal(terminals[0], terminals[1], "ids of the terminals")
branches = [sorted(set(values(s.GetCellData().GetArray("BranchCorrespondenceId")))) for s in sides]
expect_equal(branches[0], branches[1], "ids of the branches")
leaves = fetch(matched, 2)
expect(leaves.GetNumberOfRows() > 1, "there is only one leaf")
costs = values(leaves.GetColumnByName("GlobalCost"))
expect_equal(costs[0], min(costs), "cost of the best leaf")

matched.LeafIndex = 1
other = fetch(matched, 0).GetFieldData().GetArray("CorrespondenceConfidence").GetTuple1(0)
expect_equal(other, values(leaves.GetColumnByName("Confidence"))[1], "confidence of the second leaf")
matched.LeafIndex = 0
matched.Matcher = "Electors Voting"
voted = values(fetch(matched, 0).GetPointData().GetArray("CorrespondenceId"))
expect(max(voted) >= 0, "electors voting matches nothing")
matched.Matcher = "Correspondence Tree"

view = plugin.new_view()
for side, place in ((0, [0.0, 0.0, 0.0]), (1, [0.0, 0.0, 2.0])):
    display = simple.Show(simple.OutputPort(matched, side), view)
    expect_equal(
        list(display.ColorArrayName), ["CELLS", "BranchCorrespondenceId"], "colours at once")
    display.Position = place
    display.LineWidth = 6.0
plugin.look_from(view, (0.3, 0.5, 1.0))
plugin.expect_picture(view, "ParaViewCorrespondence")
plugin.finish()
