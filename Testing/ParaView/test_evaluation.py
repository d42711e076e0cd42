# SPDX-License-Identifier: BSD-3-Clause
"""The metrics between a transferred segmentation and the one that the target was made with."""
from paraview import simple

import plugin
from plugin import expect_between, expect_equal, fetch, share_of_equal

NAMES = ("CutDiscrepancy", "HammingDistance", "MissingRate", "FalseAlarmRate", "RandError",
         "GlobalConsistencyError", "LocalConsistencyError", "LabelAccuracy", "BoundaryDistance")


def row(proxy):
    table = fetch(proxy)
    expect_equal(table.GetNumberOfRows(), 1, "rows")
    return {name: table.GetColumnByName(name).GetTuple1(0) for name in NAMES}


# Not at the top: the script of a Programmable Filter runs there and brings names of its own.
def main():
    target = simple.Creature(Resolution=6000, Pose=0.5, Seed=7)
    transfer = simple.SegmentationTransfer(SourceMesh=simple.Creature(Resolution=6000), TargetMesh=target)
    simple.UpdatePipeline(proxy=target)
    simple.UpdatePipeline(proxy=transfer)
    metrics = row(simple.SegmentationMetrics(SegmentedMesh=transfer, Reference=target))
    share = share_of_equal(fetch(transfer).GetCellData().GetArray("SegmentId"),
                           fetch(target).GetCellData().GetArray("SegmentId"))
    expect_between(metrics["LabelAccuracy"], share - 0.03, share + 0.03, "label accuracy (by area)")
    expect_between(metrics["RandError"], 1e-6, 0.06, "Rand error")
    expect_equal(metrics["HammingDistance"],
                 0.5 * (metrics["MissingRate"] + metrics["FalseAlarmRate"]), "Hamming distance")

    same = row(simple.SegmentationMetrics(SegmentedMesh=target, Reference=target))
    for name in NAMES:
        expect_equal(same[name], 1.0 if name == "LabelAccuracy" else 0.0, f"{name} of equal segments")

    # Two arrays of one mesh: the reference is chosen apart from the segments.
    two = simple.ProgrammableFilter(Input=target, Script="""
segments = inputs[0].CellData["SegmentId"]
output.CellData.append(segments, "SegmentId")
output.CellData.append((segments == 0).astype("i4"), "Torso")
""")
    simple.UpdatePipeline(proxy=two)
    coarse = row(simple.SegmentationMetrics(
        SegmentedMesh=two, Reference=two, Segments=["CELLS", "Torso"],
        ReferenceSegments=["CELLS", "SegmentId"]))
    expect_equal(coarse["GlobalConsistencyError"], 0.0, "consistency error of a refinement")
    expect_between(coarse["RandError"], 0.05, 0.9, "Rand error of torso and rest")
    plugin.finish()


main()
