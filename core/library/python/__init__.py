"""Physically based skies as numpy arrays.

    sky = airlight.render("earth-noon", sun_elevation=4, size=(1280, 720))

Radiance is in the unit of the preset's sun per steradian: W/(m2 sr), lx/sr, or relative to a sun of irradiance 1.
Colours are linear Rec.709. Angles are degrees, azimuths clockwise from north.
"""

import atexit
import datetime
import difflib
import json
import numbers
import os
import typing

import numpy

from . import _airlight
from ._airlight import InputError, RunError

__all__ = ["InputError", "Irradiance", "Light", "Probes", "RunError", "Session", "Spectrum", "check", "irradiance",
           "preset", "presets", "probe", "render"]
__version__ = _airlight.version()

_OPTIONS = tuple(name.replace("-", "_") for name in _airlight.option_names())
_TEXTS = ("date", "method", "projection", "time", "tz")


class Probes(typing.NamedTuple):
    """Light along N directions. Stokes parameters q and u, as the method orders tells them, or None."""

    radiance: numpy.ndarray
    transmittance: numpy.ndarray
    q: typing.Optional[numpy.ndarray]
    u: typing.Optional[numpy.ndarray]


class Spectrum(typing.NamedTuple):
    """Spectral radiance (H, W, N), float32, at N wavelengths in nm; sunlight above the air; the radiance's unit."""

    wavelengths: numpy.ndarray
    radiance: numpy.ndarray
    sunlight: numpy.ndarray
    unit: str


class Light(typing.NamedTuple):
    """Sun or moon as a directional light. direction: x east, y up, z south."""

    direction: typing.List[float]
    elevation_deg: float
    azimuth_deg: float
    angular_radius_deg: float
    irradiance: typing.List[float]
    irradiance_above_air: typing.List[float]
    visible_share: float


class Irradiance(typing.NamedTuple):
    """What the sky gives a diffuse surface: by the normal (32, 64, 3), as nine harmonics (9, 3), and the lights."""

    map: numpy.ndarray
    harmonics: numpy.ndarray
    sun: Light
    moon: typing.Optional[Light]


def _known(given, known, function):
    for name in given:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            meant = f" (did you mean {near[0]}?)" if near else ""
            raise TypeError(f"{function}() has no keyword {name}{meant}; it takes {', '.join(sorted(known))}")


def _text(name, value):
    """The value of an option as the command line takes it."""
    if name == "size":
        if isinstance(value, str):
            return value
        sides = tuple(value) if isinstance(value, (tuple, list)) else ()
        if len(sides) != 2 or not all(isinstance(side, numbers.Integral) for side in sides):
            raise TypeError(f"size is {value!r}; expected (width, height) in pixels, or a text such as '64x32'")
        return f"{int(sides[0])}x{int(sides[1])}"
    if name == "date" and isinstance(value, datetime.date):
        return value.strftime("%Y-%m-%d")
    if name == "time" and isinstance(value, datetime.time):
        return value.strftime("%H:%M:%S")
    if name == "refraction":
        if not isinstance(value, bool):
            raise TypeError(f"refraction is {value!r}; expected True or False")
        return "true" if value else "false"
    if name in _TEXTS:
        if not isinstance(value, str):
            raise TypeError(f"{name} is {value!r}; expected a text")
        return value
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name} is {value!r}; expected a number")
    return repr(float(value)) if not isinstance(value, numbers.Integral) else str(int(value))


def _wavelengths(spectral):
    """"FIRST:LAST:STEP" of a text or of three numbers."""
    if spectral is None or isinstance(spectral, str):
        return spectral or ""
    try:
        first, last, step = (repr(float(number)) for number in spectral)
    except (TypeError, ValueError):
        raise TypeError(f"spectral is {spectral!r}; expected (first, last, step) in nm, or '380:780:10'") from None
    return f"{first}:{last}:{step}"


