"""Reads a picture by programs that are not airlight's, and compares it with an array of floats.

read_picture.py hdr FILE.hdr SKY.npy      by OpenImageIO: each sample within half a step of the shared exponent
read_picture.py texture FILE SKY.npy      KTX 2.0 and DDS by this reader, which follows their specifications; the texel
                                          in each direction is the stack's pixel there, in half floats, and each mip
                                          has its face's mean
read_picture.py usd FILE.usda LIGHT       the stage's dome and lights against what --irradiance tells of the sky
                                          (LIGHT.json, LIGHT.exr), of a camera that looks 30 degrees east
                                          of north
read_picture.py usd-samples FILE.usda LIGHT...   a sequence's stage, a LIGHT.json for each time sample: sun and moon
read_picture.py json FILE.json SKY.npy    the array of a JSON text
read_picture.py rad FILE.rad LIGHT        Radiance's scene: what its sources give a level surface against what
                                          --irradiance tells, and where its picture is brightest
read_picture.py matrix FILE.mtx FACTOR LIGHT...   a sky matrix column by column, likewise
read_picture.py compass FILE.npy          the preset `compass` with its middle in the north: the colour that is strongest
                                          in each ball
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


def usd_samples(file, *lights):
    """Each sample is where and what --irradiance tells; angles go on without a jump; the pictures are there."""
    text = open(file, encoding="utf-8").read()
    prims = dict(re.findall(r'def \w+ "(\w+)"\s*\{((?:[^{}]|\{[^{}]*\})*)\}', text.split('"sky"\n{', 1)[1]))

    def samples(prim, name):
        body = re.search(rf"{re.escape(name)}\.timeSamples = \{{([^}}]*)\}}", prims[prim]).group(1)
        return [(int(at), value.rstrip(",")) for at, value in re.findall(r"(\d+): (.*)", body)]

    def vector(value):
        return numpy.array([float(n) for n in value.strip("()").split(",")])

    codes = list(range(1, len(lights) + 1))
    assert f"startTimeCode = 1\n" in text and f"endTimeCode = {len(lights)}\n" in text
    assert "timeCodesPerSecond = 30\n" in text and "framesPerSecond = 30\n" in text
    pictures = samples("dome", "inputs:texture:file")
    assert [code for code, _ in pictures] == codes
    for _, picture in pictures:
        assert os.path.exists(os.path.join(os.path.dirname(file), picture.strip("@"))), picture
    assert len({picture for _, picture in pictures}) == len(lights)
    for body in ("sun", "moon"):
        turns = samples(body, "xformOp:rotateXYZ")
        assert [code for code, _ in turns] == codes
        angles = numpy.array([vector(value)[1] for _, value in turns])
        print(body, angles)
        assert abs(numpy.diff(angles)).max() < 180
        for i, light in enumerate(lights):
            told = json.load(open(light + ".json", encoding="utf-8"))[body]
            numpy.testing.assert_allclose(turned(vector(turns[i][1]), numpy.array([0, 0, 1.0])), told["direction"],
                                          atol=1e-5)
            found = vector(samples(body, "inputs:intensity")[i][1]) * vector(samples(body, "inputs:color")[i][1])
            numpy.testing.assert_allclose(found, numpy.maximum(told["irradiance"], 0), rtol=1e-5, atol=1e-12)


def json_array(file, array):
    told = json.load(open(file, encoding="utf-8"))
    wanted = numpy.load(array)
    found = numpy.array(told["pixels"], numpy.float32)
    assert (told["height"], told["width"], len(told["channels"])) == wanted.shape == found.shape
    assert (found == wanted).all()


RADIANCE_LUMINANCE = 179 * numpy.array([0.265, 0.670, 0.065])


def told_by(light):
    """Lux on a level surface by sky and by sun, and the sun's direction with z up, as --irradiance tells them."""
    with open(light + ".json") as stream:
        told = json.load(stream)
    weights = numpy.array([0.2126, 0.7152, 0.0722])
    sun = told["sun"]
    x, y, z = sun["direction"]
    sky = read(light + ".exr")[1][0, :, :3].mean(axis=0)  # normals 2.8 degrees from straight up
    return sky @ weights, numpy.array(sun["irradiance"]) @ weights, numpy.array([x, -z, y])


