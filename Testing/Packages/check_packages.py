# SPDX-License-Identifier: BSD-3-Clause
"""The packages that cpack makes hold what they should and nothing else, and depend on what they use:
    check_packages.py CPACK BUILD SOURCE LIBDIR VERSION OUTPUT"""
import pathlib
import re
import shutil
import subprocess
import sys

CPACK, BUILD, SOURCE, LIBDIR, VERSION, OUTPUT = sys.argv[1:]
SOURCE = pathlib.Path(SOURCE)
LIBRARIES = f"usr/{LIBDIR}"
PYTHON = "usr/lib/python3/dist-packages/marrow"
SONAME = ".".join(VERSION.split(".")[:2])
FAILURES = []


def expect(holds, message):
    if not holds:
        FAILURES.append(message)


def modules():
    """Names of the modules, without that of CGAL, which not every build has."""
    found = [re.search(r"LIBRARY_NAME\s+(\w+)", file.read_text()).group(1)
             for file in [*SOURCE.glob("Filters/*/vtk.module"), SOURCE / "Rendering/vtk.module"]]
    return sorted(set(found) - {"MarrowSkeletonCGAL"})


def expected():
    """Name of a package: the files that it must have."""
    headers = [file.name for folder in ("Filters/*", "Rendering") for file in SOURCE.glob(f"{folder}/vtk*.h")
               if "CGAL" not in str(file)]
    python = SOURCE / "Wrapping/Python/marrow"
    return {
        "marrow": ["usr/bin/marrow"],
        "libmarrow": [f"{LIBRARIES}/lib{module}.so.{version}" for module in modules()
                      for version in (SONAME, VERSION)],
        "libmarrow-dev": [
            *[f"{LIBRARIES}/lib{module}.so" for module in modules()],
            *[f"{LIBRARIES}/vtk/hierarchy/Marrow/{module}-hierarchy.txt" for module in modules()],
            *[f"usr/include/marrow/{header}" for header in headers],
            *[f"usr/include/marrow/{module}Module.h" for module in modules()],
            *[f"{LIBRARIES}/cmake/Marrow/{file}.cmake" for file in (
                "MarrowConfig", "MarrowConfigVersion", "Marrow-targets", "Marrow-targets-release",
                "Marrow-vtk-module-find-packages", "Marrow-vtk-module-properties")]],
        "python3-marrow": [
            *[f"{PYTHON}/{file.relative_to(python)}" for file in python.rglob("*.py")],
            f"{PYTHON}/py.typed", f"{PYTHON}/_version.py",
            *[f"usr/lib/python3/dist-packages/marrow_vtk-{VERSION}.dist-info/{file}"
              for file in ("METADATA", "entry_points.txt")],
            *[f"{PYTHON}/vtk/{module}.so" for module in modules()]],
    }


def dpkg_deb(*arguments):
    return subprocess.run(["dpkg-deb", *map(str, arguments)], capture_output=True, text=True,
                          check=True).stdout


def check(name, files):
    package = next(pathlib.Path(OUTPUT).glob(f"{name}_{VERSION}_*.deb"), None)
    if package is None:
        FAILURES.append(f"there is no package {name}")
        return
    listed = [line.split(maxsplit=5)[5].split(" -> ")[0] for line in dpkg_deb("-c", package).splitlines()]
    held = {file.removeprefix("./") for file in listed if not file.endswith("/")}
    wanted = {*files, f"usr/share/doc/{name}/copyright"}
    for file in sorted(wanted - held):
        FAILURES.append(f"{name} lacks {file}")
    for file in sorted(held - wanted):
        expect(re.search("CGAL|MeanCurvature", file), f"{name} should not have {file}")

    depends = dpkg_deb("-f", package, "Depends")
    if name != "libmarrow":
        expect(f"libmarrow (= {VERSION})" in depends, f"{name} depends on {depends}")
    expect("vtk9" in depends, f"{name} does not depend on VTK: {depends}")


def main():
    shutil.rmtree(OUTPUT, ignore_errors=True)
    subprocess.run([CPACK, "--config", f"{BUILD}/CPackConfig.cmake", "-B", OUTPUT], check=True,
                   stdout=subprocess.DEVNULL, cwd=BUILD)
    packages = expected()
    made = {file.name.split("_")[0] for file in pathlib.Path(OUTPUT).glob("*.deb")}
    expect(made == set(packages), f"the packages are {sorted(made)}, not {sorted(packages)}")
    for name, files in packages.items():
        check(name, files)
    sys.exit("\n".join(FAILURES) or 0)


main()
