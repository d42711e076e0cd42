# SPDX-License-Identifier: BSD-3-Clause
"""Makes transfer.pvsm, the state file beside this script:
    pvpython Examples/ParaView/make_state.py
Two creatures, the second one labelled by way of the first one's segments."""
import os
import sys
import xml.etree.ElementTree as ElementTree

from paraview import simple


def make_scene():
    source = simple.Creature(registrationName="Source")
    target = simple.Creature(registrationName="Target", Pose=0.5, Proportion=0.5, Seed=7)
    transfer = simple.SegmentationTransfer(
        registrationName="Labelled Target", SourceMesh=source, TargetMesh=target)
    view = simple.CreateView("RenderView")
    view.ViewSize = [900, 500]
    layout = simple.CreateLayout("Transfer")
    simple.AssignViewToLayout(view=view, layout=layout, hint=0)
    # Beside each other: the mesh stays where it is, its picture is moved.
    for mesh, place in ((source, [0.0, 0.0, 0.0]), (transfer, [0.0, 0.0, 2.0])):
        simple.Show(mesh, view).Position = place
    view.CameraPosition = [0.4, 0.4, 1.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    simple.ResetCamera(view)
    simple.Render(view)


def without_needless(file_name):
    """The state without what ParaView knows by itself: the possible values of properties."""
    tree = ElementTree.parse(file_name)
    for proxy in tree.getroot().iter("Proxy"):
        for prop in proxy.findall("Property"):
            for domain in prop.findall("Domain"):
                prop.remove(domain)
            if len(prop) == 0:
                proxy.remove(prop)
    ElementTree.indent(tree, " ")
    tree.write(file_name)


if not hasattr(simple, "SegmentationTransfer"):
    sys.exit("Load the plugin: set PV_PLUGIN_PATH to the folder that holds Marrow.so.")
make_scene()
state = os.path.join(os.path.dirname(os.path.abspath(__file__)), "transfer.pvsm")
simple.SaveState(state)
without_needless(state)
