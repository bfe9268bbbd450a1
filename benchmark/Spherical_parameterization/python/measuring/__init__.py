"""What the drivers of the benchmarks have in common.

From the bottom up: meshes, mesh_files and distortion know numpy only; program runs the command line program on meshes
and measures its maps; report and plots write what a reader sees; environment tells what was measured with, and where.
"""
