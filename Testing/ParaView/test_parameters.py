# SPDX-License-Identifier: BSD-3-Clause
"""The panels say what the C++ classes say: every parameter is there, with its default, range and
enumeration; no panel shows more than five at first, and everything is explained."""
import glob
import importlib
import os
import xml.etree.ElementTree as ElementTree

from paraview import servermanager

import plugin
from plugin import expect, expect_equal

MODULES = ("Collection", "Correspondence", "Creatures", "Evaluation", "IO", "Measures", "Rendering", "Skeleton", "Surface",
           "Transfer")
MOST_AT_FIRST = 5
# Not for a user of a panel: what a reader of a file or a window needs.
HIDDEN = {"FileName"}
HUGE = 1000000000


def classes():
    found = {}
    for module in MODULES:
        wrapped = importlib.import_module("marrow.vtk.Marrow" + module)
        found.update({n: c for n, c in vars(wrapped).items() if n.startswith("vtk")})
    return found


def settable(cls):
    """Names of the parameters that a class itself adds to its superclass."""
    names = [n[3:] for n in vars(cls) if n.startswith("Set") and "Get" + n[3:] in vars(cls)]
    return {n for n in names if n not in ("ClassName", "ClassNameInternal", "Controller")}


def value_of(algorithm, parameter):
    """A text that is not set is an empty one in a panel."""
    value = getattr(algorithm, "Get" + parameter)()
    return "" if value is None else value


def number(text):
    return float(text) if any(c in text for c in ".eE") else int(text)


def check_enumeration(where, cls, parameter, entries, algorithm):
    for entry in entries:
        constant = entry.get("text").upper().replace(" ", "_")
        expect_equal(
            getattr(cls, constant, None), int(entry.get("value")), f"{where}: {cls.__name__}::{constant}"
        )
    texts = [int(entry.get("value")) for entry in entries]
    for bound, expected in ((-HUGE, min(texts)), (HUGE, max(texts))):
        getattr(algorithm, "Set" + parameter)(bound)
        expect_equal(getattr(algorithm, "Get" + parameter)(), expected, f"{where}: utmost value")
    expect_equal(len(texts), max(texts) - min(texts) + 1, f"{where}: number of entries")


def check_range(where, parameter, domain, algorithm):
    for attribute, beyond in (("min", -HUGE), ("max", HUGE)):
        getattr(algorithm, "Set" + parameter)(beyond)
        clamped = getattr(algorithm, "Get" + parameter)()
        if domain.get(attribute) is None:
            expect_equal(clamped, beyond, f"{where}: {attribute}, which the panel does not have,")
        else:
            expect_equal(number(domain.get(attribute)), clamped, f"{where}: {attribute} of the panel")


def check_property(where, cls, element, parameter, proxy_algorithm):
    expect(element.findtext("Documentation", "").strip(), f"{where} has no documentation")
    default = value_of(cls(), parameter)
    if parameter not in HIDDEN:
        text = element.get("default_values")
        shown = text if isinstance(default, str) else number(text)
        expect_equal(shown, default, f"{where}: default of the panel")
    expect_equal(value_of(proxy_algorithm, parameter), default, f"{where}: value of a new proxy")
    algorithm = cls()
    entries = element.findall("EnumerationDomain/Entry")
    if entries:
        check_enumeration(where, cls, parameter, entries, algorithm)
    for domain in element.findall("IntRangeDomain") + element.findall("DoubleRangeDomain"):
        check_range(where, parameter, domain, algorithm)
    if isinstance(default, bool):
        expect(element.find("BooleanDomain") is not None, f"{where} is no check box")
    elif isinstance(default, (int, float)) and not entries:
        expect(element.find("*[@name='range']") is not None, f"{where} has no range")


def check_ports(where, cls, element):
    algorithm = cls()
    inputs = element.findall("InputProperty")
    ports = sorted(int(i.get("port_index", "0")) for i in inputs)
    expect_equal(ports, list(range(algorithm.GetNumberOfInputPorts())), f"{where}: input ports")
    for i in inputs:
        expect(i.findtext("Documentation", "").strip(), f"{where}: an input has no documentation")
        if i.find("Hints/Optional") is not None:
            name = i.get("name")
            expect_equal(i.get("panel_widget"), "input_selector", f"{where}.{name}: widget")
            expect(hasattr(cls, i.get("clean_command", "")), f"{where}.{name} cannot be taken away")
    outputs = element.findall("OutputPort")
    if algorithm.GetNumberOfOutputPorts() > 1:
        indices = [int(o.get("index")) for o in outputs]
        expected = list(range(algorithm.GetNumberOfOutputPorts()))
        expect_equal(indices, expected, f"{where}: named outputs")


def check_proxy(group, element, cls):
    where = element.get("name")
    documentation = element.find("Documentation")
    for key in ("short_help", "long_help"):
        expect(documentation is not None and documentation.get(key), f"{where} has no {key}")
    hints = element.find("Hints")
    menu = hints.find("ShowInMenu")
    if menu is None:
        expect(
            any(hints.find(h) is not None for h in ("ReaderFactory", "WriterFactory")),
            f"{where} is in no menu and opens no file",
        )
    else:
        expect_equal(menu.get("category"), "Marrow", f"{where}: category")
        expect(menu.get("icon"), f"{where} has no icon")
    check_ports(where, cls, element)

    proxy = servermanager.ProxyManager().NewProxy(group, where)
    expect_equal(proxy.GetXMLLabel(), element.get("label"), f"{where}: label")
    proxy.UpdateVTKObjects()
    # A writer's proxy has ParaView's own helper as its client-side object.
    algorithm = cls() if group == "writers" else proxy.GetClientSideObject()
    expect_equal(algorithm.GetClassName(), cls.__name__, f"{where}: class")

    properties = {}
    # Inputs are in a dialog, and in the panel if they can be taken away again.
    shown = sum(
        i.get("panel_widget") is not None and i.get("panel_visibility", "default") == "default"
        for i in element.findall("InputProperty"))
    for p in element:
        if not p.tag.endswith("VectorProperty"):
            continue
        shown += p.get("panel_visibility", "default") == "default"
        if p.get("command") == "SetInputArrayToProcess":
            expect(p.find("ArrayListDomain") is not None, f"{where}: an array without a choice")
            expect(p.findtext("Documentation", "").strip(), f"{where}: an array without words")
        elif p.get("repeat_command"):
            for command in (p.get("command"), p.get("clean_command")):
                expect(hasattr(cls, command), f"{where}: {cls.__name__} has no {command}")
            expect(p.findtext("Documentation", "").strip(), f"{where}: a list without words")
        else:
            properties[p.get("command")[len("Set"):]] = p
    expect(shown <= MOST_AT_FIRST, f"{where} shows {shown} properties at first")
    expect_equal(set(properties), settable(cls), f"{where}: parameters")
    for parameter, p in properties.items():
        if parameter in settable(cls):
            check_property(f"{where}.{p.get('name')}", cls, p, parameter, algorithm)
    return where


def main():
    known = classes()
    seen = []
    for file_name in sorted(glob.glob(os.path.join(plugin.XML_FOLDER, "*.xml"))):
        for group in ElementTree.parse(file_name).getroot().findall("ProxyGroup"):
            for element in group:
                seen.append(check_proxy(group.get("name"), element, known[element.get("class")]))
    expect_equal(len(seen), 16, "number of proxies")
    print("Checked: " + ", ".join(seen))
    plugin.finish()


main()
