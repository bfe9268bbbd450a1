#!/usr/bin/env python3
"""Usage: render.py JOBS.json

Renders coloured meshes with VTK. It is a process of its own, since VTK ends the process where it finds no display;
pictures.py starts it, under xvfb-run where there is none. JOBS.json is a list of objects with the names "input" (an
.npz file with points, faces, colors, direction, up, half_height), "output" (a .png file), "size" (pixels), "has_edges".
"""

import json
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def polydata(points, faces, colors):
    data = vtk.vtkPolyData()
    vertices = vtk.vtkPoints()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=True))
    data.SetPoints(vertices)
    corners = np.insert(faces, 0, 3, axis=1).astype(np.int64).ravel()
    cells = vtk.vtkCellArray()
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    scalars = numpy_to_vtk(np.ascontiguousarray(colors, dtype=np.uint8), deep=True)
    data.GetCellData().SetScalars(scalars)
    return data


def render(job):
    values = np.load(job["input"])
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(polydata(values["points"], values["faces"], values["colors"]))
    normals.ConsistencyOff()  # folded faces keep their side
    normals.AutoOrientNormalsOff()
    normals.SplittingOn()
    normals.SetFeatureAngle(60)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.75)
    if job["has_edges"]:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.15)
        actor.GetProperty().SetLineWidth(0.5)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*values["direction"])
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(*values["up"])
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.SetParallelScale(float(values["half_height"]))
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(job["size"], job["size"])
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(job["output"])
    writer.Write()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        for job in json.load(file):
            render(job)


main()
