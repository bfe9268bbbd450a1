"""Checks the docstrings: the form that numpydoc defines, and the examples."""

import doctest
import inspect
import re
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp

INDEX = Path(__file__).resolve().parents[2] / "doc/standalone/python/index.rst"
CODES_OFF = {
    "GL01": "summaries start next to the quotes, as PEP 257 has it",
    "ES01": "a summary may say everything",
    "SA01": "most functions stand alone",
    "EX01": "results are shown with the functions that return them",
}
CODES_OFF_FOR_RESULTS = {"PR01": "only functions of the module construct them, so that they have Attributes instead"}


def documented_objects():
    """Return the public names, and those of the methods and properties that the classes define themselves."""
    names = sorted(set(sp.__all__) - {"__version__"})
    for name in list(names):
        for member, value in vars(getattr(sp, name)).items() if inspect.isclass(getattr(sp, name)) else ():
            if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                names.append(f"{name}.{member}")
    return [name for name in names if not name.startswith("ErrorCode")]  # pybind11 has a form of its own


@pytest.mark.parametrize("name", ["", *documented_objects()])
def test_docstring_has_the_form_of_numpydoc(name):
    numpydoc_validate = pytest.importorskip("numpydoc.validate")
    result = numpydoc_validate.validate(f"spherical_parameterization.{name}".rstrip("."))
    codes_off = {**CODES_OFF, **(CODES_OFF_FOR_RESULTS if "\nAttributes\n" in result["docstring"] else {})}
    assert [error for error in result["errors"] if error[0] not in codes_off] == []


@pytest.fixture(scope="module")
def example_names():
    names = {}
    exec(doctest.script_from_examples(sp.__doc__), names)
    return names


@pytest.mark.parametrize("name", documented_objects())
def test_examples_of_docstring(name, example_names, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    vertices, faces = example_names["vertices"], example_names["faces"]
    rows = [" ".join(map(repr, row)) for row in vertices.tolist()] + ["3 %d %d %d" % tuple(row) for row in faces]
    (tmp_path / "bunny.off").write_text(f"OFF\n{len(vertices)} {len(faces)} 0\n" + "\n".join(rows) + "\n")
    value = sp
    for part in name.split("."):
        value = getattr(value, part)
    report = []
    runner = doctest.DocTestRunner(verbose=False)
    for test in doctest.DocTestFinder(recurse=False).find(value, name, module=False, globs=dict(example_names)):
        runner.run(test, out=report.append)
    assert report == []


def test_the_reference_has_every_name():
    if not INDEX.is_file():
        pytest.skip("source distributions are without it")
    names = re.findall(r"^   (\w+)$", INDEX.read_text(), re.MULTILINE)
    assert sorted(names) == sorted(set(sp.__all__) - {"__version__"})
