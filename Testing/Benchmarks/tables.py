#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures all that the tables of README.md and Documentation/limitations.md say, and writes it there.

    cmake --preset benchmark && cmake --build --preset benchmark
    Testing/Benchmarks/tables.py DATA RESULTS [--build FOLDER] [--only pairs|collections|speed]...

DATA is laid out as for the segmentation benchmark. What RESULTS has from an earlier call is not measured again: name
another folder for another version. It takes an hour and a half on two processors, nearly all of it for
collections. The sentences beside the tables are yours to look at.
"""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys

from ratios import SIZES, benchmark_times

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLLECTIONS = ROOT / "Testing" / "Benchmarks" / "Collection"
# The columns of the table by category in limitations.md, after its name.
COLUMNS = ("label_accuracy", "label_accuracy_median", "label_accuracy_worst", "label_accuracy_possible",
           "rigid_label_accuracy", "rand_error", "humans_rand_error")
GROUPS = {"the 11 with limbs": "with limbs", "all 19": "all"}
ROWS_OF_COLLECTIONS = {"with seven unlabelled meshes of the kind (`marrow collection`)": 1,
                       "with three labelled meshes of eight (`marrow collection`)": 3,
                       "with seven labelled meshes of eight (`marrow collection`)": 7}


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def fill(page, heading, cells):
    """Writes the cells of rows, {first cell: the others}, into the table below a line that starts with `heading`."""
    path = ROOT / page
    before, found, after = path.read_text(encoding="utf-8").partition("\n" + heading)
    if not found:
        sys.exit(f"{page} has no line that starts with {heading!r}.")
    table, end, rest = after.partition("\n\n")
    lines = table.split("\n")
    for i, line in enumerate(lines):
        first = line.strip("| ").split(" | ")[0]
        if first in cells:
            lines[i] = "| " + " | ".join([first, *cells.pop(first)]) + " |"
    if cells:
        sys.exit(f"{page}, {heading!r}: no row {', '.join(map(repr, cells))}.")
    path.write_text(before + found + "\n".join(lines) + end + rest, encoding="utf-8")


def number(text, digits=2):
    return f"{float(text):.{digits}f}" if text else "–"


def measure_pairs(data, results, build):
    folder = results / "pairs"
    subprocess.run([build / "bin" / "marrow-benchmark-segmentation", data, "-o", folder], check=True)
    of_categories = {row["category"]: row for row in rows_of(folder / "summary.csv")}
    groups = {name: of_categories[group] for name, group in GROUPS.items()}
    categories = {name: of_categories[name] for name in json.loads((data / "index.json").read_text())}
    fill("Documentation/limitations.md", "| category | label accuracy, mean", {
        name: [number(row[column]) for column in COLUMNS] for name, row in {**categories, **groups}.items()})
    fill("README.md", "| | categories with limbs", {
        "aligned rigidly as wholes, without skeletons": [number(row["rigid_label_accuracy"]) for row in groups.values()],
        "pair by pair (`marrow transfer`)": [number(row["label_accuracy"]) for row in groups.values()]})


def measure_collections(data, results, build):
    table = results / "collections.csv"
    if not table.exists():
        environment = dict(os.environ, PYTHONPATH=str(build / "lib" / "python3" / "dist-packages"))
        sources = [word for k in ROWS_OF_COLLECTIONS.values() for word in ("--sources", str(k))]
        subprocess.run([sys.executable, COLLECTIONS / "measure_collection.py", data, "-o", results / "unfinished.csv",
                        "--company", *sources], check=True, env=environment)
        (results / "unfinished.csv").rename(table)
    from plot_collection import WITH_LIMBS
    # By the defaults: what is learnt, where there is enough to learn from. Its rows come last.
    accuracy = {(row["category"], int(row["sources"])): float(row["accuracy"]) for row in rows_of(table)}
    categories = list(dict.fromkeys(category for category, _ in accuracy))
    means = {name: [sum(accuracy[category, k] for category in some) / len(some) for k in ROWS_OF_COLLECTIONS.values()]
             for name, some in zip(GROUPS, (WITH_LIMBS, categories))}
    fill("Documentation/limitations.md", "| category | 1 labelled", {
        **{category: [number(accuracy[category, k]) for k in ROWS_OF_COLLECTIONS.values()] for category in categories},
        **{name: [number(value, 3) for value in values] for name, values in means.items()}})
    fill("README.md", "| | categories with limbs", {
        row: [number(values[i]) for values in means.values()] for i, row in enumerate(ROWS_OF_COLLECTIONS)})


def measure_speed(_data, _results, build):
    times = benchmark_times(build / "bin", 3)
    fill("README.md", "| faces | Marrow", {
        f"{size:,}": [f"{times[f'{name}/{size}']:.2g}" for name in ("MeasuresAndSkeleton", "PeerMeanCurvatureSkeleton")]
        for size in SIZES})


def main():
    parts = {"pairs": measure_pairs, "collections": measure_collections, "speed": measure_speed}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-benchmark")
    parser.add_argument("--only", action="append", choices=parts)
    options = parser.parse_args()
    options.results.mkdir(parents=True, exist_ok=True)
    sys.path.insert(0, str(COLLECTIONS))
    for part in options.only or parts:
        parts[part](options.data, options.results, options.build)


if __name__ == "__main__":
    main()
