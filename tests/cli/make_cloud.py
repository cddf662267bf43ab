"""Writes one heap of cloud twice: as an OpenVDB file by Debian's python3-openvdb, and as plain text.

make_cloud.py FILE.vdb FILE.txt
Exit code 77: the library is missing.
"""

import math
import sys

try:
    import pyopenvdb as vdb
except ImportError:
    sys.exit(77)

SIDE = 0.05  # km
EXTINCTION = 50.0  # 1/km, of density 1
COUNT = (24, 12, 20)  # toward the file's x, y (up) and z (south)
LOWEST = 20  # index of the lowest level


def density(i, j, k):
    x, y, z = (2.0 * (n + 0.5) / count - 1.0 for n, count in zip((i, j, k), COUNT))
    lumps = 0.3 * math.sin(7.0 * x) * math.cos(9.0 * z + 2.0 * y)
    return min(max(2.0 * (1.0 - math.sqrt(x * x + y * y + z * z)) + lumps, 0.0), 1.0)


grid = vdb.FloatGrid()
grid.name = "density"
grid.gridClass = vdb.GridClass.FOG_VOLUME
grid.transform = vdb.createLinearTransform(voxelSize=1000.0 * SIDE)
accessor = grid.getAccessor()
for i in range(COUNT[0]):
    for j in range(COUNT[1]):
        for k in range(COUNT[2]):
            accessor.setValueOn((i, j + LOWEST, k), density(i, j, k))
mask = vdb.BoolGrid()
mask.name = "mask"
vdb.write(sys.argv[1], grids=[mask, grid])

with open(sys.argv[2], "w", encoding="utf-8") as out:
    out.write(f"{COUNT[0]} {COUNT[2]} {COUNT[1]}\n{SIDE} {SIDE}\n")
    out.write(" ".join(repr(SIDE * (LOWEST + j)) for j in range(COUNT[1])) + "\ni j k lwc reff\n")
    for i in range(COUNT[0]):
        for j in range(COUNT[1]):
            for k in range(COUNT[2]):
                value = accessor.getValue((i, j + LOWEST, k))
                if value > 0.0:
                    out.write(f"{i + 1} {COUNT[2] - k} {j + 1} {value * EXTINCTION * 10 / 1500!r} 10\n")
