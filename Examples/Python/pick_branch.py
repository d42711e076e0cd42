#!/usr/bin/python3
"""Click on a branch of one skeleton, and see the branch that it is matched with on the other.

    pick_branch.py SOURCE TARGET                  a window: click, turn, press q to end
    pick_branch.py SOURCE TARGET PICTURE.png      clicks on the longest branch by itself
"""
import sys

from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCellPicker, vtkPolyDataMapper, vtkRenderWindow, vtkRenderWindowInteractor,
    vtkWindowToImageFilter)

import marrow
from marrow.vtk import vtkMarrowSideBySideScene, vtkMarrowSkeletonGlyphs

BLACK = (0.05, 0.05, 0.05)


class BranchPicker:
    """The scene of two matched skeletons, in which a click selects a branch on both."""

    def __init__(self, pair):
        self.pair, self.sides = pair, (pair.source, pair.target)
        self.scene, self.window = vtkMarrowSideBySideScene(), vtkRenderWindow()
        self.scene.SetSurfaceOpacity(0.2)
        self.scene.SetColorSkeletonBy(vtkMarrowSkeletonGlyphs.CORRESPONDENCE)
        self.selected = [vtkPolyData(), vtkPolyData()]
        for side, lines in zip(self.sides, self.selected):
            self.scene.AddActor(self.scene.AddMesh(side.mesh.polydata, side.polydata),
                                self.tube(lines, side.mesh.polydata.GetLength() / 100))
        self.scene.AddTo(self.window)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        self.interactor.AddObserver("LeftButtonPressEvent", self.click)

    def tube(self, lines, radius):
        tubes, mapper, actor = vtkTubeFilter(), vtkPolyDataMapper(), vtkActor()
        tubes.SetInputData(lines)
        tubes.SetRadius(radius)
        tubes.SetNumberOfSides(12)
        mapper.SetInputConnection(tubes.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(BLACK)
        actor.PickableOff()
        return actor

    def click(self, *_):
        x, y = self.interactor.GetEventPosition()
        renderer = self.interactor.FindPokedRenderer(x, y)
        picker = vtkCellPicker()
        picker.SetTolerance(0.02)
        picker.PickFromListOn()  # the skeletons, not the surfaces in front of them
        for actor in renderer.GetActors():
            if actor.GetMapper().IsA("vtkMarrowSkeletonMapper"):
                picker.AddPickList(actor)
        if picker.Pick(x, y, 0, renderer):
            side = 0 if renderer is self.scene.GetRenderer(0) else 1
            self.select(side, picker.GetCellId())

    def select(self, side, branch):
        found = [[], []]
        found[side] = [branch]  # alone, if it is not matched
        for match in self.pair.branches:
            if branch in (match.source, match.target)[side]:
                found = [match.source, match.target]
        for skeleton, lines, branches in zip(self.sides, self.selected, found):
            cells = vtkCellArray()
            for number in branches:
                nodes = skeleton.branches[number]
                cells.InsertNextCell(len(nodes), nodes.tolist())
            lines.SetPoints(skeleton.polydata.GetPoints())
            lines.SetLines(cells)
        ours, theirs = (list(map(int, branches)) for branches in found)
        print(f"branches {ours} of the source, {theirs} of the target")
        self.window.Render()

    def click_on(self, branch):
        """What a user's click on a branch of the source does."""
        nodes, renderer = self.pair.source.branches[branch], self.scene.GetRenderer(0)
        renderer.SetWorldPoint(*self.pair.source.nodes[nodes[len(nodes) // 2]], 1.0)
        renderer.WorldToDisplay()
        x, y, _ = renderer.GetDisplayPoint()
        self.interactor.SetEventInformation(round(x), round(y))
        self.interactor.InvokeEvent("LeftButtonPressEvent")
        self.interactor.InvokeEvent("LeftButtonReleaseEvent")


def main(source, target, picture=None):
    picker = BranchPicker(marrow.correspond(marrow.read(source), marrow.read(target)))
    if picture is None:
        picker.window.Render()
        picker.interactor.Start()
        return
    picker.window.OffScreenRenderingOn()
    picker.window.Render()
    picker.click_on(int(picker.pair.source.branch_length.argmax()))
    capture, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    capture.SetInput(picker.window)
    capture.ReadFrontBufferOff()
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])
