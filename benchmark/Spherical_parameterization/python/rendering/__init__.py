"""Pictures of maps: a surface and its image on the sphere, drawn alike wherever they are drawn.

From the bottom up: fragments finds what is seen at each pixel; views chooses cameras, and turns spheres like their
surfaces; colors has the scale of distortions; painting puts these together under the one light. Needs numpy, and
matplotlib for its colour map, but no display, and the same meshes give the same pixels.
"""
