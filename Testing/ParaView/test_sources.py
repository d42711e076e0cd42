# SPDX-License-Identifier: BSD-3-Clause
"""The source and the readers, and the writer of segments."""
import os

from paraview import simple

import plugin
from marrow.vtk import vtkMarrowLabelColors
from plugin import expect, expect_between, expect_equal, fetch, values


def write(name, text):
    path = os.path.join(plugin.OUTPUT, name)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    return path


creature = simple.Creature(Shape="Octopus", Resolution=6000)
surface = fetch(creature)
expect_between(surface.GetNumberOfCells(), 5400, 6600, "triangles of the octopus")
segments = values(surface.GetCellData().GetArray("SegmentId"))
expect_equal(set(segments), set(range(9)), "segments of the octopus")
skeleton = fetch(creature, 1)
types = values(skeleton.GetPointData().GetArray("NodeType"))
expect_equal(types.count(1), 9, "terminals of the octopus")

view = plugin.new_view()
display = simple.Show(creature, view)
expect_equal(list(display.ColorArrayName), ["CELLS", "SegmentId"], "colours at once")
plugin.look_from(view, (1.0, 0.8, 1.5))
plugin.expect_picture(view, "ParaViewCreature")

# A .seg file there and back: the written file is read onto the same mesh, all numbers equal.
seg = os.path.join(plugin.OUTPUT, "octopus.seg")
simple.SaveData(seg, creature)
with open(seg, encoding="ascii") as file:
    expect_equal([int(line) for line in file], [int(s) for s in segments], "the written segments")
shifted = write("shifted.seg", "".join(f"{int(s) + 100}\n" for s in segments))
labelled = simple.SegmentsFromFile(Mesh=creature, SegmentFile=shifted)
read = values(fetch(labelled).GetCellData().GetArray("SegmentId"))
expect_equal(read, [s + 100 for s in segments], "segments read from a file")

# Of its own accord ParaView would look for 32 segments, and paint more than that grey.
count = surface.GetNumberOfCells()
many = [i * 200 // count + 56 for i in range(count)]
labelled.SegmentFile = write("many.seg", "".join(f"{s}\n" for s in many))
simple.Hide(creature, view)
# The colour map has been used before and knows those segments only.
simple.Show(labelled, view).RescaleTransferFunctionToDataRange(True)
plugin.expect_picture(view, "ParaViewManySegments")
colors = simple.GetColorTransferFunction("SegmentId")
expected = {str(int(s)) for s in segments + many}
expect_equal(set(colors.ActiveAnnotatedValues), expected, "segments with colours")
wanted = [0.0, 0.0, 0.0]
vtkMarrowLabelColors.GetColor(255, wanted)
for c, w in zip(colors.IndexedColors[-3:], wanted):
    expect_between(c, w - 1e-5, w + 1e-5, "the last segment's colour")

# ParaView's own Open finds the reader by the file's ending.
off = write("tetrahedron.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
            "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
mesh = simple.OpenDataFile(off)
expect(mesh is not None, "no reader opens an OFF file")
expect_equal(mesh.SMProxy.GetXMLName(), "MarrowMeshReader", "reader of an OFF file")
data = fetch(mesh)
expect_equal((data.GetNumberOfPoints(), data.GetNumberOfCells()), (4, 4), "points and triangles")
expect_equal(data.GetPoint(3), (0.0, 0.0, 1.0), "last point")
plugin.finish()
