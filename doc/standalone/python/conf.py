"""Sphinx configuration of the reference of the Python module; see run_sphinx.cmake."""

import spherical_parameterization

project = "Python module"
copyright = "The Spherical_parameterization authors"
version = release = spherical_parameterization.__version__

extensions = ["sphinx.ext.autodoc", "sphinx.ext.autosummary", "numpydoc"]
templates_path = ["_templates"]
exclude_patterns = ["_templates"]
default_role = "py:obj"
autodoc_typehints = "none"
autosummary_filename_map = {  # some systems ignore the case of file names
    "spherical_parameterization.Overlay": "spherical_parameterization.Overlay-result",
    "spherical_parameterization.Remesh": "spherical_parameterization.Remesh-result",
}
numpydoc_show_class_members = False

html_theme = "alabaster"
html_theme_options = {"page_width": "min(96%, 75em)", "sidebar_width": "16em", "show_powered_by": False}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_title = f"Spherical Parameterization {version}: Python reference"
html_domain_indices = html_use_index = False
toc_object_entries = False
html_copy_source = False


def skip_member(app, what, name, value, skip, options):
    """Skip the fields of named tuples, which are attributes in the docstring, and what pybind11 adds to enumerations."""
    doc = getattr(value, "__doc__", None) or ""
    return skip or doc.startswith("Alias for field number") or (what == "class" and "self: handle" in doc)


def setup(app):
    app.connect("autodoc-skip-member", skip_member)
