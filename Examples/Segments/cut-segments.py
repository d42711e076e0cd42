#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts a mesh into segments along planes, and writes one segment number per face (.seg).

    cut-segments.py MESH.off RECIPE.txt OUT.seg

A recipe is a list of segments, in order:

    segment NUMBER NAME
      seed POINT              a place on the mesh that is in the segment
      side POINT DIRECTION    a plane through POINT; the segment is where DIRECTION points to
      ball POINT RADIUS       the segment is within RADIUS of POINT

A segment grows from the face nearest to its seed over all neighbours whose centres lie on the right
side of every plane and in every ball and which no earlier segment took. A segment without seed takes
what is left. A number may come twice. Faces that are left over are an error, and nothing is written.
"""
import math
import sys


def read_off(path):
    """The points and faces of an OFF file."""
    with open(path) as file:
        words = [word for line in file for word in line.split("#")[0].split()]
    if words[0] not in ("OFF", "COFF"):
        sys.exit(f"{path}: neither an OFF nor a COFF file.")
    number_of_points, number_of_faces, at = int(words[1]), int(words[2]), 4
    numbers_per_point = 7 if words[0] == "COFF" else 3
    points = []
    for _ in range(number_of_points):
        points.append(tuple(map(float, words[at:at + 3])))
        at += numbers_per_point
    faces = []
    for _ in range(number_of_faces):
        size = int(words[at])
        faces.append(tuple(map(int, words[at + 1:at + 1 + size])))
        at += 1 + size
    return points, faces


def read_recipe(path):
    """A list of segments: number, name, seed, planes as pairs of direction and offset."""
    segments = []
    with open(path) as file:
        for line in file:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0] == "segment":
                segments.append({"number": int(words[1]), "name": " ".join(words[2:]),
                                 "seed": None, "planes": [], "balls": []})
            elif words[0] == "seed" and len(words) == 4:
                segments[-1]["seed"] = tuple(map(float, words[1:]))
            elif words[0] == "side" and len(words) == 7:
                point, direction = map(float, words[1:4]), tuple(map(float, words[4:]))
                offset = sum(p * d for p, d in zip(point, direction))
                segments[-1]["planes"].append((direction, offset))
            elif words[0] == "ball" and len(words) == 5:
                point, radius = tuple(map(float, words[1:4])), float(words[4])
                segments[-1]["balls"].append((point, radius))
            else:
                sys.exit(f"{path}: cannot read the line '{line.strip()}'.")
    return segments


def neighbours_of(faces):
    """Per face the faces that share an edge with it."""
    around = {}
    for index, face in enumerate(faces):
        for a, b in zip(face, face[1:] + face[:1]):
            around.setdefault((min(a, b), max(a, b)), []).append(index)
    neighbours = [[] for _ in faces]
    for sharing in around.values():
        for a in sharing:
            neighbours[a] += [b for b in sharing if b != a]
    return neighbours


def grow(start, neighbours, allowed):
    """The faces that are reached from `start` over allowed faces."""
    reached, stack = {start}, [start]
    while stack:
        for face in neighbours[stack.pop()]:
            if face not in reached and allowed(face):
                reached.add(face)
                stack.append(face)
    return reached


def smooth(numbers, neighbours):
    """A face that only one edge joins to its segment goes over to the segment across the others."""
    for _ in range(10):
        for face, around in enumerate(neighbours):
            others = [numbers[other] for other in around if numbers[other] != numbers[face]]
            if len(others) == 2 and others[0] == others[1]:
                numbers[face] = others[0]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    points, faces = read_off(sys.argv[1])
    centers = [[sum(points[i][k] for i in face) / len(face) for k in range(3)] for face in faces]
    neighbours = neighbours_of(faces)
    numbers = [None] * len(faces)
    for segment in read_recipe(sys.argv[2]):
        def allowed(face):
            return numbers[face] is None and all(
                sum(c * d for c, d in zip(centers[face], direction)) > offset
                for direction, offset in segment["planes"]) and all(
                math.dist(centers[face], point) < radius for point, radius in segment["balls"])
        if segment["seed"]:
            start = min(range(len(faces)), key=lambda face: sum(
                (c - s) ** 2 for c, s in zip(centers[face], segment["seed"])))
        else:
            start = numbers.index(None)
        if not allowed(start):
            sys.exit(f"Segment {segment['number']} ({segment['name']}): its seed lies outside.")
        for face in grow(start, neighbours, allowed):
            numbers[face] = segment["number"]
    if None in numbers:
        sys.exit(f"{numbers.count(None)} faces are left over, the first at "
                 f"{centers[numbers.index(None)]}: correct the planes.")
    smooth(numbers, neighbours)
    with open(sys.argv[3], "w") as file:
        file.writelines(f"{number}\n" for number in numbers)


if __name__ == "__main__":
    main()
