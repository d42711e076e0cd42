#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the wheel of pyproject.toml with the VTK of this machine, and installs, uses and removes it in a
virtual environment. By hand:

    .ci/install-packages.sh python3-venv python3-wheel
    Testing/Packages/check_wheel.py

A stand-in for scikit-build-core, which Debian 12 does not have: it does with pyproject.toml what that would
do. VTK's wheel and its SDK are not to be had there either, so Debian's VTK takes their place, and what
pyproject.toml says of them is not tested."""
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build-wheel"
USE = """
import importlib.metadata, marrow
biped = marrow.creature("biped")
assert marrow.evaluate(marrow.transfer(biped, marrow.creature("biped", seed=3)), biped.segments)
assert "site-packages" in marrow.__file__, marrow.__file__
entry, = importlib.metadata.entry_points(group="pyvista.accessors", name="marrow")
assert entry.value == "marrow._pyvista"
ours = {line.split()[-1] for line in open("/proc/self/maps") if "Marrow" in line}
assert len(ours) > 10 and all("site-packages/marrow/" in path for path in ours), ours
"""


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def build_wheel(settings):
    tool, project = settings["tool"]["scikit-build"], settings["project"]
    version_of = tool["metadata"]["version"]
    version = re.search(version_of["regex"], (SOURCE / version_of["input"]).read_text())["value"]
    run("cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", "-DSKBUILD=2", "-DCMAKE_BUILD_TYPE=Release",
        f"-DPython3_EXECUTABLE={sys.executable}",
        *[f"-D{name}={value}" for name, value in tool["cmake"]["define"].items()])
    run("cmake", "--build", BUILD)

    staging = BUILD / "staging"
    shutil.rmtree(staging, ignore_errors=True)
    for component in tool["install"]["components"]:
        run("cmake", "--install", BUILD, "--component", component, "--prefix", staging)
    links = [path for path in staging.rglob("*") if path.is_symlink()]
    assert not links, f"a wheel cannot have links: {links}"

    metadata = staging / f"{project['name'].replace('-', '_')}-{version}.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {version}\n"
        f"Summary: {project['description']}\nRequires-Python: {project['requires-python']}\n"
        + "".join(f"Requires-Dist: {name}\n" for name in project["dependencies"]))
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    platform = re.sub(r"\W", "_", sysconfig.get_platform())
    (metadata / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: check_wheel.py\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-{platform}\n")
    (metadata / "entry_points.txt").write_text("\n".join(
        line for group, entries in project["entry-points"].items()
        for line in (f"[{group}]", *[f"{name} = {value}" for name, value in entries.items()])))
    run(sys.executable, "-m", "wheel", "pack", staging, "--dest-dir", BUILD)
    return next(BUILD.glob(f"*-{version}-*.whl"))


def main():
    with open(SOURCE / "pyproject.toml", "rb") as file:
        settings = tomllib.load(file)
    wheel = build_wheel(settings)
    environment = BUILD / "environment"
    shutil.rmtree(environment, ignore_errors=True)
    run(sys.executable, "-m", "venv", "--system-site-packages", environment)
    python = environment / "bin/python"
    # Debian's VTK is not a package that pip knows, hence no dependencies.
    run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
    run(python, "-c", USE)
    run(python, "-m", "pip", "uninstall", "--yes", settings["project"]["name"])
    left = list(environment.rglob("*arrow*"))
    assert not left, f"the wheel left behind: {left}"
    print(f"{wheel.name} can be installed, used and removed.")


main()
