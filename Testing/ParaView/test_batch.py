# SPDX-License-Identifier: BSD-3-Clause
"""The whole chain in pvbatch, on one process or several, with the same result."""
from paraview import simple

import plugin
from plugin import expect_between, expect_equal, fetch

source = simple.Creature(Resolution=6000)
target = simple.Creature(Resolution=7000, Pose=0.5, Proportion=0.5, Seed=7)
skeletons = [simple.MSPSkeleton(Mesh=simple.MSPField(Mesh=mesh)) for mesh in (source, target)]
matched = simple.SkeletonCorrespondence(
    SourceSkeleton=skeletons[0], TargetSkeleton=skeletons[1])
transfer = simple.SegmentationTransfer(
    SourceMesh=simple.OutputPort(skeletons[0], 1), TargetMesh=simple.OutputPort(skeletons[1], 1),
    SourceSkeleton=simple.OutputPort(matched, 0), TargetSkeleton=simple.OutputPort(matched, 1))
simple.UpdatePipeline(proxy=target)
simple.UpdatePipeline(proxy=transfer)
metrics = simple.SegmentationMetrics(SegmentedMesh=transfer, Reference=target)
simple.UpdatePipeline(proxy=metrics)

information = transfer.GetDataInformation()
expect_equal(information.GetNumberOfCells(), target.GetDataInformation().GetNumberOfCells(), "cells")
accuracy = fetch(metrics).GetColumnByName("LabelAccuracy").GetTuple1(0)
expect_between(accuracy, 0.93, 1.0, "label accuracy")

view = plugin.new_view(500, 300)
display = simple.Show(transfer, view)
expect_equal(list(display.ColorArrayName), ["CELLS", "SegmentId"], "colours at once")
plugin.look_from(view, (0.4, 0.4, 1.0))
plugin.expect_picture(view, "ParaViewBatch")
plugin.finish()
