"""Reads a spectral EXR by OpenImageIO and holds its colours to its spectrum.

spectral_exr.py FILE WHITE FIRST:LAST:STEP: the channels of a spectrum are found by the regular expression of the
layout's authors, radiance and sunlight are integrated with the standard observer's table below, and linear Rec.709 of
the sum, white being WHITE (sun or D65), is compared with R, G and B. Prints the largest difference of a channel as a
share of it, channels below a tenth of the pixel's largest left out, where the observer is averaged over each
wavelength's band; and as a share of the pixel's largest channel, where it is taken at the wavelength. Exit code 1: not
as the layout says; 77: there is no OpenImageIO for Python.
"""

import re
import sys

try:
    import numpy
    import OpenImageIO as oiio
except ImportError as error:
    print(error)
    sys.exit(77)

# CIE 1931, 2 degrees (ISO/CIE 11664-1), every 5 nm from 375 to 785.
X = [0.0007416, 0.001368, 0.002236, 0.004243, 0.00765, 0.01431, 0.02319, 0.04351, 0.07763, 0.13438, 0.21477, 0.2839,
     0.3285, 0.34828, 0.34806, 0.3362, 0.3187, 0.2908, 0.2511, 0.19536, 0.1421, 0.09564, 0.05795, 0.03201, 0.0147,
     0.0049, 0.0024, 0.0093, 0.0291, 0.06327, 0.1096, 0.1655, 0.22575, 0.2904, 0.3597, 0.43345, 0.51205, 0.5945,
     0.6784, 0.7621, 0.8425, 0.9163, 0.9786, 1.0263, 1.0567, 1.0622, 1.0456, 1.0026, 0.9384, 0.85445, 0.7514,
     0.6424, 0.5419, 0.4479, 0.3608, 0.2835, 0.2187, 0.1649, 0.1212, 0.0874, 0.0636, 0.04677, 0.0329, 0.0227,
     0.01584, 0.0113592, 0.00811092, 0.00579035, 0.00410946, 0.00289933, 0.00204919, 0.00143997, 0.000999949,
     0.000690079, 0.000476021, 0.000332301, 0.000234826, 0.000166151, 0.000117413, 8.30753e-05, 5.87065e-05,
     4.15099e-05, 2.93533e-05]
Y = [2.202e-05, 3.9e-05, 6.4e-05, 0.00012, 0.000217, 0.000396, 0.00064, 0.00121, 0.00218, 0.004, 0.0073, 0.0116,
     0.01684, 0.023, 0.0298, 0.038, 0.048, 0.06, 0.0739, 0.09098, 0.1126, 0.13902, 0.1693, 0.20802, 0.2586, 0.323,
     0.4073, 0.503, 0.6082, 0.71, 0.7932, 0.862, 0.91485, 0.954, 0.9803, 0.99495, 1, 0.995, 0.9786, 0.952, 0.9154,
     0.87, 0.8163, 0.757, 0.6949, 0.631, 0.5668, 0.503, 0.4412, 0.381, 0.321, 0.265, 0.217, 0.175, 0.1382, 0.107,
     0.0816, 0.061, 0.04458, 0.032, 0.0232, 0.017, 0.01192, 0.00821, 0.005723, 0.004102, 0.002929, 0.002091,
     0.001484, 0.001047, 0.00074, 0.00052, 0.0003611, 0.0002492, 0.0001719, 0.00012, 8.48e-05, 6e-05, 4.24e-05,
     3e-05, 2.12e-05, 1.499e-05, 1.06e-05]
Z = [0.003486, 0.00645, 0.01055, 0.02005, 0.03621, 0.06785, 0.1102, 0.2074, 0.3713, 0.6456, 1.03905, 1.3856, 1.62296,
     1.74706, 1.7826, 1.77211, 1.7441, 1.6692, 1.5281, 1.28764, 1.0419, 0.81295, 0.6162, 0.46518, 0.3533, 0.272,
     0.2123, 0.1582, 0.1117, 0.07825, 0.05725, 0.04216, 0.02984, 0.0203, 0.0134, 0.00875, 0.00575, 0.0039, 0.00275,
     0.0021, 0.0018, 0.00165, 0.0014, 0.0011, 0.001, 0.0008, 0.0006, 0.00034, 0.00024, 0.00019, 0.0001, 5e-05,
     3e-05, 2e-05, 1e-05, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]
