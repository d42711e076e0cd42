#!/usr/bin/python3
"""What the surface is like: how far out it is, how thick the part is, how it is bent.

    measures.py MESH PICTURE.png
"""
import sys

import numpy as np

import marrow

mesh = marrow.read(sys.argv[1])
measures = marrow.measure(mesh, progress_bar=True)

thick, thin = np.percentile(measures.msp, [95, 5])
print(f"{len(measures.points)} vertices, {measures.msp_valid.mean():.1%} with a closed slice")
print(f"girth of the thick parts {thick:.3g}, of the thin ones {thin:.3g}, in units of the mesh")

marrow.render(
    measures, measures, measures,
    surface_array=["AGD", "MSP", "DihedralAngle"],
    captions=["average geodesic distance", "minimum slice perimeter", "dihedral angle"],
    path=sys.argv[2],
)
