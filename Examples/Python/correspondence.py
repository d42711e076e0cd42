#!/usr/bin/python3
"""Which parts of two meshes are the same.

    correspondence.py SOURCE TARGET PICTURE.png
"""
import sys

import marrow

source, target = marrow.read(sys.argv[1]), marrow.read(sys.argv[2])
pair = marrow.correspond(source, target, progress_bar=True)

print(f"{len(pair.nodes)} nodes and {len(pair.branches)} branches are matched, "
      f"confidence {pair.confidence:.2f}")
print("length on the source and on the target:")
for match in pair.branches:
    lengths = [side.branch_length[branches].sum()
               for side, branches in ((pair.source, match.source), (pair.target, match.target))]
    print(f"  branch {match.id}: {lengths[0]:.3g} and {lengths[1]:.3g}")

answers = pair.answers["GlobalCost"]
print(f"best of {len(answers)} answers; their costs: " + ", ".join(f"{c:.3f}" for c in answers[:5]))

marrow.render(pair.source, pair.target, color_skeleton_by="correspondence", show_links=True,
              path=sys.argv[3])
