"""The parts of reproduce_paper.py.

From the bottom up: meshes and distortion know numpy only; models finds the meshes; program runs the command line
program on them; report, plots and pictures write what a reader sees; session ties these together; table1, optimization,
robustness, large_and_conformal and checks are the experiments.
"""