# CIE 1924 photopic luminous efficiency every 20 nm.
VISION = numpy.array([[380, 0.0000390], [400, 0.000396], [420, 0.00400], [440, 0.0230], [460, 0.0600], [480, 0.13902],
                      [500, 0.3230], [520, 0.7100], [540, 0.9540], [560, 0.9950], [580, 0.8700], [600, 0.6310],
                      [620, 0.3810], [640, 0.1750], [660, 0.0610], [680, 0.0170], [700, 0.004102], [720, 0.001047],
                      [740, 0.000249], [760, 0.0000600], [780, 0.0000150]])


def hyperspectral(file):
    """Wavelengths and values, the picture from the top, by the description of Radiance's format."""
    with open(file, "rb") as stream:
        data = stream.read()
    head, rest = data.split(b"\n\n", 1)
    size, pixels = rest.split(b"\n", 1)
    lines = head.decode().split("\n")
    assert lines[0] == "#?RADIANCE" and lines[-1] == "FORMAT=Radiance_spectra"
    count = int(dict(line.split("=") for line in lines[1:])["NCOMP"])
    splits = [float(word) for word in dict(line.split("=") for line in lines[1:])["WAVELENGTH_SPLITS"].split()]
    assert splits == sorted(splits) and splits[1:3] == [480, 588]
    y, height, x, width = size.decode().split()
    assert (y, x) == ("-Y", "+X")
    bytes_ = numpy.frombuffer(pixels, numpy.uint8).reshape(int(height), int(width), count + 1).astype(float)
    values = (bytes_[..., :-1] + 0.5) * 2.0 ** (bytes_[..., -1:] - 128 - 8)
    step = (splits[3] - splits[0]) / count
    return splits[0] + step * (numpy.arange(count) + 0.5), values


def rad(file, light):
    with open(file) as stream:
        lines = [line for line in stream.read().split("\n") if not line.startswith("#")]
    words = re.findall(r'"[^"]*"|\S+', " ".join(lines))
    things = {}
    while words:  # modifier type name, then three lists that begin with their lengths
        modifier, kind, name = words[:3]
        words = words[3:]
        lists = []
        for _ in range(3):
            count = int(words[0])
            lists.append([word.strip('"') for word in words[1:1 + count]])
            words = words[1 + count:]
        things[name] = (modifier, kind, lists)
    modifier, kind, (_, _, place) = things["sky"]
    assert (kind, [float(v) for v in place]) == ("source", [0, 0, 1, 360])
    glow = things[modifier]
    assert glow[1] == "glow" and glow[2][2] == ["1", "1", "1", "0"]
    _, kind, (picture, _, _) = things[glow[0]]
    spectral = kind == "specpict"
    if spectral:
        assert picture[0] == "noop" and picture[2] == "."
        nm, values = hyperspectral(os.path.join(os.path.dirname(file), picture[1]))
        # Lux: 683 lm/W times V, which a lookup by 5 nm steps gives; values are W/(m2 sr nm) times the whole width.
        weights = 683 * numpy.interp(nm, VISION[:, 0], VISION[:, 1]) / len(nm)
        sky = values @ weights
    else:
        assert kind == "colorpict" and picture[:3] == ["red", "green", "blue"] and picture[4] == "."
        sky = read(os.path.join(os.path.dirname(file), picture[3]))[1] @ RADIANCE_LUMINANCE
    height, width = sky.shape
    # Where Radiance looks into the picture: from its lower left corner, its height as unit.
    names = {"atan2": numpy.arctan2, "Acos": numpy.arccos, "PI": numpy.pi}
    elevation = numpy.radians(numpy.arange(-89.75, 90, 0.5))[:, None]
    azimuth = numpy.radians(numpy.arange(0.25, 360, 0.5))[None, :]
    names["Dx"], names["Dy"] = numpy.cos(elevation) * numpy.sin(azimuth), numpy.cos(elevation) * numpy.cos(azimuth)
    names["Dz"] = numpy.sin(elevation) + 0 * azimuth
    u, v = (eval(word, names) for word in picture[-2:])
    seen = sky[(height - 1 - (v * height).astype(int)).clip(0, height - 1), (u * height).astype(int).clip(0, width - 1)]
    by_sky = (seen * numpy.maximum(0, names["Dz"]) * numpy.cos(elevation)).sum() * numpy.radians(0.5) ** 2
    modifier, kind, (_, _, place) = things["sun"]
    x, y, z, angle = (float(word) for word in place)
    above, kind, (_, _, colour) = things[modifier]
    assert kind == "light"
    if spectral:
        assert colour == ["1", "1", "1"] and things[above][1] == "spectrum"
        span, colour = things[above][2][2][:2], things[above][2][2][2:]
        numpy.testing.assert_allclose([float(word) for word in span], [nm[0] - 10, nm[-1] + 10])
    colour = numpy.array([float(word) for word in colour]) @ (weights if spectral else RADIANCE_LUMINANCE)
    by_sun = colour * 2 * numpy.pi * (1 - numpy.cos(numpy.radians(angle / 2)))
    wanted_sky, wanted_sun, toward = told_by(light)
    print("sky", by_sky / wanted_sky, "sun", by_sun / wanted_sun)
    # Bands of 20 nm sample V coarsely.
    assert abs(by_sky / wanted_sky - 1) < (0.015 if spectral else 0.01)
    assert abs(by_sun / wanted_sun - 1) < (0.01 if spectral else 0.005)
    numpy.testing.assert_allclose([x, y, z], toward, atol=1e-6)
    row, column = numpy.unravel_index(seen.argmax(), seen.shape)
    brightest = numpy.array([names[name][row, column] for name in ("Dx", "Dy")])
    level = numpy.array(toward[:2]) / numpy.hypot(*toward[:2])
    assert brightest @ level > numpy.cos(numpy.radians(8)) * numpy.hypot(*brightest), (brightest, toward)


