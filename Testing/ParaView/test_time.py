# SPDX-License-Identifier: BSD-3-Clause
"""A mesh that changes over time, as a series of files, labelled from one mesh: a part has one label for all of
time."""
import os

from paraview import simple

import plugin
from plugin import OUTPUT, expect_between, expect_equal, fetch, values

STEPS = 3


def biped(step):
    return simple.Creature(
        Shape="Biped", Pose=0.2 + 0.1 * step, Resolution=4000 + 500 * step, Seed=3)


# Not at the top: the script of a Programmable Filter runs there and brings names of its own.
def main():
    files = []
    truths = []
    for step in range(STEPS):
        files.append(os.path.join(OUTPUT, f"walk_{step}.vtp"))
        source = biped(step)
        truths.append(values(fetch(source).GetCellData().GetArray("SegmentId")))
        bare = simple.PassArrays(Input=source, CellDataArrays=[], PointDataArrays=[])
        simple.SaveData(files[-1], proxy=bare)
    series = simple.XMLPolyDataReader(FileName=files)
    labelled = simple.TimeSeriesTransfer(MeshoverTime=series, LabelledMesh=biped(5))
    expect_equal(list(labelled.Segments), ["CELLS", "SegmentId"], "the array at first")
    times = list(series.TimestepValues)
    expect_equal(len(times), STEPS, "number of steps")
    # Not in their order, as a user who drags the slider.
    for step in (2, 0, 1):
        labelled.SMProxy.UpdatePipeline(times[step])  # simple's takes the time 0 for none
        mesh = plugin.servermanager.Fetch(labelled)
        expect_equal(mesh.GetNumberOfCells(), len(truths[step]), f"faces of step {step}")
        labels = mesh.GetCellData().GetArray("SegmentId")
        right = sum(a == b for a, b in zip(values(labels), truths[step])) / len(truths[step])
        expect_between(right, 0.93, 1.0, f"share of right labels at step {step}")
        expect_equal(mesh.GetCellData().GetScalars().GetName(), "SegmentId", "what is shown")
    table = fetch(labelled, 1)
    expect_equal([table.GetValueByName(row, "Block").ToString() for row in range(table.GetNumberOfRows())],
                 ["step 0", "step 1", "step 2", "labelled 0"], "rows of the summary")


main()
plugin.finish()
