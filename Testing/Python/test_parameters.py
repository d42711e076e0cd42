# SPDX-License-Identifier: BSD-3-Clause
"""Every parameter of every class is a keyword argument, and its default is in C++ only."""
import ast
import inspect
import re
import typing
import unittest

import marrow
from marrow import _collection, _correspondence, _creature, _measures, _picture, _skeleton, _transfer, vtk
from marrow._parameters import choices_of, set_parameter, set_parameters, snake_case

# Function, its keyword arguments, its class, parameters that the function has by another way.
FUNCTIONS = [
    (marrow.measure, _measures.MeasureParameters, vtk.vtkMSPField, set()),
    (marrow.skeleton, _skeleton.SkeletonParameters, vtk.vtkMSPSkeleton, set()),
    (marrow.correspond, _correspondence.CorrespondenceParameters,
     vtk.vtkSkeletonCorrespondence, set()),
    (marrow.transfer, _transfer.TransferParameters, vtk.vtkSegmentationTransfer, set()),
    (marrow.collection, _collection.CollectionParameters, vtk.vtkCollectionTransfer, set()),
    (marrow.fuse, _collection.FusionParameters, vtk.vtkSegmentationFusion, set()),
    (marrow.creature, _creature.CreatureParameters, vtk.vtkCreatureSource, {"shape"}),
    (marrow.render, _picture.SceneParameters, vtk.vtkMarrowSideBySideScene, {"color_skeleton_by"}),
]
if hasattr(vtk, "vtkMarrowMeanCurvatureSkeleton"):
    FUNCTIONS.append((marrow.mean_curvature_skeleton, _skeleton.MeanCurvatureSkeletonParameters,
                      vtk.vtkMarrowMeanCurvatureSkeleton, set()))
# What a program of several processes sets, and no caller of a function.
OF_PROGRAMS = {"SetController"}


def properties_of(kind):
    """The parameters that the class adds to VTK's own: names with a setter and a getter."""
    return {name[3:] for name in vars(kind)
            if name.startswith("Set") and "Get" + name[3:] in vars(kind) and name not in OF_PROGRAMS}


def getter(instance, keyword):
    return next(getattr(instance, "Get" + name) for name in properties_of(type(instance))
                if snake_case(name) == keyword.rstrip("_"))


