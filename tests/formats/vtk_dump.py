"""VTK's readers and writers, for vtk-reads.test.ts: vtk_dump.py FILES FOLDER DRAWN

Reads every file in FILES, writes a surface to FOLDER in all the ways that VTK has, and one in colours to DRAWN in the
formats made for drawing, reads these back as well, and prints {"read": {file: surface}, "original": surface,
"written": {file: surface}, "drawn": {file: surface}} in JSON. Values are their bytes in hexadecimal, little-endian.
"""

import json
import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkGLTFWriter, vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

READERS = {
    "vtp": vtkXMLPolyDataReader,
    "vtk": vtkPolyDataReader,
    "ply": vtkPLYReader,
    "obj": vtkOBJReader,
    "stl": vtkSTLReader,
    "glb": vtkGLTFReader,
    "ltf": vtkGLTFReader,
}


def read(path):
    reader = READERS[path[-3:]]()
    if path.endswith("vtk"):
        reader.ReadAllFieldsOn()
    reader.SetFileName(path)
    reader.Update()
    output = reader.GetOutput()
    while not output.IsA("vtkPolyData"):  # of a scene, the first node and its first primitive
        output = output.GetBlock(0)
    return output


def dump_array(array):
    values = vtk_to_numpy(array)
    unit = array.GetInformation().Get(vtkDataArray.UNITS_LABEL())
    names = [array.GetComponentName(component) for component in range(array.GetNumberOfComponents())]
    return {
        "name": array.GetName(),
        "type": str(values.dtype),
        "components": array.GetNumberOfComponents(),
        "bytes": values.astype(values.dtype.newbyteorder("<")).tobytes().hex(),
        "unit": unit,
        "componentNames": names if any(names) else None,
    }


def dump(surface):
    kinds = {"verts": surface.GetVerts(), "lines": surface.GetLines(), "strips": surface.GetStrips()}
    polygons = surface.GetPolys()
    attributes = surface.GetPointData()
    return {
        "points": dump_array(surface.GetPoints().GetData()),
        "corners": vtk_to_numpy(polygons.GetConnectivityArray()).tolist(),
        "offsets": vtk_to_numpy(polygons.GetOffsetsArray()).tolist(),
        "others": {kind: cells.GetNumberOfCells() for kind, cells in kinds.items() if cells.GetNumberOfCells()},
        "active": {
            kind: getattr(attributes, f"Get{kind}")().GetName()
            for kind in ("Normals", "TCoords", "GlobalIds", "PedigreeIds", "Scalars")
            if getattr(attributes, f"Get{kind}")()
        },
        "arrays": [dump_array(attributes.GetArray(index)) for index in range(attributes.GetNumberOfArrays())],
    }


def surface_to_write():
    """A pyramid without its floor; among its numbers are those that text or a narrower type spoils."""
    points = vtkPoints()
    corners = [(0, 0, 0), (1 / 3, 0, 0), (1, 0.7, -0.0), (0, 1, 0.1), (0.5, 0.5, 1)]
    points.SetData(numpy_to_vtk(numpy.float32(corners), deep=True))
    triangles = vtkCellArray()
    for triangle in [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]:
        triangles.InsertNextCell(3, triangle)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    temperature = numpy_to_vtk(numpy.float64([0.1, 1 / 3, -0.0, 1 / 3e-300, 1e-300 / 3]), deep=True)
    temperature.SetName("temperature")
    temperature.GetInformation().Set(vtkDataArray.UNITS_LABEL(), "K")
    velocity = numpy_to_vtk(numpy.arange(15, dtype=numpy.float32).reshape(5, 3) / numpy.float32(7), deep=True)
    velocity.SetName("velocity")
    for component, name in enumerate("uvw"):
        velocity.SetComponentName(component, name)
    surface.GetPointData().SetScalars(temperature)
    surface.GetPointData().SetVectors(velocity)
    return surface


