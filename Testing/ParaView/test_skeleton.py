# SPDX-License-Identifier: BSD-3-Clause
"""The skeleton of a creature, and its glyphs."""
from paraview import simple

import plugin
from plugin import expect_between, expect_equal, fetch, values

creature = simple.Creature(Resolution=6000)
skeleton = simple.MSPSkeleton(Mesh=creature)
data = fetch(skeleton)
types = values(data.GetPointData().GetArray("NodeType"))
expect_equal(types.count(1), 6, "terminals of a quadruped")
expect_between(types.count(3), 1, 4, "junctions of a quadruped")
mesh = fetch(skeleton, 1)
nodes = values(mesh.GetPointData().GetArray("SkeletonNodeId"))
expect_equal((min(nodes), max(nodes)), (0, data.GetNumberOfPoints() - 1), "nodes of the vertices")
expect_equal(mesh.GetNumberOfCells(), fetch(creature).GetNumberOfCells(), "cells of the mesh")

# A chair has a loop at the back and two at the armrests.
chair = fetch(simple.MSPSkeleton(Mesh=simple.Creature(Shape="Chair", Resolution=6000)))
edges = sum(chair.GetCell(i).GetNumberOfPoints() - 1 for i in range(chair.GetNumberOfCells()))
expect_equal(edges - chair.GetNumberOfPoints() + 1, 3, "loops of a chair")

# Nodes stand wider and limbs are fewer where that is asked for.
skeleton.NodeSpacing = 0.05
expect_between(fetch(skeleton).GetNumberOfPoints(), 10, data.GetNumberOfPoints() // 2, "nodes")
skeleton.NodeSpacing = 0.012
skeleton.FinestArea = 0.2
types = values(fetch(skeleton).GetPointData().GetArray("NodeType"))
expect_between(types.count(1), 0, 5, "terminals at the coarsest")
skeleton.FinestArea = 0.004

glyphs = simple.SkeletonGlyphs(Skeleton=skeleton)
view = plugin.new_view()
simple.Show(glyphs, view).MapScalars = 0
surface = simple.Show(simple.OutputPort(skeleton, 1), view)
simple.ColorBy(surface, None)
surface.Opacity = 0.2
plugin.look_from(view, (0.3, 0.2, 1.0))
plugin.expect_picture(view, "ParaViewSkeleton")
plugin.finish()
