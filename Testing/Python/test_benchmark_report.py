# SPDX-License-Identifier: BSD-3-Clause
"""The segmentation benchmark's report says what its tables say (needs Debian's matplotlib)."""
import csv
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import marrow

PLOT = pathlib.Path(os.environ["MARROW_SOURCE"], "Testing/Benchmarks/Collection/plot_collection.py")
REPORT = pathlib.Path(os.environ["MARROW_SOURCE"], "Testing/Benchmarks/Segmentation/report.py")
OUTPUT = pathlib.Path(os.environ["MARROW_TEST_OUTPUT"], "BenchmarkReport")
# What the report reads of the tables; what is not here is empty.
PAIRS = [
    {"category": "Ant", "source": 1, "target": 2, "label_accuracy": 0.75, "rand_error": 0.125,
     "segment_confidence": 0.5, "matching_confidence": 0.95},
    {"category": "Ant", "source": 2, "target": 1, "label_accuracy": 0.5, "rand_error": 0.25,
     "segment_confidence": 0.25, "matching_confidence": 0.35},
    {"category": "Ant", "source": 2, "target": 3, "error": "ant <3>: cut, and short"},
]
SUMMARY = [
    {"category": "Ant", "label_accuracy": 0.625, "rand_error": 0.1875, "humans_rand_error": 0.034},
    {"category": "with limbs", "label_accuracy": 0.625, "rand_error": 0.1},
    {"category": "all", "label_accuracy": 0.875},
]


def write_table(name, rows, columns):
    with open(OUTPUT / "results" / f"{name}.csv", "w", newline="") as file:
        table = csv.DictWriter(file, columns)
        table.writeheader()
        table.writerows(rows)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class TestBenchmarkReport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(OUTPUT, ignore_errors=True)
        for folder in ("meshes", "labels", "pieces"):
            (OUTPUT / "data" / folder).mkdir(parents=True)
        (OUTPUT / "results/segments/Ant").mkdir(parents=True)
        for i in (1, 2):
            creature = marrow.creature("octopus", seed=i, resolution=2000)
            marrow.write(creature, OUTPUT / f"data/meshes/{i}.off")
            marrow.write(creature, OUTPUT / f"data/labels/{i}.seg")
            # Pieces have numbers of their own.
            marrow.write(creature, OUTPUT / f"data/pieces/{i}.seg", segments=creature.segments + 7)
            marrow.write(creature, OUTPUT / f"results/segments/Ant/{3 - i}_{i}.seg",
                         segments=creature.segments + 7)
        summary = set().union(*(re.findall(r': "(\w+)"', line) for line in REPORT.read_text().splitlines()))
        write_table("summary", SUMMARY, ["category", "humans_rand_error", "rigid_rand_error",
                                         *sorted(summary - {"humans_rand_error", "rigid_rand_error"})])
        write_table("pairs", PAIRS, ["category", "source", "target", "label_accuracy", "rand_error",
                                     "segment_confidence", "matching_confidence", "error"])
        write_table("meshes", [{"category": "Ant", "source": i, "target": i, "error": ""} for i in (1, 2)],
                    ["category", "source", "target", "error"])
        (OUTPUT / "results/method.txt").write_text("skeleton msp, matcher tree\n")

    def report(self, results="results", **environment):
        done = subprocess.run([sys.executable, REPORT, OUTPUT / "data", OUTPUT / results], text=True,
                              capture_output=True, env={**os.environ, **environment})
        return done.stderr, (OUTPUT / "results/report.html").read_text() if done.returncode == 0 else None

    def test_numbers_bars_and_errors(self):
        stderr, page = self.report(DISPLAY="")
        self.assertEqual(stderr, "")
        self.assertIn("<td>Ant</td><td>0.625</td>", page)
        # Of each confidence, how many pairs and which share of them is right.
        self.assertIn("<td>0.3 to 0.4</td><td>1</td><td>0.00</td>", page)
        self.assertIn('<td>with limbs</td><td class="missed">0.625 (≥ 0.90)</td>', page)
        self.assertIn('<td class="met">0.100 (≤ 0.11)</td>', page)
        self.assertIn('<td>all</td><td class="met">0.875 (≥ 0.85)</td>', page)
        self.assertIn("3 ordered pairs of 2 meshes", page)
        self.assertIn("Method: skeleton msp, matcher tree.", page)
        self.assertIn("<li>Ant 2 to 3: ant &lt;3&gt;: cut, and short</li>", page)
        self.assertEqual(page.count("<img"), 3)  # the plots
        self.assertIn("there was no display", page)

    @unittest.skipUnless(marrow.vtk.vtkMarrowSideBySideScene.HasDisplay(), "there is no display")
    def test_worst_pairs_are_drawn_the_worst_first(self):
        stderr, page = self.report()
        self.assertEqual(stderr, "")
        drawn = re.findall(r"<figcaption>(Ant \d to \d: \S+ label accuracy)", page)
        self.assertEqual(drawn, ["Ant 2 to 1: 0.500 label accuracy", "Ant 1 to 2: 0.750 label accuracy"])

    def test_what_is_missing_is_named(self):
        stderr, page = self.report("nowhere")
        self.assertIsNone(page)
        self.assertIn("there is no summary.csv; run marrow-benchmark-segmentation first.", stderr)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class TestCollectionPlot(unittest.TestCase):
    def setUp(self):
        self.folder = OUTPUT / "collection"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.table = self.folder / "result.csv"
        with open(self.table, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([
                ["category", "sources", "company", "accuracy", "wrong_in_least_sure_tenth"],
                ["Ant", 1, 1, 0.5, 0.25], ["Ant", 7, 1, 1.0, 0.5], ["Ant", 1, 0, 0.25, 0.125],
                ["Vase", 1, 1, 0.75, 0.75]])

    def test_a_point_is_the_mean_of_all_categories_or_is_not_there(self):
        spec = importlib.util.spec_from_file_location("plot_collection", PLOT)
        plot = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(plot)
        table = plot.read(self.table)
        self.assertEqual(plot.series(table, True, ["Ant", "Vase"], 0), ([1], [0.625]))
        self.assertEqual(plot.series(table, True, ["Ant"], 0), ([1, 7], [0.5, 1.0]))
        self.assertEqual(plot.series(table, True, ["Ant"], 1), ([1, 7], [0.25, 0.5]))
        self.assertEqual(plot.series(table, False, ["Ant"], 0), ([1], [0.25]))

    def test_the_pictures_are_drawn(self):
        subprocess.run([sys.executable, PLOT, self.table, "-o", self.folder], check=True)
        for name in ("means.png", "categories.png"):
            self.assertEqual((self.folder / name).read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