def write_vtp(folder, surface, mode, encode, compressor, header, order):
    encoding = {True: "-base64", False: "-raw"}[encode] if mode == "Appended" else ""
    writer = vtkXMLPolyDataWriter()
    getattr(writer, f"SetDataModeTo{mode}")()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    getattr(writer, f"SetByteOrderTo{order}Endian")()
    writer.SetHeaderType(writer.UInt64 if header == 64 else writer.UInt32)
    writer.SetEncodeAppendedData(encode)
    if compressor != "None":
        writer.SetBlockSize(32)  # several blocks an array, and the last not full
    name = f"{mode}{encoding}-{compressor}-{header}-{order}.vtp".lower()
    write(writer, surface, os.path.join(folder, name))


def write_legacy(folder, surface, version, binary):
    writer = vtkPolyDataWriter()
    writer.SetFileVersion(version)
    writer.SetFileType(2 if binary else 1)
    write(writer, surface, os.path.join(folder, f"legacy-{version}-{'binary' if binary else 'ascii'}.vtk"))


def write(writer, surface, path):
    writer.SetInputData(surface)
    writer.SetFileName(path)
    if not writer.Write():
        sys.exit(f"VTK did not write {path}")


def write_variants(folder, surface):
    for header in 32, 64:
        for order in "Little", "Big":
            write_vtp(folder, surface, "Ascii", False, "None", header, order)
            for compressor in "None", "ZLib":
                write_vtp(folder, surface, "Binary", False, compressor, header, order)
                for encode in False, True:
                    write_vtp(folder, surface, "Appended", encode, compressor, header, order)
    for version in 42, 51:
        for binary in False, True:
            write_legacy(folder, surface, version, binary)


def surface_to_draw():
    surface = vtkPolyData()
    surface.ShallowCopy(surface_to_write())
    attributes = surface.GetPointData()
    attributes.Initialize()
    normals = numpy_to_vtk(numpy.float32([(0, 0, 1), (0, 1, 0), (1, 0, 0), (0, 0.6, 0.8), (0, 0, -1)]), deep=True)
    normals.SetName("Normals")
    attributes.SetNormals(normals)
    places = numpy_to_vtk(numpy.arange(10, dtype=numpy.float32).reshape(5, 2) / numpy.float32(10), deep=True)
    places.SetName("TCoords")
    attributes.SetTCoords(places)
    colours = numpy_to_vtk(numpy.arange(15, dtype=numpy.uint8).reshape(5, 3) * 17, deep=True)
    colours.SetName("RGB")
    attributes.SetScalars(colours)
    return surface


def write_drawn(folder, surface):
    for name, kind, order in ("ascii", 1, "Little"), ("little-endian", 2, "Little"), ("big-endian", 2, "Big"):
        writer = vtkPLYWriter()
        writer.SetFileType(kind)
        getattr(writer, f"SetDataByteOrderTo{order}Endian")()
        writer.SetArrayName("RGB")
        write(writer, surface, os.path.join(folder, f"{name}.ply"))
    for name, kind in ("ascii", 1), ("binary", 2):
        writer = vtkSTLWriter()
        writer.SetFileType(kind)
        write(writer, surface, os.path.join(folder, f"{name}.stl"))
    write(vtkOBJWriter(), surface, os.path.join(folder, "drawn.obj"))
    scene, building = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    building.SetBlock(0, surface)
    scene.SetBlock(0, building)
    writer = vtkGLTFWriter()
    writer.InlineDataOn()
    write(writer, scene, os.path.join(folder, "drawn.gltf"))


def dump_all(folder):
    return {name: dump(read(os.path.join(folder, name))) for name in sorted(os.listdir(folder))}


def main():
    files, folder, drawn = sys.argv[1:]
    surface = surface_to_write()
    write_variants(folder, surface)
    write_drawn(drawn, surface_to_draw())
    surfaces = {"read": dump_all(files), "original": dump(surface)}
    print(json.dumps({**surfaces, "written": dump_all(folder), "drawn": dump_all(drawn)}))


main()
