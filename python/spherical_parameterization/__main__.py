"""Run the command line program: ``python -m spherical_parameterization map bunny.off -o sphere.off``."""

from ._program import run

if __name__ == "__main__":
    run()
