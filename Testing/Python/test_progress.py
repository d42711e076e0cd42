# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import io
import os
import signal
import threading
import time
import unittest

import marrow


class TestProgress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = marrow.creature("biped", resolution=5000)
        cls.target = marrow.creature("biped", pose=0.5, seed=7, resolution=5000)

    def functions(self, **arguments):
        marrow.measure(self.source, **arguments)
        yield "measure"
        marrow.skeleton(self.source, **arguments)
        yield "skeleton"
        if hasattr(marrow.vtk, "vtkMarrowMeanCurvatureSkeleton"):
            marrow.mean_curvature_skeleton(self.source, **arguments)
            yield "mean_curvature_skeleton"
        marrow.correspond(self.source, self.target, **arguments)
        yield "correspond"
        marrow.transfer(self.source, self.target, **arguments)
        yield "transfer"
        marrow.evaluate(self.source, self.source, **arguments)
        yield "evaluate"

    def test_it_grows_from_nothing_to_all(self):
        told = []
        for function in self.functions(progress=told.append):
            self.assertEqual((told[0], told[-1]), (0.0, 1.0), function)
            self.assertEqual(told, sorted(set(told)), function)
            if function in ("correspond", "transfer"):
                self.assertGreater(len(told), 10, function)
            told.clear()

    def test_bar(self):
        stream = io.StringIO()
        with contextlib.redirect_stderr(stream):
            for function in self.functions(progress_bar=True):
                lines = stream.getvalue().split("\r")
                self.assertRegex(lines[-1], rf"^{function} \[#{{40}}\] 100 %\n$")
                self.assertRegex(lines[1], rf"^{function} \[-{{40}}\]   0 %$")
                stream.seek(0)
                stream.truncate()

    def test_nothing_is_written_unasked(self):
        stream = io.StringIO()
        with contextlib.redirect_stderr(stream):
            marrow.measure(self.source)
        self.assertEqual(stream.getvalue(), "")

    def test_an_exception_of_the_callback_stops_the_work(self):
        told = []

        def stop(done):
            told.append(done)
            if done > 0.1:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            marrow.transfer(self.source, self.target, progress=stop)
        self.assertLess(max(told), 0.5)

    def test_control_c(self):
        big = marrow.creature("biped", resolution=60000)
        handler = signal.getsignal(signal.SIGINT)
        started = threading.Event()
        interrupter = threading.Thread(
            target=lambda: (started.wait(), os.kill(os.getpid(), signal.SIGINT)))
        interrupter.start()
        told = []
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            marrow.measure(
                big, agd_method="all_pairs", progress=lambda done: (told.append(done), started.set()))
        interrupter.join()
        self.assertLess(max(told), 1.0)
        self.assertLess(time.monotonic() - begin, 20.0)
        self.assertIs(signal.getsignal(signal.SIGINT), handler)

    def test_in_another_thread(self):
        results = []
        thread = threading.Thread(target=lambda: results.append(marrow.measure(self.source)))
        thread.start()
        thread.join()
        self.assertEqual(len(results), 1)


if __name__ == "__main__":
    unittest.main()
