# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside ParaView's window: what a user does who picks two meshes and presses Apply."""
import os

from paraview.simple import *

source = Creature()
target = Creature(Pose=0.5, Proportion=0.5, Seed=7)
transfer = SegmentationTransfer(SourceMesh=source, TargetMesh=target)
view = GetActiveViewOrCreate("RenderView")
Show(transfer, view).SetScalarBarVisibility(view, True)
ResetCamera(view)
Render(view)
with open(os.environ["WINDOW_DONE"], "w", encoding="ascii") as file:
    file.write("done\n")
