# SPDX-License-Identifier: BSD-3-Clause
"""The docstrings of the functions have all sections, and their examples give what they say."""
import doctest
import importlib
import inspect
import pkgutil
import unittest

import pyvista_stand_in

pyvista_stand_in.provide()
import marrow  # noqa: E402
from marrow import _pyvista  # noqa: E402


def load_tests(_loader, tests, _pattern):
    for module in pkgutil.iter_modules(marrow.__path__, "marrow."):
        tests.addTests(doctest.DocTestSuite(
            importlib.import_module(module.name), optionflags=doctest.ELLIPSIS))
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

    def test_functions_have_all_sections(self):
        functions = [getattr(marrow, name) for name in marrow.__all__]
        functions += [value for name, value in vars(_pyvista.MarrowAccessor).items() if name[0] != "_"]
        for function in filter(inspect.isfunction, functions):
            for section in ("Parameters", "Returns", "Raises", "Examples"):
                if (function, section) != (marrow.write, "Returns"):
                    underlined = rf"\n{section}\n{'-' * len(section)}\n"
                    self.assertRegex(inspect.getdoc(function), underlined, function.__name__)


if __name__ == "__main__":
    unittest.main()
