"""Reads a picture by programs that are not airlight's, and compares it with an array of floats.

read_picture.py hdr FILE.hdr SKY.npy      by OpenImageIO: each sample within half a step of the shared exponent
read_picture.py texture FILE SKY.npy      KTX 2.0 and DDS by this reader, which follows their specifications; the texel
                                          in each direction is the stack's pixel there, in half floats, and each mip
                                          has its face's mean
read_picture.py usd FILE.usda LIGHT       the stage's dome and lights against what --irradiance tells of the sky
                                          (LIGHT.json, LIGHT.exr), of a camera that looks 30 degrees east
                                          of north
Exit code 1: they differ; 77: a library is missing.
"""

import json
import os
import re
import struct
import sys

try:
    import numpy
    import OpenImageIO as oiio
except ImportError as error:
    print(error)
    sys.exit(77)


def read(file):
    picture = oiio.ImageInput.open(file)
    assert picture, oiio.geterror()
    return picture.spec(), picture.read_image("float")


def hdr(file, array):
    spec, found = read(file)
    wanted = numpy.maximum(numpy.load(array), 0)  # a negative channel is stored as 0
    assert (spec.height, spec.width, spec.nchannels) == wanted.shape
    fraction, exponent = numpy.frexp(wanted.max(axis=2))
    step = 2.0 ** (exponent + (fraction * 256 >= 255.5) - 8)
    off = (abs(found - wanted) / step[:, :, None]).max()
    print("largest difference", off, "steps")
    assert off <= 0.5
    # OpenImageIO adds what the header lacks; the header itself has no more than the format.
    with open(file, "rb") as stream:
        head = stream.read(200).split(b"\n")
    assert head[:3] == [b"#?RADIANCE", b"FORMAT=32-bit_rle_rgbe", b""], head


