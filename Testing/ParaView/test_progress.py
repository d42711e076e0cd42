# SPDX-License-Identifier: BSD-3-Clause
"""Progress arrives at ParaView's bar, and an abort from there ends the filter early."""
import time

from paraview import servermanager, simple

import plugin
from plugin import expect

handler = servermanager.ActiveConnection.Session.GetProgressHandler()
# The bar would otherwise be told of every second only.
handler.SetProgressInterval(0.0)
shown = []
handler.AddObserver(
    "ProgressEvent", lambda *_: shown.append((handler.GetLastProgressText(), handler.GetLastProgress())))

mesh = simple.Creature(Resolution=20000)
target = simple.Creature(Resolution=20000, Pose=0.5, Seed=7)
skeletons = [simple.MSPSkeleton(Mesh=m) for m in (mesh, target)]


def name_of(proxy):
    return proxy.SMProxy.GetClientSideObject().GetClassName()


def run(proxy, upstream, stop_at=2.0):
    """Updates the proxy alone; returns its own progress, what the bar showed, the time, the data."""
    for producer in upstream:
        simple.UpdatePipeline(proxy=producer)
    algorithm = proxy.SMProxy.GetClientSideObject()
    own = []

    def note(caller, _):
        # 1 is also reported by the executive, at the end of whatever happened.
        if caller.GetProgress() < 1.0:
            own.append(caller.GetProgress())
        if caller.GetProgress() > stop_at:
            caller.SetAbortExecute(1)

    algorithm.AddObserver("ProgressEvent", note)
    shown.clear()
    start = time.monotonic()
    simple.UpdatePipeline(proxy=proxy)
    seconds = time.monotonic() - start
    return own, [p for text, p in shown if text == name_of(proxy)], seconds


for make, upstream, in_bar in (
        (lambda: simple.MSPField(Mesh=mesh), [mesh], True),
        (lambda: simple.MSPSkeleton(Mesh=mesh), [mesh], True),
        # Too fast for the bar, which is told of at most some ten percentages a second.
        (lambda: simple.SkeletonCorrespondence(
            SourceSkeleton=skeletons[0], TargetSkeleton=skeletons[1]), skeletons, False),
        (lambda: simple.SegmentationTransfer(SourceMesh=mesh, TargetMesh=target),
         [mesh, target], True)):
    whole = make()
    name = name_of(whole)
    own, percents, seconds = run(whole, upstream)
    print(f"{name}: {seconds:.2f} s, {len(own)} reports, {len(set(percents))} percentages in the bar")
    expect(len(own) >= 4, f"{name} reports {own}")
    expect(own == sorted(own), f"{name}: progress goes back: {own}")
    if in_bar:
        expect(len(set(percents)) >= 4, f"the bar shows {sorted(set(percents))} % of {name}")
    expect(whole.GetDataInformation().GetNumberOfCells() > 0, f"{name} has no result")

    # The user's wish to stop arrives as the algorithm's flag, set while it reports progress.
    aborted = make()
    own, _, seconds = run(aborted, upstream, 0.2)
    print(f"{name}, aborted: {seconds:.2f} s, last report {max(own):.2f}")
    expect(max(own) < 0.7, f"{name} goes on to {max(own)} after an abort")
    expect(aborted.GetDataInformation().GetNumberOfCells() == 0, f"{name} has half a result")
plugin.finish()
