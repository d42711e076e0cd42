#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes report.html of a result folder of marrow-benchmark-segmentation: tables, plots, and pictures of the
worst pairs, in one file.

    .ci/install-packages.sh python3-matplotlib
    Testing/Benchmarks/Segmentation/report.py DATA_FOLDER RESULT_FOLDER

The pictures are drawn by the Python package marrow, which must be on the PYTHONPATH, and need a display;
without one, the report has none."""
import base64
import csv
import html
import io
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("agg")
import numpy as np  # noqa: E402
from matplotlib import pyplot  # noqa: E402

FIGURES = pathlib.Path(__file__).with_name("figures.json")
WORST_OF_EACH = 2  # pairs of a category that are drawn
TABLES = {
    "Segments": {
        "label accuracy": "label_accuracy", "median": "label_accuracy_median", "worst": "label_accuracy_worst",
        "possible": "label_accuracy_possible", "rigid": "rigid_label_accuracy",
        "Rand error": "rand_error", "median ": "rand_error_median", "worst ": "rand_error_worst", "rigid ": "rigid_rand_error", "humans": "humans_rand_error",
        "Hamming": "hamming_distance", "GCE": "gce", "LCE": "lce", "cut discr.": "cut_discrepancy"},
    "Skeletons": {
        "nodes inside": "inside_share", "wrong loops": "wrong_loops", "terminals: recall": "terminal_recall",
        "precision": "terminal_precision", "spurs per mesh": "spurs_per_mesh", "field, s": "seconds_field",
        "skeleton, s": "seconds_skeleton"},
    "Correspondences": {
        "same label: nodes": "same_label_share", "terminals": "same_label_terminal_share",
        "by features: right": "consistent_share", "left/right": "left_right_share",
        "front/back": "front_back_share", "coverage": "coverage", "confidence": "correspondence_confidence",
        "matching, s": "seconds_correspondence", "transfer, s": "seconds_transfer"},
}
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Segmentation transfer, measured</title><style>
body {{ font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 1180px; padding: 0 1em; }}
table {{ border-collapse: collapse; font-size: 13px; display: block; overflow-x: auto; }}
th, td {{ padding: 3px 9px; text-align: right; border-bottom: 1px solid #e4e4e4; }}
th:first-child, td:first-child {{ text-align: left; }} tr.group td {{ font-weight: 600; }}
.met {{ color: #14743a; }} .missed {{ color: #b3261e; }} img {{ max-width: 100%; }} figure {{ margin: 1em 0; }}
</style></head><body><h1>Segmentation transfer, measured</h1>
{body}
</body></html>
"""


def read_table(path):
    """The rows of a CSV file; what is not a number stays a text, and an empty cell is NaN."""
    def value(cell):
        try:
            return float(cell or "nan")
        except ValueError:
            return cell

    with open(path, newline="") as file:
        return [{name: cell if name in ("category", "error") else value(cell) for name, cell in row.items()}
                for row in csv.DictReader(file)]


def number(value, digits=3):
    return "–" if math.isnan(value) else f"{value:.{digits}f}"


def name_of(pair):
    return f"{pair['category']} {pair['source']:.0f} to {pair['target']:.0f}"


def table(summary, columns, bars_of):
    """The numbers, green or red where the row has a bar for them."""
    def cell(row, column):
        value, bar = row[column], bars_of.get(row["category"], {}).get(column)
        if bar is None or math.isnan(value):
            return f"<td>{number(value)}</td>"
        less, sign = ("rand_error" in column), "≤" if "rand_error" in column else "≥"
        met = "met" if (value <= bar if less else value >= bar) else "missed"
        return f'<td class="{met}">{number(value)} ({sign} {number(bar, 2)})</td>'

    head = "".join(f"<th>{title}</th>" for title in columns)
    rows = "\n".join(
        f'<tr{" class=group" if row["category"] in bars_of else ""}><td>{html.escape(row["category"])}</td>'
        + "".join(cell(row, column) for column in columns.values()) + "</tr>" for row in summary)
    return f"<table><tr><th></th>{head}</tr>\n{rows}</table>"


def image(png, caption):
    data = base64.b64encode(png).decode()
    return (f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def plot(figure, caption):
    content = io.BytesIO()
    figure.savefig(content, dpi=110, bbox_inches="tight")
    pyplot.close(figure)
    return image(content.getvalue(), caption)


def strips(summary, pairs, column, caption):
    """All pairs of each category in a row of their own, with their mean and the baselines."""
    rows = [row for row in summary if any(pair["category"] == row["category"] for pair in pairs)]
    figure, axes = pyplot.subplots(figsize=(9, 1 + 0.3 * len(rows)))
    for height, row in enumerate(rows):
        values = [pair[column] for pair in pairs if pair["category"] == row["category"]]
        # Spread in three lines, so that equal values show.
        axes.plot(values, [height + 0.15 * (i % 3 - 1) for i in range(len(values))], ".", color="C0", alpha=0.4,
                  label="a pair")
        axes.plot(row[column], height, "k|", markersize=14, markeredgewidth=2.5, label="mean")
        for baseline, color, label in (("humans", "C2", "humans among themselves"),
                                   ("rigid", "C3", "rigid alignment, nearest face")):
            value = row.get(f"{baseline}_{column}", math.nan)
            if not math.isnan(value):
                axes.plot(value, height, "D", color=color, fillstyle="none", label=label)
    axes.set(xlabel=caption, xlim=(0, None), yticks=range(len(rows)),
             yticklabels=[row["category"] for row in rows])
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.3)
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles))
    figure.legend(once.values(), once.keys(), ncol=4, loc="lower left", bbox_to_anchor=(0.1, 0.98),
                  frameon=False)
    return plot(figure, caption)


