import datetime
import os
from typing import Any, Callable, Dict, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy
import numpy.typing

__version__: str

Preset = Union[str, os.PathLike[str], Dict[str, Any]]
Date = Union[str, datetime.date]
Time = Union[str, datetime.time]
Progress = Optional[Callable[[float], Any]]
Wavelengths = Union[str, Sequence[float]]
Size = Union[str, Tuple[int, int], List[int]]
Array = numpy.typing.NDArray[numpy.float32]
Doubles = numpy.typing.NDArray[numpy.float64]

class InputError(ValueError): ...
class RunError(RuntimeError): ...

class Probes(NamedTuple):
    radiance: Doubles
    transmittance: Doubles
    q: Optional[Doubles]
    u: Optional[Doubles]

class Spectrum(NamedTuple):
    wavelengths: Doubles
    radiance: Array
    sunlight: Doubles
    unit: str

class Light(NamedTuple):
    direction: List[float]
    elevation_deg: float
    azimuth_deg: float
    angular_radius_deg: float
    irradiance: List[float]
    irradiance_above_air: List[float]
    visible_share: float

class Irradiance(NamedTuple):
    map: Array
    harmonics: Doubles
    sun: Light
    moon: Optional[Light]

@overload
def render(
    preset: Preset, *, layers: None = ..., spectral: None = ..., progress: Progress = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Array: ...
@overload
def render(
    preset: Preset, *, layers: None = ..., spectral: Wavelengths, progress: Progress = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Tuple[Array, Spectrum]: ...
@overload
def render(
    preset: Preset, *, layers: Literal["light", "stokes"], spectral: None = ..., progress: Progress = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Tuple[Array, Dict[str, Array]]: ...
@overload
def render(
    preset: Preset, *, layers: Literal["light", "stokes"], spectral: Wavelengths, progress: Progress = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Tuple[Array, Dict[str, Array], Spectrum]: ...
def probe(
    preset: Preset, directions: Union[Doubles, Sequence[Sequence[float]]], *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Probes: ...
def irradiance(
    preset: Preset, *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> Irradiance: ...
def check(
    preset: Preset, *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
    ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
    method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
    pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
) -> None: ...
def presets() -> List[str]: ...
def preset(name: str) -> Dict[str, Any]: ...

class Session:
    def __init__(self, device: str = ..., cache_folder: Union[str, os.PathLike[str]] = ..., threads: int = ...) -> None: ...
    @overload
    def render(
        self, preset: Preset, *, layers: None = ..., spectral: None = ..., progress: Progress = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Array: ...
    @overload
    def render(
        self, preset: Preset, *, layers: None = ..., spectral: Wavelengths, progress: Progress = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Tuple[Array, Spectrum]: ...
    @overload
    def render(
        self, preset: Preset, *, layers: Literal["light", "stokes"], spectral: None = ..., progress: Progress = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Tuple[Array, Dict[str, Array]]: ...
    @overload
    def render(
        self, preset: Preset, *, layers: Literal["light", "stokes"], spectral: Wavelengths, progress: Progress = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Tuple[Array, Dict[str, Array], Spectrum]: ...
    def probe(
        self, preset: Preset, directions: Union[Doubles, Sequence[Sequence[float]]], *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Probes: ...
    def irradiance(
        self, preset: Preset, *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> Irradiance: ...
    def check(
        self, preset: Preset, *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., date: Optional[Date] = ...,
        ev: Optional[float] = ..., fov: Optional[float] = ..., lat: Optional[float] = ..., lon: Optional[float] = ...,
        method: Optional[str] = ..., pitch: Optional[float] = ..., place_altitude: Optional[float] = ...,
        pressure: Optional[float] = ..., projection: Optional[str] = ..., refraction: Optional[bool] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
        temperature: Optional[float] = ..., time: Optional[Time] = ..., tz: Optional[str] = ...,
    ) -> None: ...
    def device(self) -> str: ...
