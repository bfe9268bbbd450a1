"""The parts of measure_performance.py.

From the bottom up: benchmark_program runs the measuring programs; manual fills in the page of the user manual; session
ties these together; comparison, stages, limits and trade are the sections.
"""
