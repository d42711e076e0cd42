# SPDX-License-Identifier: BSD-3-Clause
"""Meshes with known answers, as numpy arrays."""
import numpy as np


def prism(sides=24, rings=21, radius=1.0, height=8.0):
    """A closed tube along z, its ends closed by fans: every slice across it is the same polygon."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    points = [np.column_stack([ring, np.full(sides, z)]) for z in np.linspace(0, height, rings)]
    points = np.vstack(points + [[[0, 0, 0], [0, 0, height]]])
    faces = []
    for level in range(rings - 1):
        for i in range(sides):
            a, b = level * sides + i, level * sides + (i + 1) % sides
            faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    bottom, top, last = rings * sides, rings * sides + 1, (rings - 1) * sides
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(bottom, j, i), (top, last + i, last + j)]
    return points, np.array(faces)


def tetrahedron():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    return points, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
