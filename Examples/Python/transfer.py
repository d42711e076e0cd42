#!/usr/bin/python3
"""The segments of one mesh on another, how sure they are, and the lines between them.

    transfer.py SOURCE SEGMENTS.seg TARGET PICTURE.png
"""
import sys

import numpy as np

import marrow

source = marrow.read(sys.argv[1], segments=sys.argv[2])
result = marrow.transfer(source, marrow.read(sys.argv[3]), progress_bar=True)

print("segment  faces  confidence")
for segment in np.unique(result.segments):
    inside = result.segments == segment
    print(f"{segment:7}  {inside.sum():5}  {result.confidence[inside].mean():10.2f}")

for number, (left, right), loop in zip(
        result.target_boundaries.ids, result.target_boundaries.segments,
        result.target_boundaries.loops):
    length = np.linalg.norm(np.diff(loop, axis=0), axis=1).sum()
    print(f"boundary {number}, between segments {left} and {right}: length {length:.3g}")

marrow.render(source, result, result, surface_array=[None, None, "SegmentConfidence"],
              captions=["source", "target", "confidence"], path=sys.argv[4])
