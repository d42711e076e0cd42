# SPDX-License-Identifier: BSD-3-Clause
"""The state file of the examples opens, and shows what it was made of."""
import os

from paraview import simple

import plugin
from plugin import expect, expect_between, expect_equal, fetch, share_of_equal

simple.LoadState(os.path.join(plugin.SOURCE, "Examples", "ParaView", "transfer.pvsm"))
target = simple.FindSource("Target")
labelled = simple.FindSource("Labelled Target")
expect(target is not None and labelled is not None, "the state has not its two meshes")
expect_equal((target.Pose, target.Proportion, target.Seed), (0.5, 0.5, 7), "the target's parameters")
share = share_of_equal(fetch(labelled).GetCellData().GetArray("SegmentId"),
                       fetch(target).GetCellData().GetArray("SegmentId"))
expect_between(share, 0.93, 1.0, "share of right labels")
view = simple.GetActiveViewOrCreate("RenderView")
view.ViewSize = [500, 300]
view.OrientationAxesVisibility = 0
plugin.expect_picture(view, "ParaViewState")
plugin.finish()
