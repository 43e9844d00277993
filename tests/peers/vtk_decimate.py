"""VTK's vtkQuadricDecimation behind standard input and output, for vtk.ts.

One request a line, a JSON object; one answer a line:

    {"open": PATH}   the surface from here on, a binary little-endian PLY file   -> VTK's version
    {"scales": [of position, then one a variable], "triangles": how many to leave, "volume": bool, "out": PATH}
        positions and variables are multiplied by their scales, decimated with attribute errors, divided again and
        written as PLY                                                            -> the number of triangles left
"""

import json
import re
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

FACE = numpy.dtype([("count", "u1"), ("corners", "<u4", 3)])


def read_ply(path):
    """All vertex properties, one row a vertex (x, y, z first), and the triangles."""
    content = open(path, "rb").read()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    header = content[:end].decode()
    vertices, faces = (int(re.search(rf"element {name} (\d+)", header)[1]) for name in ("vertex", "face"))
    properties = re.findall(r"property (float|double) (\S+)", header)
    kind = "<f4" if properties[0][0] == "float" else "<f8"
    rows = numpy.frombuffer(content, kind, vertices * len(properties), end).reshape(vertices, -1).astype(float)
    order = [[name for _, name in properties].index(axis) for axis in "xyz"]
    order += [column for column in range(len(properties)) if column not in order]
    triangles = numpy.frombuffer(content, FACE, faces, end + vertices * len(properties) * int(kind[2]))["corners"]
    return rows[:, order], triangles.astype(numpy.int64)


def write_ply(path, rows, triangles):
    names = ["x", "y", "z"] + [f"variable_{i + 1}" for i in range(rows.shape[1] - 3)]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(triangles)}", "property list uchar uint vertex_indices", "end_header\n"]
    faces = numpy.empty(len(triangles), FACE)
    faces["count"], faces["corners"] = 3, triangles
    with open(path, "wb") as file:
        file.write("\n".join(header).encode() + rows.astype("<f4").tobytes() + faces.tobytes())


def poly_data(rows, triangles):
    """Position as points, every other column, where there is one, as a component of the scalars."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(rows[:, :3]), deep=True))
    cells = vtkCellArray()
    counted = numpy.hstack([numpy.full((len(triangles), 1), 3), triangles]).ravel()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(counted, deep=True))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    if rows.shape[1] > 3:
        scalars = numpy_to_vtk(numpy.ascontiguousarray(rows[:, 3:]), deep=True)
        scalars.SetName("variables")
        surface.GetPointData().SetScalars(scalars)
    return surface


def prepared_decimation(rows, triangles, request):
    """The filter that a request asks for, not yet run, and the scales of the columns."""
    scales = numpy.array([request["scales"][0]] * 3 + request["scales"][1:])
    scaled = rows * scales
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(poly_data(scaled, triangles))
    decimation.SetTargetReduction(1 - request["triangles"] / len(triangles))
    decimation.SetVolumePreservation(request["volume"])
    decimation.SetAttributeErrorMetric(rows.shape[1] > 3)
    for attribute in ("Vectors", "Normals", "TCoords", "Tensors"):
        getattr(decimation, f"Set{attribute}Attribute")(False)
    # VTK divides the scalars by the largest range of a component; this weight takes that back, so that the scales hold.
    if rows.shape[1] > 3:
        decimation.SetScalarsWeight(float(numpy.ptp(scaled[:, 3:], axis=0).max()))
    return decimation, scales


def decimate(rows, triangles, request):
    decimation, scales = prepared_decimation(rows, triangles, request)
    decimation.Update()
    output = decimation.GetOutput()
    corners = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(output.GetPoints().GetData())
    variables = vtk_to_numpy(output.GetPointData().GetScalars()).reshape(len(points), -1)
    write_ply(request["out"], numpy.hstack([points, variables]) / scales, corners)
    return len(corners)


def main():
    vtkObject.GlobalWarningDisplayOff()  # quadrics that cannot be solved are usual, and VTK goes on without
    rows = triangles = None
    for line in sys.stdin:
        try:
            request = json.loads(line)
            if "open" in request:
                rows, triangles = read_ply(request["open"])
                answer = vtkVersion.GetVTKVersion()
            else:
                answer = decimate(rows, triangles, request)
        except Exception as fault:  # whatever it is, the other side must hear of it
            answer = f"error {type(fault).__name__}: {fault}"
        print(answer, flush=True)


if __name__ == "__main__":
    main()