def scatter(pairs, x, y):
    figure, axes = pyplot.subplots(figsize=(5, 5))
    axes.plot([pair[x] for pair in pairs], [pair[y] for pair in pairs], ".", alpha=0.4)
    axes.set(xlabel=x.replace("_", " "), ylabel=y.replace("_", " "), xlim=(0, 1), ylim=(0, 1))
    axes.grid(alpha=0.3)
    return plot(figure, f"{y} over {x}".replace("_", " "))


def reliability(pairs):
    """Of the matchings of each confidence, how many are right: label accuracy of 0.8 or more."""
    rows = []
    measured = [pair for pair in pairs if not math.isnan(pair["matching_confidence"])]
    for tenth in range(10):
        right = [pair["label_accuracy"] >= 0.8 for pair in measured
                 if min(int(10.0 * pair["matching_confidence"]), 9) == tenth]
        if right:
            rows.append(f"<tr><td>{tenth / 10:.1f} to {(tenth + 1) / 10:.1f}</td><td>{len(right)}</td>"
                        f"<td>{sum(right) / len(right):.2f}</td></tr>")
    return ("<table><tr><th>confidence in the matching</th><th>pairs</th><th>right</th></tr>"
            + "".join(rows) + "</table>\n")


def worst_pairs(pairs):
    """Those of least label accuracy, a few of each category."""
    measured = sorted((pair for pair in pairs if not math.isnan(pair["label_accuracy"])),
                      key=lambda pair: (pair["category"], pair["label_accuracy"]))
    for i, pair in enumerate(measured):
        if i < WORST_OF_EACH or measured[i - WORST_OF_EACH]["category"] != pair["category"]:
            yield pair


def picture(marrow, data, results, pair):
    """The target as it should be, the source, and the target as it came out."""
    def integers(path):
        return np.loadtxt(path, dtype=int, ndmin=1)

    source, target = (marrow.read(data / f"meshes/{pair[side]:.0f}.off") for side in ("source", "target"))
    labels = {side: integers(data / f"labels/{pair[side]:.0f}.seg") for side in ("source", "target")}
    pieces = integers(data / f"pieces/{pair['source']:.0f}.seg")
    label_of_piece = dict(zip(pieces, labels["source"]))
    result = integers(
        results / f"segments/{pair['category']}/{pair['source']:.0f}_{pair['target']:.0f}.seg")
    # What came out has a scene of its own: aligned with the others by its labels, wrong labels would turn it.
    scenes = [
        marrow.render(target.with_segments(labels["target"]), source.with_segments(labels["source"]),
                      captions=["as it should be", "source"], tile_width=300, tile_height=260),
        marrow.render(target.with_segments([label_of_piece[piece] for piece in result]),
                      captions=["as it came out"], tile_width=300, tile_height=260)]
    png = io.BytesIO()
    pyplot.imsave(png, np.hstack(scenes), format="png")
    return image(png.getvalue(), f"{name_of(pair)}: {number(pair['label_accuracy'])} label accuracy, "
                                 f"{number(pair['rand_error'])} Rand error")


def pictures(data, results, pairs):
    try:
        import marrow
    except ImportError:
        return "<p>No pictures: the Python package marrow is not on the PYTHONPATH.</p>"
    if not marrow.vtk.vtkMarrowSideBySideScene.HasDisplay():
        return "<p>No pictures: there was no display to draw them on.</p>"
    return "\n".join(picture(marrow, data, results, pair) for pair in worst_pairs(pairs))


def errors(results):
    found = [(row["category"] + f" {row['source']:.0f}" if row["source"] == row["target"] else name_of(row),
              row["error"]) for row in results if row["error"]]
    if not found:
        return "<p>None.</p>"
    return "<ul>" + "".join(
        f"<li>{html.escape(f'{name}: {error}')}</li>\n" for name, error in found) + "</ul>"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    data, results = map(pathlib.Path, sys.argv[1:])
    if not (results / "summary.csv").exists():
        sys.exit(f"{results}: there is no summary.csv; run marrow-benchmark-segmentation first.")
    summary, pairs, meshes = (read_table(results / f"{name}.csv") for name in ("summary", "pairs", "meshes"))
    groups = json.loads(FIGURES.read_text())["groups"]
    bars_of = {group["name"]: group["bars"] for group in groups}
    sections = {title: table(summary, columns, bars_of) for title, columns in TABLES.items()}
    if pairs:
        sections["Label accuracy of every pair"] = strips(
            summary, pairs, "label_accuracy", "label accuracy, share of the area")
        sections["Rand error of every pair"] = strips(
            summary, pairs, "rand_error", "Rand error, mean over the humans")
        sections["Confidence and accuracy"] = (
            scatter(pairs, "segment_confidence", "label_accuracy") + reliability(pairs))
        sections["Worst pairs"] = pictures(data, results, pairs)
    sections["Errors"] = errors(meshes + pairs)
    method = (results / "method.txt").read_text().strip()
    introduction = (
        f"<p>{len(pairs)} ordered pairs of {len(meshes)} meshes: the pieces of one mesh carried to another of "
        "its category, all parameters at their defaults. The errors are means over the human segmentations of "
        "the target; label accuracy is by area. Rows in bold are means over categories.</p>\n"
        f"<p>Method: {html.escape(method)}.</p>\n")
    body = introduction + "\n".join(f"<h2>{title}</h2>\n{content}" for title, content in sections.items())
    (results / "report.html").write_text(PAGE.format(body=body), encoding="utf-8")


main()