class TestParameters(unittest.TestCase):
    def test_every_parameter_of_the_class_is_a_keyword(self):
        for function, allowed, kind, elsewhere in FUNCTIONS:
            keywords = {name.rstrip("_") for name in allowed.__annotations__}
            expected = {snake_case(name) for name in properties_of(kind)}
            self.assertEqual(keywords | elsewhere, expected, function.__name__)
            self.assertLessEqual(elsewhere, set(inspect.signature(function).parameters))

    def test_every_keyword_is_documented(self):
        for function, allowed, _, _ in FUNCTIONS:
            for name in [*allowed.__annotations__, *inspect.signature(function).parameters]:
                if name != "parameters":
                    self.assertRegex(function.__doc__, rf"\b{name}\b", function.__name__)

    def test_ranges_in_the_docstrings_are_those_of_the_class(self):
        for function, allowed, kind, _ in FUNCTIONS:
            for name in allowed.__annotations__:
                found = re.search(
                    rf"^{name} : (?:int|float), (\S+) to ([\d.]+)", inspect.getdoc(function), re.M)
                if found:
                    bounds = [getattr(kind(), getter(kind(), name).__name__ + which)()
                              for which in ("MinValue", "MaxValue")]
                    self.assertEqual([float(value) for value in found.groups()], bounds, name)

    def test_defaults_in_the_docstrings_are_those_of_the_class(self):
        for function, allowed, kind, elsewhere in FUNCTIONS:
            for name in [*allowed.__annotations__, *elsewhere - {"color_skeleton_by"}]:
                found = re.search(
                    rf"^(?:\w+, )*{name}(?:, \w+)* : .*, default: (.+)$", inspect.getdoc(function), re.M)
                self.assertTrue(found, f"{function.__name__}: {name}")
                said, is_said, untouched = ast.literal_eval(found.group(1)), kind(), kind()
                set_parameter(is_said, name, said)
                self.assertEqual(
                    getter(is_said, name)(), getter(untouched, name)(), f"{function.__name__}: {name}")

    def test_defaults_are_those_of_the_class(self):
        for function, allowed, kind, _ in FUNCTIONS:
            instance, untouched = kind(), kind()
            set_parameters(instance, function, allowed, dict.fromkeys(allowed.__annotations__))
            for keyword in allowed.__annotations__:
                self.assertEqual(getter(instance, keyword)(), getter(untouched, keyword)())
            for parameter in inspect.signature(function).parameters.values():
                self.assertIn(parameter.default, (None, False, inspect.Parameter.empty))

    def test_values_arrive(self):
        for function, allowed, kind, _ in FUNCTIONS:
            for keyword in allowed.__annotations__:
                instance = kind()
                value = getter(instance, keyword)()
                setter = "Set" + getter(instance, keyword).__name__[3:]
                for other in (self.other_value(instance, setter, value), value):
                    if other is None:  # leaves what is set
                        continue
                    set_parameters(instance, function, allowed, {keyword: other})
                    self.assertEqual(getter(instance, keyword)(), other, keyword)

    @staticmethod
    def other_value(instance, setter, value):
        if isinstance(value, tuple):
            return (0.5, 0.25, 0.125)
        if value is None or isinstance(value, str):
            return "Other"
        if isinstance(value, bool):
            return not value
        most = getattr(instance, "Get" + setter[3:] + "MaxValue")()
        return most if value != most else getattr(instance, "Get" + setter[3:] + "MinValue")()

    def test_names_of_choices(self):
        instance = vtk.vtkMSPField()
        self.assertEqual([*choices_of(instance, "SetAGDMethod")], ["all_pairs", "sampled"])
        set_parameters(instance, marrow.measure, _measures.MeasureParameters,
                       {"agd_method": "all_pairs"})
        self.assertEqual(instance.GetAGDMethod(), vtk.vtkMSPField.ALL_PAIRS)
        literal = typing.get_args(_creature.Shape)
        self.assertEqual(sorted(literal), [*choices_of(vtk.vtkCreatureSource(), "SetShape")])
        colors = typing.get_args(typing.get_args(
            typing.get_type_hints(marrow.render)["color_skeleton_by"])[0])
        self.assertEqual(
            {name.upper() for name in colors},
            {name for name in vars(vtk.vtkMarrowSkeletonGlyphs) if name.isupper()})

    def test_wrong_ones(self):
        creature = marrow.creature("capsule")
        with self.assertRaisesRegex(
                TypeError, r"skeleton\(\) got an unexpected keyword argument 'finest'; it takes "
                "progress, progress_bar, finest_area, node_spacing, maximum_faces$"):
            marrow.skeleton(creature, finest=1)
        with self.assertRaisesRegex(
                marrow.Error, "finest_area must be from 0.0 to 1.0, not 2"):
            marrow.skeleton(creature, finest_area=2)
        with self.assertRaisesRegex(marrow.Error, "lambda_ must be from 0.0 to 3.14"):
            marrow.transfer(creature, creature, lambda_=-1)
        with self.assertRaisesRegex(
                marrow.Error, "agd_method must be one of 'all_pairs', 'sampled', not 'exact'"):
            marrow.measure(creature, agd_method="exact")
        with self.assertRaisesRegex(TypeError, "finest_area='small': .*"):
            marrow.skeleton(creature, finest_area="small")
        with self.assertRaisesRegex(TypeError, "number_of_slices=2.5"):
            marrow.measure(creature, number_of_slices=2.5)

    def test_type_hints(self):
        for name in marrow.__all__:
            public = getattr(marrow, name)
            if inspect.isfunction(public):
                hints = typing.get_type_hints(public)
                for parameter in inspect.signature(public).parameters:
                    self.assertIn(parameter, hints, name)
                self.assertIn("return", hints, name)


if __name__ == "__main__":
    unittest.main()
