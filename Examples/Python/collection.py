#!/usr/bin/python3
"""The segments of one mesh on a whole collection: a .seg file for each, and one picture of all.

    collection.py SOURCE SEGMENTS.seg FOLDER TARGET...
"""
import pathlib
import sys
import warnings

import marrow

source = marrow.read(sys.argv[1], segments=sys.argv[2])
folder, targets = pathlib.Path(sys.argv[3]), [pathlib.Path(name) for name in sys.argv[4:]]
folder.mkdir(parents=True, exist_ok=True)

skeleton = marrow.skeleton(source)  # once for all
labelled, names = [source], ["source"]
for path in targets:
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        try:
            result = marrow.transfer(skeleton, marrow.read(path))
        except marrow.Error as error:  # one mesh that is no good must not stop the others
            print(f"{path.stem}: {error}")
            continue
    marrow.write(result, folder / f"{path.stem}.seg")
    labelled.append(result)
    names.append(path.stem)
    print(f"{path.stem}: confidence {result.confidence.mean():.2f}")
    for warning in told:
        print(f"  {warning.message}")

marrow.render(*labelled, captions=names, columns=3, path=folder / "collection.png")
