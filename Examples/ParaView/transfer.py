# SPDX-License-Identifier: BSD-3-Clause
"""The segments of one mesh carried to another, in ParaView:
    pvpython Examples/ParaView/transfer.py SOURCE.off SEGMENTS.seg TARGET.off PICTURE.png
Needs the plugin: see Wrapping/ParaView/README.md. Draws source and target beside each other."""
import sys

from paraview.simple import *

if len(sys.argv) != 5:
    sys.exit(__doc__)
if "SegmentationTransfer" not in globals():
    sys.exit("Load the plugin: set PV_PLUGIN_PATH to the folder that holds Marrow.so.")
source_file, segment_file, target_file, picture = sys.argv[1:]

source = SegmentsFromFile(Mesh=MarrowMeshReader(FileName=source_file), SegmentFile=segment_file)
target = MarrowMeshReader(FileName=target_file)
transfer = SegmentationTransfer(SourceMesh=source, TargetMesh=target)

views = []
for title, mesh in (("Source", source), ("Target", transfer)):
    view = CreateRenderView()
    view.ViewSize = [500, 400]
    view.OrientationAxesVisibility = 0
    Show(mesh, view)  # coloured by segment at once, equal segments alike
    Show(Text(Text=title), view)
    view.CameraPosition = [1.0, 0.4, 1.0]  # y is up
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    ResetCamera(view)
    views.append(view)
layout = CreateLayout()
AssignViewToLayout(view=views[0], layout=layout, hint=0)
layout.SplitViewHorizontal(views[0])
AssignViewToLayout(view=views[1], layout=layout, hint=2)
layout.SetSize(1000, 400)
SaveScreenshot(picture, layout, ImageResolution=[1000, 400])
