# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own Python has the package marrow, and it works beside the plugin."""
from paraview import simple

import plugin
import marrow
from plugin import expect_equal, fetch, values


def main():
    source = simple.Creature(Shape="Biped")
    target = simple.Creature(Shape="Biped", Pose=0.5, Seed=7)
    by_plugin = fetch(simple.SegmentationTransfer(SourceMesh=source, TargetMesh=target))
    by_package = marrow.transfer(
        marrow.creature("biped"), marrow.creature("biped", pose=0.5, seed=7))
    expect_equal(by_package.segments.tolist(), values(by_plugin.GetCellData().GetArray("SegmentId")),
                 "segments by the package")
    plugin.finish()


main()
