# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the docstrings give what they say."""
import doctest
import importlib
import inspect
import pkgutil
import unittest

import marrow


def load_tests(_loader, tests, _pattern):
    for module in pkgutil.iter_modules(marrow.__path__, "marrow."):
        tests.addTests(doctest.DocTestSuite(importlib.import_module(module.name)))
    return tests


class TestDocstrings(unittest.TestCase):
    def test_everything_public_has_one(self):
        for name in marrow.__all__:
            public = getattr(marrow, name)
            if inspect.isclass(public) or inspect.isfunction(public):
                self.assertTrue(public.__doc__, name)
                for attribute, value in vars(public).items():
                    if isinstance(value, property):
                        self.assertTrue(value.__doc__, f"{name}.{attribute}")


if __name__ == "__main__":
    unittest.main()
