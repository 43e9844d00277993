"""Times one decimation by VTK's vtkQuadricDecimation, attribute errors on; prints a measurement (cases.ts) as JSON:

    python3 vtk_run.py MESH.ply VARIABLE,... TRIANGLES
"""

import json
import os
import re
import sys
import time

import numpy

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "peers"))
from vtk_decimate import prepared_decimation, read_ply  # noqa: E402
from vtkmodules.vtkCommonCore import vtkObject  # noqa: E402

# Of position and of the variables; the same stand in cases.ts.
POSITION_BOUND, VARIABLE_BOUND = 0.01, 0.03


def chosen(path, variables):
    """x, y, z and those variables, one row a vertex, and the triangles."""
    rows, triangles = read_ply(path)
    header = open(path, "rb").read(4096).split(b"end_header")[0].decode()
    names = re.findall(r"property float (\S+)", header)
    return rows[:, [0, 1, 2, *(names.index(name) for name in variables)]], triangles


def main(path, variables, target):
    vtkObject.GlobalWarningDisplayOff()
    rows, triangles = chosen(path, [name for name in variables.split(",") if name])
    ranges = numpy.ptp(rows, axis=0)
    size = float(numpy.linalg.norm(ranges[:3]))
    # An error of one bound weighs the same in every variable; a constant one weighs nothing.
    shares = [POSITION_BOUND / (VARIABLE_BOUND * extent) if extent > 0 else 0 for extent in ranges[3:]]
    request = {"scales": [1 / size, *shares], "triangles": int(target), "volume": False}
    decimation, _ = prepared_decimation(rows, triangles, request)
    wall, cpu = time.perf_counter(), time.process_time()
    decimation.Update()
    print(
        json.dumps(
            {
                "wall": time.perf_counter() - wall,
                "cpu": time.process_time() - cpu,
                "triangles": len(triangles),
                "left": decimation.GetOutput().GetNumberOfPolys(),
                "peakBytes": 0,
            }
        )
    )


main(*sys.argv[1:])
