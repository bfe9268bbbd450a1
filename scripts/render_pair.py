#!/usr/bin/env python3
"""Usage: scripts/render_pair.py PREFIX OUTPUT.jpg

Renders PREFIX_surface.ply and PREFIX_sphere.ply, which the program writes with --colored PREFIX, side by side.
Needs VTK, on Debian and Ubuntu the package python3-vtk9; without a display, run it with xvfb-run -a (packages xvfb, xauth).
"""

import sys

import vtk


def renderer_of(path, viewport):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SetFeatureAngle(60)
    normals.Update()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.8)
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.35, 0.25, -1)
    camera.SetViewUp(0, 1, 0)
    renderer.ResetCamera()
    camera.Zoom(1.4)
    return renderer


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    prefix, output = sys.argv[1:]
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1200, 600)
    window.AddRenderer(renderer_of(prefix + "_surface.ply", (0, 0, 0.5, 1)))
    window.AddRenderer(renderer_of(prefix + "_sphere.ply", (0.5, 0, 1, 1)))
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkJPEGWriter()
    writer.SetQuality(90)
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(output)
    writer.Write()


main()