def ktx2(data):
    assert data[:12] == b"\xabKTX 20\xbb\r\n\x1a\n"
    form, type_size, width, height, depth, layers, faces, levels, scheme = struct.unpack_from("<9I", data, 12)
    assert (form, type_size, depth, layers, faces, scheme) == (97, 2, 0, 0, 6, 0) and width == height
    dfd, dfd_bytes, kvd, kvd_bytes, sgd, sgd_bytes = struct.unpack_from("<4I2Q", data, 48)
    assert dfd == 80 + 24 * levels and kvd == dfd + dfd_bytes and (sgd, sgd_bytes) == (0, 0)
    total, vendor, version, model = struct.unpack_from("<3IB", data, dfd)
    assert (total, vendor, version, model) == (dfd_bytes, 0, 2 | (dfd_bytes - 4) << 16, 1)
    assert data[kvd + 4:kvd + 22] == b"KTXorientation\0rd\0"
    out = []
    for level in range(levels):
        offset, size, raw = struct.unpack_from("<3Q", data, 80 + 24 * level)
        side = max(1, width >> level)
        assert size == raw == 6 * side * side * 8 and offset % 8 == 0
        out.append(numpy.frombuffer(data, "<f2", size // 2, offset).reshape(6, side, side, 4))
    assert len(data) == struct.unpack_from("<Q", data, 80)[0] + out[0].nbytes  # the largest level is the last
    return out


def dds(data):
    size, flags, height, width, pitch, depth, levels = struct.unpack_from("<7I", data, 4)
    assert data[:4] == b"DDS " and size == 124 and data[84:88] == b"DX10" and width == height
    form, dimension, misc, count = struct.unpack_from("<4I", data, 128)
    assert (form, dimension, misc, count) == (10, 3, 4, 1) and struct.unpack_from("<I", data, 112)[0] == 0xFE00
    sides = [max(1, width >> level) for level in range(levels)]
    values = numpy.frombuffer(data, "<f2", offset=148)
    out = [numpy.empty((6, side, side, 4), "<f2") for side in sides]
    place = 0
    for face in range(6):
        for level, side in enumerate(sides):
            out[level][face] = values[place:place + 4 * side * side].reshape(side, side, 4)
            place += 4 * side * side
    assert place == values.size
    return out


def texel(direction, side):
    """Face, row and column that a sampler looks a direction up in: OpenGL 4.6, table 8.19; Direct3D's is the same."""
    x, y, z = direction
    axis = int(numpy.argmax(numpy.abs(direction)))
    most = abs(direction[axis])
    face = 2 * axis + (direction[axis] < 0)
    s, t = [(-z, -y), (z, -y), (x, z), (x, -z), (x, -y), (-x, -y)][face]
    return face, int((t / most + 1) / 2 * side), int((s / most + 1) / 2 * side)


def stack_direction(face, u, v):
    """OpenEXR's faces (ImfEnvmap.cpp, CubeMap::direction), of a camera that looks north, as east, up, south.

    OpenEXR's +z is then north and its +x west."""
    x, y, z = [(1, -v, u), (-1, -v, -u), (u, 1, -v), (u, -1, v), (-u, -v, 1), (u, -v, -1)][face]
    return numpy.array([-x, y, -z], float)


def texture(file, array):
    with open(file, "rb") as stream:
        data = stream.read()
    levels = ktx2(data) if file.endswith(".ktx2") else dds(data)
    stack = numpy.load(array)
    side = stack.shape[1]
    assert len(levels) == side.bit_length()
    for row in range(6 * side):
        for column in range(side):
            u, v = (2 * (i + 0.5) / side - 1 for i in (column, row % side))
            at = texel(stack_direction(row // side, u, v), side)
            assert (levels[0][at][:3] == stack[row, column].astype("<f2")).all(), (row, column, at)
    for level in levels[1:]:
        mean = level.astype(float).mean(axis=(1, 2))
        numpy.testing.assert_allclose(mean, levels[0].astype(float).mean(axis=(1, 2)), rtol=2e-3, atol=1e-7)
    assert (levels[0][..., 3] == 1).all()


def turned(rotation, vector):
    """USD's rotateXYZ, degrees: about x, then y, then z."""
    for axis, degrees in enumerate(rotation):
        c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
        a, b = [(1, 2), (2, 0), (0, 1)][axis]
        vector = vector.copy()
        vector[a], vector[b] = c * vector[a] - s * vector[b], s * vector[a] + c * vector[b]
    return vector


AZIMUTH = 30


def usd(file, light):
    text = open(file, encoding="utf-8").read()
    sky = json.load(open(light + ".json", encoding="utf-8"))
    told = read(light + ".exr")[1]
    prims = {name: (kind, body) for kind, name, body in re.findall(r'def (\w+) "(\w+)"\s*\{([^{}]*)\}', text)}
    assert prims["dome"][0] == "DomeLight" and prims["sun"][0] == "DistantLight"

    def value(prim, name):
        found = re.search(rf"{re.escape(name)} = (.*)", prims[prim][1]).group(1)
        return numpy.array([float(n) for n in found.strip("()").split(",")])

    whole = numpy.array([90.0 if 'upAxis = "Z"' in text else 0.0, 0, 0])
    assert ("xformOp:rotateX = 90" in text.split("def DomeLight")[0]) == (whole[0] == 90)
    to_sun = turned(whole, turned(value("sun", "xformOp:rotateXYZ"), numpy.array([0, 0, 1.0])))
    east, up, south = sky["sun"]["direction"]
    numpy.testing.assert_allclose(to_sun, [east, up, south] if whole[0] == 0 else [east, -south, up], atol=1e-5)
    irradiance = value("sun", "inputs:intensity") * value("sun", "inputs:color")
    numpy.testing.assert_allclose(irradiance, numpy.maximum(sky["sun"]["irradiance"], 0), rtol=1e-5)
    assert "bool inputs:normalize = 1" in prims["sun"][1]

    # The dome as a renderer sees it: OpenEXR's latlong, turned. A white card toward each normal gets what --irradiance
    # says.
    name = re.search(r"inputs:texture:file = @(.*)@", text).group(1)
    spec, dome = read(os.path.join(os.path.dirname(file), name))
    height, width = dome.shape[:2]
    assert width == 2 * height
    latitude = numpy.pi * (0.5 - (numpy.arange(height) + 0.5) / height)
    longitude = numpy.pi * (1 - 2 * (numpy.arange(width) + 0.5) / width)
    lat, lon = numpy.meshgrid(latitude, longitude, indexing="ij")
    unturned = numpy.stack([numpy.sin(lon) * numpy.cos(lat), numpy.sin(lat), numpy.cos(lon) * numpy.cos(lat)])
    directions = turned([0, value("dome", "xformOp:rotateY")[0], 0], unturned)
    weight = numpy.cos(lat) * (numpy.pi / height) ** 2
    for row, column in [(0, 0), (3, 10), (8, 32), (10, 50), (15, 20), (20, 60)]:
        elevation = numpy.pi * (0.5 - (row + 0.5) / 32)
        azimuth = numpy.radians(AZIMUTH) + numpy.pi * (2 * (column + 0.5) / 64 - 1)
        normal = [numpy.cos(elevation) * numpy.sin(azimuth), numpy.sin(elevation),
                  -numpy.cos(elevation) * numpy.cos(azimuth)]
        cosine = numpy.maximum(0, numpy.tensordot(normal, directions, 1))
        seen = (dome[..., :3] * (weight * cosine)[..., None]).sum(axis=(0, 1))
        print(normal, seen / told[row, column, :3])
        numpy.testing.assert_allclose(seen, told[row, column, :3], rtol=0.01)


{"hdr": hdr, "texture": texture, "usd": usd}[sys.argv[1]](*sys.argv[2:])
