# SPDX-License-Identifier: BSD-3-Clause
"""Whether a picture of the screen shows a creature in the colours of its segments."""
import sys

import built_package  # noqa: F401
from vtkmodules.vtkIOImage import vtkPNGReader
from marrow.vtk import vtkMarrowLabelColors

SEGMENTS = 8  # of a quadruped
LEAST_PIXELS = 400  # more than in a legend
TOLERANCE = 0.06

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
scalars = reader.GetOutput().GetPointData().GetScalars()
colors = []
for label in range(SEGMENTS):
    rgb = [0.0, 0.0, 0.0]
    vtkMarrowLabelColors.GetColor(label, rgb)
    colors.append([c / max(rgb) for c in rgb])

# Light makes a colour darker and leaves its proportions. Every fourth pixel is enough.
counts = [0] * SEGMENTS
for i in range(0, scalars.GetNumberOfTuples(), 4):
    pixel = scalars.GetTuple3(i) if scalars.GetNumberOfComponents() == 3 else scalars.GetTuple4(i)[:3]
    brightest = max(pixel)
    if brightest < 40:
        continue
    for label, color in enumerate(colors):
        if all(abs(p / brightest - c) < TOLERANCE for p, c in zip(pixel, color)):
            counts[label] += 4
print("Pixels of each segment:", counts)
sys.exit(0 if min(counts) >= LEAST_PIXELS else "A segment is not to be seen: " + str(counts))
