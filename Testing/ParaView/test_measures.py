# SPDX-License-Identifier: BSD-3-Clause
"""The MSP field of a creature, coloured by thickness."""
from paraview import simple

import plugin
from plugin import expect, expect_between, expect_equal, fetch, values

creature = simple.Creature(Resolution=6000)
fields = simple.MSPField(Mesh=creature)
points = fetch(fields).GetPointData()
for name, size in (("AGD", 1), ("MSP", 1), ("MSPCenter", 3), ("MSPNormal", 3), ("MSPGradient", 3),
                   ("MSPValid", 1), ("DihedralAngle", 1)):
    array = points.GetArray(name)
    expect(array is not None, f"there is no {name}")
    expect_equal(array.GetNumberOfComponents(), size, f"components of {name}")
expect_equal(points.GetArray("AGD").GetRange(), (0.0, 1.0), "range of AGD")

# The torso is thicker than a leg; a round torso of radius r has a perimeter of 2 pi r.
segments = values(fetch(creature).GetCellData().GetArray("SegmentId"))
surface = fetch(fields)
perimeters = values(points.GetArray("MSP"))


def mean_over(segment):
    corners = {surface.GetCell(i).GetPointId(k) for i, s in enumerate(segments) if s == segment
               for k in range(3)}
    return sum(perimeters[c] for c in corners) / len(corners)


expect_between(mean_over(0), 1.5, 2.2, "mean MSP of the torso")
expect_between(mean_over(3), 0.6, 1.2, "mean MSP of a front leg")

before = perimeters
fields.NumberOfSlices = 24
after = values(fetch(fields).GetPointData().GetArray("MSP"))
expect(sum(after) < sum(before), "twice the slices find no smaller perimeters")
fields.AGDMethod = "All Pairs"
exact = values(fetch(fields).GetPointData().GetArray("AGD"))
sampled = values(points.GetArray("AGD"))
mean = sum(abs(a - b) for a, b in zip(exact, sampled)) / len(exact)
expect_between(mean, 1e-6, 0.01, "mean difference of sampled and exact AGD")

view = plugin.new_view()
display = simple.Show(fields, view)
expect_equal(list(display.ColorArrayName), ["POINTS", "MSP"], "colours at once")
plugin.look_from(view, (0.3, 0.2, 1.0))
plugin.expect_picture(view, "ParaViewMeasures")
plugin.finish()
