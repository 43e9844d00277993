"""Makes the large surfaces of the benchmark: make_meshes.py VOLUME.json VOLUME.raw FOLDER NAME=FACTOR...

The volume is what web/samples' simulator writes: its JSON line and its numbers. It is interpolated (Catmull-Rom) on a grid
FACTOR times finer, and the surface of the density taken from that by vtkFlyingEdges3D; FOLDER/NAME.ply gets it with all
variables. Simulating at that size would take days; what the fields are like between the cells matters little to the time.
"""

import json
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

ISOVALUE = 0.45  # of the density, as in web/samples/catalogue.ts
FACE = numpy.dtype([("count", "u1"), ("corners", "<u4", 3)])
CHUNK = 200_000  # points interpolated at a time, so that memory stays small


def weights(t):
    """The four weights of Catmull and Rom between the second value (t = 0) and the third (t = 1)."""
    return 0.5 * numpy.stack(
        [-t + 2 * t**2 - t**3, 2 - 5 * t**2 + 3 * t**3, t + 4 * t**2 - 3 * t**3, -(t**2) + t**3], axis=-1
    )


def taps(places, count):
    """For each place along an axis of so many values the four values that it is made of, and their weights."""
    first = numpy.clip(numpy.floor(places).astype(int), 0, count - 2)
    return numpy.clip(first[:, None] + numpy.arange(-1, 3), 0, count - 1), weights(places - first)


def refined(values, factor):
    """A volume (z, y, x) on a grid `factor` times finer."""
    for axis in range(3):
        count = values.shape[axis]
        places = numpy.linspace(0, count - 1, round((count - 1) * factor) + 1)
        indices, shares = taps(places, count)
        shape = [1, 1, 1]
        shape[axis] = -1
        values = sum(
            numpy.take(values, indices[:, tap], axis) * shares[:, tap].astype("f4").reshape(shape) for tap in range(4)
        )
    return values


def contour(values):
    """Points in cells of the given volume (x, y, z), and triangles."""
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel()))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, ISOVALUE)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    surface = edges.GetOutput()
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float), triangles


def sampled(volume, points):
    """The values of a volume (z, y, x) at points given in its cells (x, y, z)."""
    result = numpy.empty(len(points), "f4")
    for start in range(0, len(points), CHUNK):
        part = points[start : start + CHUNK]
        axes = [taps(part[:, 2 - axis], volume.shape[axis]) for axis in range(3)]
        (z, wz), (y, wy), (x, wx) = axes
        near = volume[z[:, :, None, None], y[:, None, :, None], x[:, None, None, :]]
        result[start : start + CHUNK] = numpy.einsum("nzyx,nz,ny,nx->n", near, wz, wy, wx)
    return result


def without_point_edges(position, triangles):
    """Merges the ends of edges that have no length; the vertices that remain, and the triangles of these.

    Where the surface passes by a point of the grid, vertices about it become one when they are rounded. VTK with attribute
    errors stops early on a surface with such an edge: compared would be the work with its beginning.
    """
    edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    merged = numpy.arange(len(position))
    for pair in edges[(position[edges[:, 0]] == position[edges[:, 1]]).all(axis=1)]:
        first, second = sorted(merged[pair])
        merged[merged == second] = first
    triangles = merged[triangles]
    triangles = triangles[(triangles != numpy.roll(triangles, 1, axis=1)).all(axis=1)]
    remaining, triangles = numpy.unique(triangles, return_inverse=True)
    return remaining, triangles.reshape(-1, 3)


def write_ply(path, names, columns, triangles):
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(columns[0])}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(triangles)}", "property list uchar uint vertex_indices", "end_header\n"]
    faces = numpy.empty(len(triangles), FACE)
    faces["count"], faces["corners"] = 3, triangles
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        numpy.stack(columns, axis=1).astype("<f4").tofile(file)
        faces.tofile(file)


def main(description, numbers, folder, *wanted):
    about = json.load(open(description))
    names = [variable["name"] for variable in about["variables"]]
    shape = about["cells"][::-1]
    volumes = dict(zip(names, numpy.fromfile(numbers, "<f4").reshape(len(names), *shape)))
    for name, factor in (one.split("=") for one in wanted):
        fine = refined(volumes["density"], float(factor))
        points, triangles = contour(fine)
        finer = [(fine.shape[2 - axis] - 1) / (shape[2 - axis] - 1) for axis in range(3)]
        points /= finer
        position = (points * about["spacing"] + about["origin"]).astype("f4")
        remaining, triangles = without_point_edges(position, triangles)
        points, position = points[remaining], position[remaining]
        carried = [key for key in names if key in ("density", "pressure", "vx", "vy", "vz", "energy", "temperature")]
        columns = [*position.T, *(sampled(volumes[key], points) for key in carried)]
        # Linear along the edges of the grid, as the surface is: between them the cubic would add noise to a constant.
        columns[3 + carried.index("density")] = numpy.full(len(points), ISOVALUE)
        write_ply(f"{folder}/{name}.ply", ["x", "y", "z", *carried], columns, triangles)
        print(f"{name}: {len(triangles)} triangles", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
