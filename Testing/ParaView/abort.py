# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside ParaView's window: leaves it with a filter that takes long at the next rendering."""
import os

from paraview.simple import *

fine = [Creature(Resolution=60000, **individual) for individual in ({}, {"Pose": 0.5, "Seed": 7})]
coarse = [Creature(Resolution=3000, **individual) for individual in ({}, {"Pose": 0.5, "Seed": 7})]
for mesh in fine:
    UpdatePipeline(proxy=mesh)
transfer = SegmentationTransfer(SourceMesh=coarse[0], TargetMesh=coarse[1])
view = GetActiveViewOrCreate("RenderView")
Show(transfer, view)
ResetCamera(view)
Render(view)
transfer.SourceMesh, transfer.TargetMesh = fine
with open(os.environ["WINDOW_DONE"], "w", encoding="ascii") as file:
    file.write("done\n")
