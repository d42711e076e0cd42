#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what measure_collection.py measured (python3-matplotlib).

    plot_collection.py RESULT.csv -o FOLDER

FOLDER/means.png has the label accuracy against the number of labelled meshes, with unlabelled company and without,
over the categories with limbs and over all that were measured, beside published figures of a method that learns;
and how many of the wrong faces are among the tenth that is least sure. FOLDER/categories.png has the accuracy for each
category.
"""
import argparse
import csv
import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

WITH_LIMBS = ["Human", "Glasses", "Airplane", "Ant", "Octopus", "Teddy", "Hand", "Plier", "Bird", "Armadillo",
              "FourLeg"]
NUMBER_OF_ALL = 19
# Label accuracy of Kalogerakis, Hertzmann and Singh 2010 by the number of meshes it learned from. Remembered, not
# looked up again; the categories are the same, the meshes that were labelled are others.
PUBLISHED = {
    "with limbs": {6: 0.910, 12: 0.937, 19: 0.948},
    "all": {6: 0.894, 12: 0.920, 19: 0.938},
}
COMPANY = {True: ("o-", "with unlabelled company"), False: ("s--", "each by itself")}


def read(path):
    """{(company, sources): {category: (accuracy, share of the wrong faces found)}}"""
    table = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = row["company"] == "1", int(row["sources"])
            table.setdefault(key, {})[row["category"]] = (
                float(row["accuracy"]), float(row["wrong_in_least_sure_tenth"]))
    return table


def series(table, company, categories, column):
    """Numbers of labelled meshes and means; of those numbers only at which all the categories were measured."""
    points = {}
    for (of_company, sources), rows in table.items():
        if of_company == company and set(categories) <= set(rows):
            points[sources] = sum(rows[name][column] for name in categories) / len(categories)
    return sorted(points), [points[sources] for sources in sorted(points)]


def draw(axes, table, categories, column):
    for company, (style, label) in COMPANY.items():
        axes.plot(*series(table, company, categories, column), style, label=label, markersize=4)
    axes.grid(alpha=0.3)
    axes.set_xlim(0.5, 7.5)


def draw_means(table, path):
    categories = {name for rows in table.values() for name in rows}
    with_limbs = [name for name in WITH_LIMBS if name in categories]
    panels = [(f"{len(with_limbs)} categories with limbs", with_limbs, "with limbs", len(WITH_LIMBS)),
              (f"{len(categories)} categories", sorted(categories), "all", NUMBER_OF_ALL)]
    figure, all_axes = pyplot.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    for axes, (title, names, published, number) in zip(all_axes, panels):
        if not names:
            continue
        draw(axes, table, names, 0)
        # Means over other categories say nothing beside it.
        for learned_from, accuracy in PUBLISHED[published].items() if len(names) == number else ():
            axes.axhline(accuracy, color="0.5", linestyle=":", linewidth=1)
            axes.annotate(f"learned from {learned_from} meshes (2010, remembered)", (7.4, accuracy), ha="right",
                          va="bottom", fontsize=7, color="0.35")
        axes.set(title=title, xlabel="labelled meshes of eight", ylabel="label accuracy of the others")
        axes.legend(frameon=False, fontsize=8)
    if with_limbs:
        draw(all_axes[2], table, with_limbs, 1)
    all_axes[2].axhline(0.1, color="0.5", linestyle=":", linewidth=1)
    all_axes[2].annotate("by chance", (7.4, 0.1), ha="right", va="bottom", fontsize=7, color="0.35")
    all_axes[2].set(title="errors that the confidence finds, with limbs", xlabel="labelled meshes of eight",
                    ylabel="wrong faces in the least sure tenth", ylim=(0, 1))
    figure.savefig(path, dpi=120)


def draw_categories(table, path):
    categories = sorted({name for rows in table.values() for name in rows})
    columns = 5
    rows = -(-len(categories) // columns)
    figure, all_axes = pyplot.subplots(rows, columns, figsize=(13, 2.4 * rows), squeeze=False, sharex=True,
                                       constrained_layout=True)
    for axes, name in zip(all_axes.flat, categories):
        draw(axes, table, [name], 0)
        axes.set_title(name, fontsize=9)
    for axes in list(all_axes.flat)[len(categories):]:
        axes.axis("off")
    all_axes[0][0].legend(frameon=False, fontsize=7)
    figure.supxlabel("labelled meshes of eight")
    figure.supylabel("label accuracy of the others")
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("result")
    parser.add_argument("-o", "--output", required=True)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    table = read(options.result)
    draw_means(table, os.path.join(options.output, "means.png"))
    draw_categories(table, os.path.join(options.output, "categories.png"))


if __name__ == "__main__":
    main()
