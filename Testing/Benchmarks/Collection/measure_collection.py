#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How accurate vtkCollectionTransfer is with k labelled meshes, with and without unlabelled company.

    PYTHONPATH=build/lib/python3/dist-packages measure_collection.py DATA -o result.csv
        [--category NAME]... [--sources K]... [--sets N] [--company] [--cache FOLDER]

DATA is laid out as for the segmentation benchmark: index.json (per category the ids of its meshes),
meshes/ID.off, labels/ID.seg. For every category and k, N sets of k labelled meshes are tried, evenly
spread; all others are labelled from them, together (company) and each alone, by the vote and from three on
also with what is learnt from the k. --company leaves out those alone, and --cache keeps what is found out about
pairs, which makes further runs short. A row has the mean label
accuracy over the area, and how many of the wrong faces are among the tenth that is least sure, over all
faces of the category. A target's own labels are never seen.
"""
import argparse
import csv
import json
import os
import sys

import numpy as np

import marrow
from marrow.vtk import vtkCollectionTransfer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData


def areas_of(mesh):
    corners = mesh.points[mesh.faces[:, :3]]
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)


def source_sets(n, k, count):
    """`count` sets of k of n, spread evenly; with k = n - 1 one target each."""
    count = min(count if k < n - 1 else n, n)
    return [sorted({(s * n // count + i * n // k) % n for i in range(k)}) for s in range(count)]


def label(transfer, bare, truths, sources, chosen):
    """{index: (labels, confidence)} of those of `chosen` that are no sources."""
    blocks = vtkMultiBlockDataSet()
    for block, index in enumerate(chosen):
        polydata = vtkPolyData()
        polydata.ShallowCopy(bare[index].polydata)
        if index in sources:
            polydata = marrow.Mesh(polydata).with_segments(truths[index]).polydata
        blocks.SetBlock(block, polydata)
    transfer.SetInputDataObject(blocks)
    transfer.Update()
    result = {}
    for block, index in enumerate(chosen):
        if index not in sources:
            cells = transfer.GetOutputDataObject(0).GetBlock(block).GetCellData()
            result[index] = tuple(vtk_to_numpy(cells.GetArray(name)).copy()
                                  for name in ("SegmentId", "SegmentConfidence"))
    return result


def score(results, truths, areas):
    """Mean accuracy, and the share of the wrong faces among the least sure tenth of the area."""
    accuracies, confidences, weights, wrong = [], [], [], []
    for index, (labels, confidence) in results:
        share = areas[index] / areas[index].sum()
        is_wrong = labels != truths[index]
        accuracies.append(1.0 - share[is_wrong].sum())
        confidences.append(confidence)
        weights.append(share)
        wrong.append(is_wrong)
    order = np.argsort(np.concatenate(confidences), kind="stable")
    weights = np.concatenate(weights)[order]
    wrong = np.concatenate(wrong)[order] * weights
    tenth = np.cumsum(weights) <= 0.1 * weights.sum()
    return np.mean(accuracies), wrong[tenth].sum() / max(wrong.sum(), 1e-12)


def collection_transfer(learning, cache):
    transfer = vtkCollectionTransfer()
    transfer.SetLearnFromSources(learning)
    transfer.SetCacheFolder(cache)
    return transfer


def measure(data, ids, options):
    bare = [marrow.read(os.path.join(data, "meshes", f"{i}.off")) for i in ids]
    truths = [np.loadtxt(os.path.join(data, "labels", f"{i}.seg"), dtype=int) for i in ids]
    areas = [areas_of(mesh) for mesh in bare]
    everyone = list(range(len(ids)))
    together = collection_transfer(False, options.cache)  # one for all sets: its pairs are matched once
    for k in options.sources or [1, 2, 3, 6, 7]:
        if k >= len(ids):
            continue
        for company in (True,) if options.company else (True, False):
            for learning in (False, True) if k > 2 and together.CanLearn() else (False,):
                together.SetLearnFromSources(learning)
                results = []
                for sources in source_sets(len(ids), k, options.sets):
                    targets = [i for i in everyone if i not in sources]
                    if company:
                        results += label(together, bare, truths, sources, everyone).items()
                        continue
                    for target in targets:
                        results += label(collection_transfer(learning, options.cache), bare, truths,
                                         sources, sorted([*sources, target])).items()
                yield k, company, learning, *score(results, truths, areas)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--category", action="append")
    parser.add_argument("--sources", type=int, action="append")
    parser.add_argument("--sets", type=int, default=3)
    parser.add_argument("--company", action="store_true")
    parser.add_argument("--cache")
    options = parser.parse_args()
    with open(os.path.join(options.data, "index.json"), encoding="utf-8") as file:
        index = json.load(file)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["category", "sources", "company", "learning", "accuracy", "wrong_in_least_sure_tenth"])
        for category in options.category or index:
            ids = index[category]["ids"]
            for k, company, learning, accuracy, found in measure(options.data, ids, options):
                row = [category, k, int(company), int(learning), f"{accuracy:.4f}", f"{found:.3f}"]
                table.writerow(row)
                file.flush()
                print(*row, file=sys.stderr)


if __name__ == "__main__":
    main()
