"""Runs the app: ``python -m spherical_parameterization.bids STUDY OUTPUT participant``."""

from ._app import run

if __name__ == "__main__":
    run()