# XYZ to linear Rec.709, IEC 61966-2-1.
REC709 = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]

CHANNEL = re.compile(r"^((S([0-3]))|(M([0-3])([0-3])))\.(\d*,?\d*([Ee][+-]?\d+)?)(Y|Z|E|P|T|G|M|k|h|da|d|c|m|u|n|p)?"
                     r"(m|Hz)$")


def require(condition, message):
    if not condition:
        print(message)
        sys.exit(1)


def text_of(spec, name):
    """A text that may stand in pieces of at most 255 bytes, NAME:000 and on."""
    text = spec.get_string_attribute(name)
    pieces = 0
    while spec.get_string_attribute(f"{name}:{pieces:03d}"):
        text += spec.get_string_attribute(f"{name}:{pieces:03d}")
        pieces += 1
    return text


def spectral_channels(names):
    """Wavelength in nm and place of each channel of S0, ascending."""
    found = []
    for place, name in enumerate(names):
        parts = CHANNEL.match(name)
        if parts:
            require(parts.group(3) == "0", f"{name}: not of Stokes' first component")
            require((parts.group(9), parts.group(10)) == ("n", "m"), f"{name}: not in nm")
            found.append((float(parts.group(7).replace(",", ".")), place))
        else:
            require(name in "RGBA", f"{name}: neither a colour nor a wavelength")
    return sorted(found)


def colours(radiance, sunlight, matching, white):
    """Linear Rec.709 of spectra: the sun's is (1, 1, 1), or has the luminance 1."""
    to_rgb = numpy.array(REC709) @ matching
    return radiance @ to_rgb.T / (to_rgb @ sunlight if white == "sun" else (matching @ sunlight)[1])


def main(path, white, wished):
    picture = oiio.ImageInput.open(path)
    require(picture is not None, oiio.geterror())
    spec = picture.spec()
    pixels = picture.read_image(oiio.FLOAT).astype(numpy.float64)
    require(spec.get_string_attribute("spectralLayoutVersion") == "1.0", "spectralLayoutVersion is not 1.0")
    require(spec.get_string_attribute("emissiveUnits") == "W.m^-2.sr^-1.nm^-1", "emissiveUnits are others")
    first, last, step = (float(number) for number in wished.split(":"))
    channels = spectral_channels(spec.channelnames)
    nm = [wavelength for wavelength, _ in channels]
    require(nm == list(numpy.arange(first, last + step / 2, step)), f"wavelengths are {nm}")
    sun = dict(re.findall(r"([\d.]+)nm:([-+\d.eE]+);", text_of(spec, "airlight:sunlight")))
    sunlight = numpy.array([float(value) for value in sun.values()])
    require([float(key) for key in sun] == nm, "airlight:sunlight is of other wavelengths")
    at_5_nm = numpy.arange(375, 786, 5)
    in_band = numpy.linspace(-step / 2, step / 2, 11)
    weights = numpy.r_[0.5, numpy.ones(9), 0.5] / 10
    over_bands = [sum(w * numpy.interp(numpy.array(nm) + d, at_5_nm, table) for d, w in zip(in_band, weights))
                  for table in (X, Y, Z)]
    at_points = [numpy.interp(nm, at_5_nm, table) for table in (X, Y, Z)]
    radiance = pixels[:, :, [place for _, place in channels]]
    found = pixels[:, :, [spec.channelnames.index(name) for name in "RGB"]]
    largest = numpy.abs(found).max(axis=2, keepdims=True)
    require((largest > 0).all(), "a pixel is black")
    bright = numpy.abs(found) > 0.1 * largest
    bands, points = (numpy.abs(found - colours(radiance, sunlight, numpy.array(matching), white))
                     for matching in (over_bands, at_points))
    print(f"bands {(bands / numpy.abs(found))[bright].max():.6f} points {(points / largest).max():.6f}")


main(*sys.argv[1:])
