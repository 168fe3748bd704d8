# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that help(sherd) describes all public names, and that the stub has the names of the compiled module."""
import ast
import inspect
import pathlib
import unittest

import sherd
from sherd import _sherd

STUB = pathlib.Path(_sherd.__file__).with_name("_sherd.pyi")
WITH_UNITS = (_sherd.Snapshot, _sherd.StepReport)


def is_public(name):
    return not name.startswith("_")


def members(kind):
    """Returns the members of a compiled class by name, without those that Python and pybind11 add."""
    return {name: member for name, member in vars(kind).items()
            if name in ("__len__",) or not name.startswith("__") and not name.startswith("_pybind11")}


def stub_classes():
    return {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.ClassDef)}


class Names(unittest.TestCase):
    def test_all_public_names_are_there_and_described(self):
        for name in sherd.__all__:
            self.assertTrue(inspect.getdoc(getattr(sherd, name)), name)
            self.assertRegex(sherd.__doc__, rf"(?m)^{name} " if name != "Cut" else "cut", name)
        self.assertTrue(sherd.__version__)

    def test_all_members_are_described(self):
        for name in sherd.__all__:
            kind = getattr(sherd, name)
            if not inspect.isclass(kind) or issubclass(kind, (Exception, tuple)):
                continue
            for member, value in inspect.getmembers(kind):
                if not is_public(member):
                    continue
                said = inspect.getdoc(value) or ""
                # pybind11 puts the signature first
                if not isinstance(value, property) and said.startswith(f"{member}("):
                    said = "".join(said.splitlines()[1:])
                self.assertTrue(said.strip(), f"{name}.{member}")

    def test_arrays_say_their_shapes_or_units(self):
        for kind in WITH_UNITS:
            for name, member in members(kind).items():
                self.assertRegex(member.__doc__, r"^(\[|Number|s$|[\w/^* ]+$|[\w/^* ]+;)", f"{kind.__name__}.{name}")

    def test_the_stub_has_what_is_compiled(self):
        classes = stub_classes()
        compiled = {name for name, value in vars(_sherd).items() if inspect.isclass(value)}
        self.assertEqual(compiled, set(classes))
        for name in compiled - {"Error"}:
            declared = {node.name for node in classes[name].body} - {"__init__"}
            self.assertEqual(set(members(getattr(_sherd, name))) - {"__repr__"}, declared, name)
        functions = {node.name for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.FunctionDef)}
        self.assertEqual({name for name, value in vars(_sherd).items() if inspect.isbuiltin(value)}, functions)

    def test_what_is_python_is_annotated(self):
        for name in sherd.__all__:
            kind = getattr(sherd, name)
            functions = [kind] if inspect.isfunction(kind) else [
                value for value in vars(kind).values() if inspect.isfunction(value) and "sherd/_" in
                inspect.getsourcefile(value)]
            for function in functions:
                signature = inspect.signature(function)
                self.assertIsNot(signature.return_annotation, inspect.Signature.empty, f"{name}: {function}")
                for parameter in list(signature.parameters.values()):
                    if parameter.name != "self":
                        self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{name}: {function}")
        self.assertTrue(STUB.with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main()
