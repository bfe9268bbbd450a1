"""The figures of the user manual.

From the bottom up: sheet is what a figure is drawn on; models finds the meshes and says how they are looked at;
session maps and paints them; patterns covers the sphere with something to look at; pulled_back, distortions and choices
have one function for each figure.
"""