def matrix(file, factor, *lights):
    factor = int(factor)
    with open(file) as stream:
        head, body = stream.read().split("\n\n", 1)
    head = dict(line.split("=") for line in head.split("\n") if "=" in line)
    rows, columns = int(head["NROWS"]), int(head["NCOLS"])
    assert (head["NCOMP"], head["FORMAT"], columns) == ("3", "ascii", len(lights))
    blocks = body.rstrip("\n").split("\n\n")
    values = numpy.array([[line.split() for line in block.split("\n")] for block in blocks], float)
    assert values.shape == (rows, columns, 3)
    # Reinhart's patches: elevation and azimuth of the middle, and the solid angle.
    step = numpy.pi / 2 / (7 * factor + 0.5)
    patches = [(numpy.nan, 0, 0)]
    for i in range(7 * factor):
        around = [30, 30, 24, 24, 18, 12, 6][i // factor] * factor
        solid = 2 * numpy.pi * (numpy.sin(step * (i + 1)) - numpy.sin(step * i)) / around
        patches += [(step * (i + 0.5), 2 * numpy.pi * j / around, solid) for j in range(around)]
    patches.append((numpy.pi / 2, 0, 2 * numpy.pi * (1 - numpy.cos(step / 2))))
    elevation, azimuth, solid = numpy.array(patches).T
    assert len(patches) == rows and abs(solid.sum() - 2 * numpy.pi) < 1e-9
    luminance = values @ RADIANCE_LUMINANCE
    for column, light in enumerate(lights):
        if light == "dark":
            assert (values[:, column] == 0).all()
            continue
        sky, sun, toward = told_by(light)
        level = (luminance[1:, column] * solid[1:] * numpy.sin(elevation[1:])).sum()
        wanted = sky + sun * toward[2]
        print(light, level / wanted)
        assert abs(level / wanted - 1) < 0.03
        at = luminance[1:, column].argmax() + 1
        middle = [numpy.cos(elevation[at]) * numpy.sin(azimuth[at]), numpy.cos(elevation[at]) * numpy.cos(azimuth[at]),
                  numpy.sin(elevation[at])]
        assert middle @ toward > numpy.cos(step), (middle, toward)
        assert luminance[0, column] > 0


def compass(file):
    picture = numpy.load(file)
    height, width, _ = picture.shape
    strongest = {"north": (0, 0), "east": (1, 0.25), "south": (2, 0.5)}
    for name, (channel, turn) in strongest.items():
        ball = picture[int(height * (0.5 - 8 / 180)), int(width * (0.5 + turn)) % width]
        print(name, ball)
        assert ball.argmax() == channel and ball[channel] > 2 * numpy.median(ball)
    west = picture[int(height * (0.5 - 8 / 180)), width // 4]
    assert west[:2].min() > 4 * west[2]
    up = picture[0].mean(axis=0)  # white, where the sky around it is blue
    print("up", up, picture[height // 6].mean(axis=0))
    assert up[2] / up[0] < 0.7 * picture[height // 6].mean(axis=0)[2] / picture[height // 6].mean(axis=0)[0]


{"hdr": hdr, "compass": compass, "texture": texture, "usd": usd, "usd-samples": usd_samples, "json": json_array, "rad": rad, "matrix": matrix}[sys.argv[1]](*sys.argv[2:])
