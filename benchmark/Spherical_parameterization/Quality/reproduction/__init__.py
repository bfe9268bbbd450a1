"""The parts of reproduce_paper.py.

From the bottom up: models finds the meshes; pictures draws them; session ties these and the package `measuring`
together; table1, optimization, robustness, large_and_conformal and checks are the experiments.
"""
