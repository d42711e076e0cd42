#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/parameters.md has every parameter of every public class, with the name, the default
and the range that the header has.

    check_parameters.py PROJECT_FOLDER
"""
import math
import os
import re
import sys

from pages import finish, read

PAGE = "Documentation/parameters.md"


def read_tables(root):
    """class: {parameter: (default, range)} as written in the page."""
    tables = {}
    classes = []
    for line in read(root, PAGE).splitlines():
        if line.startswith("## "):
            classes = re.findall(r"vtk\w+", line)
            for name in classes:
                tables[name] = {}
        row = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(row) == 5 and row[0].startswith("`"):
            for name in classes:
                tables[name][row[0].strip("`")] = (row[1], row[2])
    return tables


def public_headers(root):
    for base in ("Filters", "Rendering"):
        for folder, folders, files in os.walk(os.path.join(root, base)):
            folders[:] = sorted(f for f in folders if f != "Private")
            for name in sorted(files):
                if re.fullmatch(r"vtk\w+\.h", name):
                    yield os.path.relpath(os.path.join(folder, name), root)


def comments_of(text):
    """parameter: what the comment of its group says."""
    comments = {}
    for comment, macros in re.findall(r"///@\{\s*/\*\*(.*?)\*/(.*?)///@\}", text, re.S):
        for name in re.findall(r"vtkSet\w*Macro\((\w+)", macros):
            comments[name] = " ".join(line.strip(" *") for line in comment.splitlines())
    return comments


def says(comment, default, values):
    """Whether a comment has the default after that word, and both ends of the range."""
    def has(words, value):
        return any(same(word.strip("[].,;:()\""), value) for word in words.split())

    _, word, after = comment.partition("Default")
    if word and default is not None and not all(has(after, v.strip()) for v in default.split(",")):
        return False
    ends = [v for v in values or [] if v not in ("VTK_INT_MAX", "off", "on")]
    return not re.search("[Rr]ange", comment) or all(has(comment, end) for end in ends)


def read_header(root, path):
    """parameter: (default, range) as a table should have them; None: not to be known here."""
    text = read(root, path)
    enumerators = []
    for body in re.findall(r"\benum\s+\w*\s*\{(.*?)\}", text, re.S):
        enumerators.append(re.findall(r"^\s*([A-Z_]\w*)", body, re.M))

    parameters = {}
    for kind, arguments in re.findall(r"^\s*vtkSet(\w*)Macro\(([^;]*)\);", text, re.M):
        name, *rest = [word.strip() for word in arguments.split(",")]
        member = re.search(rf"^\s*[\w:\*]+ \*?{name}(?:\[\d\])?\s*=\s*(.*?);", text, re.M)
        default = member.group(1).strip("{} ") if member else None
        values = None
        if kind == "Clamp":
            values = rest[1:]
            for names in enumerators:
                if values[0] in names:
                    values = names[names.index(values[0]):names.index(values[1]) + 1]
                    # The default may be written as a number or as one of the names.
                    if default is not None and default.isdigit():
                        default = values[int(default)]
                    break
        elif rest and rest[0] == "bool":
            default = {"true": "on", "false": "off", None: None}[default]
            values = ["off", "on"]
        elif default == "nullptr":
            default = None
        parameters[name] = (default, values)
    # Setters written out; without argument they choose one value, with several they are no parameters.
    for name in re.findall(r"^ *(?:virtual )?void Set([A-Z]\w*)\([^),]+\)", text, re.M):
        parameters.setdefault(name, (None, None))
    return parameters


def number(text):
    text = text.replace("−", "-").replace("VTK_INT_MAX", "inf").replace("VTK_DOUBLE_MAX", "inf")
    return math.pi if text in ("π", "vtkMath::Pi()") else float(text)


def same(written, expected):
    if written == expected:
        return True
    try:
        return math.isclose(number(written), number(expected), rel_tol=1e-9)
    except ValueError:
        return False


def split_range(written):
    if written.endswith(" and up"):
        return [written[:-len(" and up")], "inf"]
    return [value.strip("` ") for value in re.split(r",| to ", written)]


def main(root):
    tables = read_tables(root)
    errors = []
    count = 0
    classes = set()
    for path in public_headers(root):
        name = os.path.basename(path)[:-2]
        classes.add(name)
        parameters = read_header(root, path)
        for parameter, comment in comments_of(read(root, path)).items():
            default, values = parameters[parameter]
            if not says(comment, default, values):
                errors.append(f"{path}: the comment of {parameter} has another default or range than "
                              f"the code: {default}, {' to '.join(values or [])}.")
        table = tables.get(name, {})
        for parameter in sorted(set(parameters) - set(table)):
            errors.append(f"{PAGE}: {name} has no row for {parameter}, which {path} has.")
        for parameter in sorted(set(table) - set(parameters)):
            errors.append(f"{PAGE}: {path} has no parameter {parameter}.")
        for parameter in sorted(set(table) & set(parameters)):
            count += 1
            written_default, written_range = table[parameter]
            default, values = parameters[parameter]
            given = [word.strip("` ") for word in written_default.split(",")]
            if default is not None:
                expected = [word.strip() for word in default.split(",")]
                if len(given) != len(expected) or not all(map(same, given, expected)):
                    errors.append(f"{PAGE}: the default of {name}'s {parameter} is "
                                  f"{default}, not {written_default}.")
            if values is not None:
                given = split_range(written_range)
                if len(given) != len(values) or not all(map(same, given, values)):
                    errors.append(f"{PAGE}: the range of {name}'s {parameter} is "
                                  f"{', '.join(values)}, not {written_range}.")
    for name in sorted(set(tables) - classes):
        errors.append(f"{PAGE}: there is no public class {name}.")
    if count == 0:
        errors.append(f"{PAGE}: no tables were found.")
    finish(errors, f"{count} parameters of {len(tables)} classes")


if __name__ == "__main__":
    main(sys.argv[1])
