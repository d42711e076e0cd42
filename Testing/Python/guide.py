#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The code of Documentation/python.md, in its order."""

import numpy as np
import marrow

camel = marrow.read("meshes/camel.off", segments="animals/camel.seg")
cow = marrow.read("meshes/cow.off")
labelled = marrow.transfer(camel, cow, progress_bar=True)

print(np.bincount(labelled.segments))  # (m,) int: one per face
print(labelled.confidence.mean())      # (m,) float, 0 to 1: how sure each of them is
marrow.write(labelled, "cow.vtp")      # all arrays; "cow.seg" is for the segments alone

herd = {name: marrow.read(f"meshes/{name}.off") for name in ("camel", "cow", "bull")}
for mesh in marrow.collection(herd, segments={"camel": camel.segments}):
    print(mesh.name, "by", mesh.source or "hand", f"{mesh.sureness:.2f}", mesh.remark)

right = marrow.transfer(camel, cow, hints=[(740, 71)])

points, faces = camel.points, camel.faces  # (n, 3) float, (m, 3) int
by_arrays = marrow.transfer((points, faces), cow.polydata, segments=camel.segments)
assert (by_arrays.segments == labelled.segments).all()

head = np.where(labelled.segments == 1, 1, 0)
marrow.render(labelled, labelled.with_segments(head), path="head.png")

measures = marrow.measure(camel, number_of_slices=24)
print(measures.msp.max(), "is the girth where the camel is thickest")

skeleton = marrow.skeleton(measures)
for branch, length in zip(skeleton.branches, skeleton.branch_length):
    print(f"from node {branch[0]} to node {branch[-1]}: {length:.2f}")

pair = marrow.correspond(skeleton, cow)
for match in pair.nodes:
    print(f"node {match.source} is node {match.target} of the cow")
marrow.render(pair.source, pair.target, color_skeleton_by="correspondence", show_links=True,
              path="pair.png")

again = marrow.transfer(pair.source, pair.target)
print(marrow.evaluate(again, labelled.segments).rand_error)

broken = (points * np.nan, faces)
try:
    marrow.skeleton(broken, finest_area=0.002)
except marrow.Error as error:
    print(error)  # skeleton: The mesh has 10 points in use whose coordinates are not finite ...

twice = marrow.skeleton((points, np.vstack([faces, faces[:1]])))
print(twice.mesh.note)  # left out 1 face that is there twice

steps = []
marrow.measure(camel, progress=steps.append)
assert steps[-1] == 1.0

from marrow.vtk import vtkMSPSkeleton, vtkMarrowSkeletonGlyphs

algorithm = vtkMSPSkeleton()
algorithm.SetInputData(camel.polydata)
glyphs = vtkMarrowSkeletonGlyphs()
glyphs.SetInputConnection(algorithm.GetOutputPort(0))
glyphs.Update()
print(glyphs.GetOutput().GetNumberOfCells(), "triangles to draw the skeleton with")
