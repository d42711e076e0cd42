# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share: loads it, checks numbers and pictures."""
import os
import sys

import built_package  # noqa: F401
from paraview import servermanager, simple
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = os.environ["MARROW_SOURCE"]
OUTPUT = os.environ["MARROW_TEST_OUTPUT"]
XML_FOLDER = os.path.join(SOURCE, "Wrapping", "ParaView", "Marrow")

simple.LoadPlugin(os.environ["MARROW_PLUGIN"], remote=False, ns=vars(simple))
simple._DisableFirstRenderCameraReset()


class Failures:
    """Counts what does not hold, so that one run tells all of it."""

    def __init__(self):
        self.count = 0

    def expect(self, holds, message):
        if not holds:
            self.count += 1
            print("FAILED: " + message, file=sys.stderr, flush=True)

    def expect_equal(self, value, expected, what):
        self.expect(value == expected, f"{what} is {value!r}, expected {expected!r}")

    def expect_between(self, value, least, most, what):
        self.expect(least <= value <= most, f"{what} is {value}, expected {least} to {most}")


_failures = Failures()
expect = _failures.expect
expect_equal = _failures.expect_equal
expect_between = _failures.expect_between


def finish():
    """Ends the test."""
    # Views that are left over are taken down too late and may report a lost context.
    for view in simple.GetRenderViews():
        simple.Delete(view)
    sys.stdout.flush()
    # Ending in the ordinary way lets pvbatch tell its other processes.
    if _failures.count:
        sys.exit(1)


def fetch(proxy, port=0):
    """The data of an output, brought up to date."""
    simple.UpdatePipeline(proxy=proxy)
    return servermanager.Fetch(proxy, idx=port)


def values(data):
    """The array's values as a list of numbers, or of tuples."""
    size = data.GetNumberOfComponents()
    rows = [data.GetTuple(i) for i in range(data.GetNumberOfTuples())]
    return [row[0] for row in rows] if size == 1 else rows


def share_of_equal(one, other):
    """Share of the places at which two arrays have the same value."""
    a, b = values(one), values(other)
    return sum(x == y for x, y in zip(a, b)) / max(len(a), len(b))


def new_view(width=400, height=300):
    """A view whose picture is the same everywhere: no text in it, no settings of anybody's."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [width, height]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    return view


def look_from(view, direction, up=(0.0, 1.0, 0.0)):
    """All of the scene as seen from there."""
    view.CameraPosition = list(direction)
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = list(up)
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.4)


def image_error(file_name, baseline):
    """How much two pictures differ: vtkImageDifference without its leniency."""
    readers = [vtkPNGReader(), vtkPNGReader()]
    for reader, name in zip(readers, (file_name, baseline)):
        reader.SetFileName(name)
        reader.Update()
    if readers[0].GetOutput().GetDimensions() != readers[1].GetOutput().GetDimensions():
        return float("inf")
    difference = vtkImageDifference()
    difference.SetInputConnection(readers[0].GetOutputPort())
    difference.SetImageConnection(readers[1].GetOutputPort())
    difference.SetThreshold(8)
    difference.AllowShiftOff()
    difference.AveragingOff()
    difference.Update()
    return difference.GetThresholdedError()


def expect_picture(view, name, threshold=50):
    """Compares the view with Testing/Data/Baseline/NAME.png, to the pixel."""
    drawn = os.path.join(OUTPUT, name + ".png")
    simple.SaveScreenshot(drawn, view, ImageResolution=view.ViewSize)
    expect_file(drawn, name, threshold)


def expect_file(drawn, name, threshold=50):
    """Compares a picture with Testing/Data/Baseline/NAME.png, to the pixel."""
    baseline = os.path.join(SOURCE, "Testing", "Data", "Baseline", name + ".png")
    error = image_error(drawn, baseline) if os.path.exists(baseline) else float("inf")
    expect(
        error <= threshold,
        f"the picture differs by {error} (allowed: {threshold}) from {baseline}; it is {drawn}."
        " If that one is right, copy it to the baselines.",
    )
