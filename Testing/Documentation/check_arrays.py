#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/data-contract.md has every array that the code names.

    check_arrays.py PROJECT_FOLDER
"""
import re
import sys

from pages import finish, read

PAGE = "Documentation/data-contract.md"
NAMES = "Filters/Core/Private/ArrayNames.h"


def main(root):
    written = set(re.findall(r"`(\w+)`", read(root, PAGE)))
    names = re.findall(r'const char\* \w+ = "(\w+)"', read(root, NAMES))
    finish([f"{PAGE}: the array {name} of {NAMES} is missing." for name in names
            if name not in written], f"{len(names)} arrays")


if __name__ == "__main__":
    main(sys.argv[1])
