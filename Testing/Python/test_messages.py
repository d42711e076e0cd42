# SPDX-License-Identifier: BSD-3-Clause
"""Nothing goes to VTK's output window, and that of the user is left as it was."""
import subprocess
import sys
import threading
import time
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import vtkOutputWindow

import marrow
from shapes import prism


class TestMessages(unittest.TestCase):
    def test_nothing_is_printed(self):
        script = (
            "import warnings, numpy, marrow\n"
            "warnings.simplefilter('ignore')\n"
            "mesh = marrow.creature('snake', resolution=5000)\n"
            "for points in (mesh.points[:0], mesh.points * numpy.nan):\n"
            "    for function in (marrow.measure, marrow.skeleton):\n"
            "        try: function((points, mesh.faces[:len(points)]))\n"
            "        except marrow.Error: print('raised')\n"
            "marrow.transfer(marrow.creature('octopus'), mesh)\n"
        )
        done = subprocess.run([sys.executable, "-c", script], text=True, capture_output=True,
                              check=True)
        self.assertEqual((done.stdout, done.stderr), ("raised\n" * 4, ""))

    def test_the_sentence_and_nothing_else(self):
        points, faces = prism()
        points[7] = np.inf
        with self.assertRaises(marrow.Error) as caught:
            marrow.measure((points, faces))
        self.assertEqual(
            str(caught.exception),
            "measure: The mesh has 1 point in use whose coordinates are not finite (the first is "
            "point 7): remove or repair it.")

    def test_an_error_is_a_value_error(self):
        self.assertTrue(issubclass(marrow.Error, ValueError))

    def test_the_window_of_the_user_is_back(self):
        window = vtkOutputWindow.GetInstance()
        with self.assertRaises(marrow.Error):
            marrow.measure((np.zeros((3, 3)), [[0, 1, 1]]))
        marrow.measure(prism())
        self.assertIs(vtkOutputWindow.GetInstance(), window)

    def test_threads_hear_their_own(self):
        window = vtkOutputWindow.GetInstance()
        good, bad = marrow.creature("snake"), marrow.creature("snake")
        bad = (bad.points * np.nan, bad.faces)
        told = []

        def work(mesh):
            for _ in range(5):
                try:
                    # In the callback Python may go on with the other thread.
                    marrow.skeleton(mesh, progress=lambda _: time.sleep(0.002))
                    told.append("done")
                except marrow.Error:
                    told.append("error")

        threads = [threading.Thread(target=work, args=(mesh,)) for mesh in (good, good, bad)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((told.count("done"), told.count("error")), (10, 5))
        self.assertIs(vtkOutputWindow.GetInstance(), window)

    def test_a_callback_may_call_us(self):
        told = []

        def callback(done):
            if 0 < done < 1 and not told:
                told.append(marrow.measure(prism()).msp.max())

        marrow.skeleton(marrow.creature("snake"), progress=callback)
        self.assertEqual(len(told), 1)

    def test_warnings_may_be_errors(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(marrow.MarrowWarning):
                marrow.transfer(marrow.creature("octopus"), prism())


if __name__ == "__main__":
    unittest.main()
