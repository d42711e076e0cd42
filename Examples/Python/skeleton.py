#!/usr/bin/python3
"""The limbs of a mesh, the branches of its skeleton that have a free end, and the parts around them.

    skeleton.py MESH PICTURE.png
"""
import sys

import numpy as np

import marrow

skeleton = marrow.skeleton(marrow.read(sys.argv[1]), progress_bar=True)
print(f"{len(skeleton.branches)} branches, {len(skeleton.terminals)} of the ends are free")

# The part of the surface that belongs to a branch, by way of its nodes.
branch_of_node = np.empty(len(skeleton.nodes), int)
for number, nodes in enumerate(skeleton.branches):
    branch_of_node[nodes] = number
branch_of_face = branch_of_node[skeleton.node_of_vertex[skeleton.mesh.faces[:, 0]]]

print("limb  length  mean radius  faces")
for number, nodes in enumerate(skeleton.branches):
    if np.intersect1d(nodes, skeleton.terminals).size:
        print(f"{number:4}  {skeleton.branch_length[number]:6.3g}  "
              f"{skeleton.radius[nodes].mean():11.3g}  {(branch_of_face == number).sum():5}")

marrow.render(skeleton, skeleton.mesh.with_segments(branch_of_face), color_skeleton_by="branch",
              path=sys.argv[2])
