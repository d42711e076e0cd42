#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Label accuracy of transfers between meshes of libcgal-demo, against accuracy.csv.

Carries the segments of every source of the table to its targets by `marrow transfer`, and compares
them with the target's own segments by `marrow evaluate`. Fails where the share of the area with the
right label is below the threshold of the pair. --write measures all pairs and writes the table.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE / "accuracy.csv"
SEGMENTS = HERE.parents[1] / "Examples" / "Segments"
COLUMNS = ["source", "target", "reached", "threshold"]
# How far below the reached accuracy a threshold is: what another compiler's rounding may change.
MARGIN = 0.01
# Meshes of the same shape as another one, and cut by its recipe.
RECIPE_OF = {"refined_elephant": "elephant"}


def read_table():
    with open(TABLE, newline="") as file:
        return list(csv.DictReader(file))


def write_table(rows):
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def cut(names, meshes, work):
    """Writes the segments of the meshes by their recipes."""
    for name in names:
        recipe = SEGMENTS / f"{RECIPE_OF.get(name, name)}.txt"
        subprocess.run([sys.executable, SEGMENTS / "cut-segments.py", meshes / f"{name}.off", recipe,
                        work / f"{name}.seg"], check=True)


def measure(source, targets, arguments):
    """The label accuracy of each target."""
    meshes, work = arguments.meshes, arguments.work
    # A folder as output: one labelled mesh per target, also where there is only one.
    results = work / source
    results.mkdir(exist_ok=True)
    subprocess.run([arguments.marrow, "--quiet", "transfer", meshes / f"{source}.off",
                    *(meshes / f"{target}.off" for target in targets),
                    "--segments", work / f"{source}.seg", "--output", results], check=True)
    accuracies = {}
    for target in targets:
        answer = subprocess.run(
            [arguments.marrow, "evaluate", results / f"{target}.vtp",
             "--reference", work / f"{target}.seg", "--json"],
            check=True, capture_output=True, text=True).stdout
        accuracies[target] = json.loads(answer)["mean"]["LabelAccuracy"]
    return accuracies


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--marrow", required=True, help="the command")
    parser.add_argument("--meshes", type=pathlib.Path, required=True,
                        help="folder that Examples/get-meshes.sh filled")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for results")
    parser.add_argument("--source", help="only the pairs with this source")
    parser.add_argument("--cut-only", action="store_true", help="only cut the meshes into segments")
    parser.add_argument("--write", action="store_true", help="measure all pairs, write the table")
    arguments = parser.parse_args()

    rows = read_table()
    if arguments.cut_only or arguments.write:
        names = sorted({row[side] for row in rows for side in ("source", "target")})
        cut(names, arguments.meshes, arguments.work)
    if arguments.cut_only:
        return
    failures = 0
    for source in dict.fromkeys(row["source"] for row in rows):
        if arguments.source not in (None, source):
            continue
        pairs = [row for row in rows if row["source"] == source]
        accuracies = measure(source, [row["target"] for row in pairs], arguments)
        for row in pairs:
            accuracy = accuracies[row["target"]]
            if arguments.write:
                row["reached"] = f"{accuracy:.3f}"
                row["threshold"] = f"{max(0, math.floor((accuracy - MARGIN) * 100) / 100):.2f}"
            failed = accuracy < float(row["threshold"])
            failures += failed
            print(f"{source} -> {row['target']}: {accuracy:.3f}, threshold {row['threshold']}"
                  + (f": FELL from {row['reached']}" if failed else ""))
    if arguments.write:
        write_table(rows)
    if failures:
        sys.exit(f"{failures} pairs are below their thresholds in {TABLE.name}.")


if __name__ == "__main__":
    main()
