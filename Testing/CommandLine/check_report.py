#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page of `marrow collection --report` in a real browser.

    check_report.py MARROW OUTPUT

Labels a folder of creatures in the folder OUTPUT, opens the page, looks through it from top to bottom, and
leaves a picture of each screen in OUTPUT. Ends with 77, which CTest takes for skipped, where there is neither
Chromium nor a display.
"""
import csv
import os
import shutil
import subprocess
import sys
import unittest

import browser
import marrow

COMMAND, OUTPUT = sys.argv[1:3]
SKIPPED = 77
HEIGHT = 1000


def write_creatures(folder):
    """Bipeds, one of them labelled, and one whose name has to be escaped."""
    os.makedirs(folder)
    for seed in range(1, 7):
        mesh = marrow.creature("biped", seed=seed, pose=0.7, proportion=0.7, resolution=3000)
        name = f"biped {seed} <b> & co" if seed == 6 else f"biped {seed}"
        marrow.write((mesh.points, mesh.faces), os.path.join(folder, name + ".off"))
        if seed == 1:
            marrow.write(mesh, os.path.join(folder, name + ".seg"))


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(OUTPUT, ignore_errors=True)
        write_creatures(os.path.join(OUTPUT, "in"))
        page = os.path.join(OUTPUT, "page.html")
        subprocess.run([COMMAND, "--quiet", "collection", os.path.join(OUTPUT, "in"), "-o",
                        os.path.join(OUTPUT, "out"), "--report", page], check=True)
        cls.browser = browser.Browser(browser.find_browser(), height=HEIGHT)
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open(page)

    def test_nothing_is_complained_about(self):
        self.assertEqual(self.browser.complaints(), [])

    def test_it_is_self_contained(self):
        addresses = self.browser.requests()
        self.assertTrue(any(address.endswith("page.html") for address in addresses))
        self.assertEqual([address for address in addresses
                          if not address.startswith("data:") and not address.endswith("page.html")], [])

    def test_every_picture_is_there_and_seen(self):
        widths = self.browser.value("[...document.images].map(image => image.naturalWidth)")
        self.assertEqual(len(widths), 5)
        # Source, segments and confidence at least, and rejected answers for some.
        self.assertGreaterEqual(min(widths), 3 * 240)
        self.assertGreater(max(widths), 3 * 240)
        shown = self.browser.value("[...document.images].map(image => image.width)")
        tiles = [round(natural / 240) for natural in widths]
        for number, width in zip(tiles, shown):
            self.assertAlmostEqual(width / number, shown[0] / tiles[0], delta=1.0)

    def test_the_least_sure_come_first(self):
        with open(os.path.join(OUTPUT, "out", "summary.csv"), encoding="utf-8") as file:
            targets = [row for row in csv.DictReader(file) if row["role"] == "target"]
        targets.sort(key=lambda row: float(row["confidence"]))
        # In the page as it is seen, so an unescaped name would show.
        names = self.browser.value(
            "[...document.querySelectorAll('figcaption b')].map(name => name.innerText)")
        self.assertEqual(names, [row["mesh"] for row in targets])
        heights = self.browser.value(
            "[...document.images].map(image => image.getBoundingClientRect().top)")
        self.assertEqual(heights, sorted(heights))

    def test_nothing_hangs_over_the_edge(self):
        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"),
                             self.browser.value("window.innerWidth"))

    def test_every_screen_can_be_looked_at(self):
        height = self.browser.value("document.documentElement.scrollHeight")
        self.assertGreater(height, HEIGHT)
        for screen, top in enumerate(range(0, height, HEIGHT)):
            self.browser.value(f"window.scrollTo(0, {top})")
            path = os.path.join(OUTPUT, f"screen-{screen}.png")
            self.browser.picture(path)
            self.assertGreater(os.path.getsize(path), 20000)  # an empty page has some 5,000


if __name__ == "__main__":
    if not browser.find_browser():
        print("skipped: Chromium is not installed (.ci/install-packages.sh chromium).")
        sys.exit(SKIPPED)
    if not os.environ.get("DISPLAY"):
        print("skipped: there is no X display to draw the report with.")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
