# SPDX-License-Identifier: BSD-3-Clause
"""Whatever names the project's version names that of CMake:
    check_versions.py SOURCE VERSION"""
import pathlib
import re
import sys

SOURCE, VERSION = pathlib.Path(sys.argv[1]), sys.argv[2]
# The first place in a file that names the version.
PLACES = {
    "CHANGELOG.md": r"^## ([\d.]+)",
    "CITATION.cff": r"^version: (\S+)",
    "Wrapping/Packages/conda/recipe.yaml": r'^  version: "(.+)"',
}

failures = []
for name, pattern in PLACES.items():
    found = re.search(pattern, (SOURCE / name).read_text(), re.M)
    if not found or found.group(1) != VERSION:
        failures.append(f"{name} has the version {found and found.group(1)}, CMake {VERSION}")
sys.exit("\n".join(failures) or 0)