def _scene(function, preset, options, further=()):
    """The preset and its changes as the library takes them."""
    _known(options, _OPTIONS + ("set",) + tuple(further), function)
    sets = options.pop("set", None) or {}
    if not isinstance(sets, dict):
        raise TypeError(f"set is {sets!r}; expected a dictionary from JSON pointers to values")
    is_text = isinstance(preset, dict)
    if not is_text and not isinstance(preset, (str, os.PathLike)):
        raise TypeError(f"preset is {preset!r}; expected a built-in preset's name, a file, or a dictionary")
    return (json.dumps(preset) if is_text else os.fspath(preset), is_text,
            [(name, _text(name, value)) for name, value in options.items() if value is not None],
            [(pointer, json.dumps(value)) for pointer, value in sets.items()])


class Session:
    """One device and what skies have in common on it.

    device: part of a Vulkan device's name. cache_folder: where tables are kept for later starts; none is written
    without it. threads: of methods that run on the processor.
    """

    def __init__(self, device="", cache_folder="", threads=0):
        self._session = _airlight.Session(device, os.fspath(cache_folder), threads)

    def render(self, preset, *, layers=None, spectral=None, progress=None, **options):
        """The camera's picture: (height, width, 3), float32. See airlight.render."""
        scene = _scene("render", preset, options, ("layers", "progress", "spectral"))
        sky, planes, spectrum, *_ = self._session.render(*scene, layers or "", _wavelengths(spectral), progress)
        more = ((planes,) if layers else ()) + ((Spectrum(*spectrum),) if spectrum else ())
        return (sky, *more) if more else sky

    def probe(self, preset, directions, **options):
        """The light along directions. See airlight.probe."""
        scene = _scene("probe", preset, options)
        asked = numpy.asarray(directions, dtype=numpy.float64)
        if asked.ndim != 2 or asked.shape[1] != 2:
            raise ValueError(f"directions have the shape {asked.shape}; expected (N, 2): elevation and azimuth, degrees")
        return Probes(*self._session.probe(*scene, asked))

    def irradiance(self, preset, **options):
        """What the sky gives a diffuse surface. See airlight.irradiance."""
        found = self._session.irradiance(*_scene("irradiance", preset, options))
        return Irradiance(*found[:2], *(Light(*light) if light else None for light in found[2:]))

    def check(self, preset, **options):
        """Raises InputError with every problem of the preset and its changes."""
        self._session.check(*_scene("check", preset, options))

    def device(self):
        """The device's name; opens it."""
        return self._session.device()


_default = None


def _session():
    global _default
    if _default is None:
        _default = Session()
    return _default


@atexit.register
def _forget():
    """Closes the device before the driver's own threads end."""
    global _default
    _default = None


def render(preset, *, layers=None, spectral=None, progress=None, **options):
    """The camera's picture: scene-linear radiance, (height, width, 3), float32, the first row at the top.

    preset: a built-in preset's name, a file, or a preset as a dictionary. options: the long options of `airlight
    render` that change a scene, with _ for -: sun_elevation, sun_azimuth, altitude, azimuth, pitch, fov, projection,
    size, method, samples, target_error, ev; date, time, lat, lon, tz and place_altitude, which say where sun, moon and
    stars stand, with refraction, pressure and temperature; and set, a dictionary from JSON pointers to values.
    layers: "light" or "stokes"; then (picture, {name: array}) is returned.
    spectral: (first, last, step) in nm, of a preset that has spectra; then (picture, Spectrum) is returned, and with
    layers (picture, {name: array}, Spectrum).
    progress: called with the share done; False ends the render with RunError.
    """
    return _session().render(preset, layers=layers, spectral=spectral, progress=progress, **options)


def probe(preset, directions, **options):
    """Light along directions, (N, 2) of elevation and azimuth in degrees, without the sun's disc: Probes."""
    return _session().probe(preset, directions, **options)


def irradiance(preset, **options):
    """What the whole sky gives a diffuse surface at the camera's place, and sun and moon apart: Irradiance."""
    return _session().irradiance(preset, **options)


def check(preset, **options):
    """Raises InputError, a ValueError, with every problem of the preset and its changes, a line each."""
    _session().check(preset, **options)


def presets():
    """Names of the built-in presets."""
    return _airlight.presets()


def preset(name):
    """A built-in preset with every key written out, as a dictionary."""
    return json.loads(_airlight.preset_text(name))
