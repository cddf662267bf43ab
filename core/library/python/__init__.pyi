import os
from typing import Any, Callable, Dict, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy
import numpy.typing

__version__: str

Preset = Union[str, os.PathLike[str], Dict[str, Any]]
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
    preset: Preset, *, layers: None = ..., progress: Optional[Callable[[float], Any]] = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
    fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
) -> Array: ...
@overload
def render(
    preset: Preset, *, layers: Literal["light", "stokes"], progress: Optional[Callable[[float], Any]] = ...,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
    fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
) -> Tuple[Array, Dict[str, Array]]: ...
def probe(
    preset: Preset, directions: Union[Doubles, Sequence[Sequence[float]]], *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
    fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
) -> Probes: ...
def irradiance(
    preset: Preset, *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
    fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
) -> Irradiance: ...
def check(
    preset: Preset, *,
    altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
    fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
    samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
    sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
) -> None: ...
def presets() -> List[str]: ...
def preset(name: str) -> Dict[str, Any]: ...

class Session:
    def __init__(self, device: str = ..., cache_folder: Union[str, os.PathLike[str]] = ..., threads: int = ...) -> None: ...
    @overload
    def render(
        self, preset: Preset, *, layers: None = ..., progress: Optional[Callable[[float], Any]] = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
        fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    ) -> Array: ...
    @overload
    def render(
        self, preset: Preset, *, layers: Literal["light", "stokes"], progress: Optional[Callable[[float], Any]] = ...,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
        fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    ) -> Tuple[Array, Dict[str, Array]]: ...
    def probe(
        self, preset: Preset, directions: Union[Doubles, Sequence[Sequence[float]]], *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
        fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    ) -> Probes: ...
    def irradiance(
        self, preset: Preset, *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
        fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    ) -> Irradiance: ...
    def check(
        self, preset: Preset, *,
        altitude: Optional[float] = ..., azimuth: Optional[float] = ..., ev: Optional[float] = ...,
        fov: Optional[float] = ..., method: Optional[str] = ..., pitch: Optional[float] = ..., projection: Optional[str] = ...,
        samples: Optional[int] = ..., set: Optional[Dict[str, Any]] = ..., size: Optional[Size] = ...,
        sun_azimuth: Optional[float] = ..., sun_elevation: Optional[float] = ..., target_error: Optional[float] = ...,
    ) -> None: ...
    def device(self) -> str: ...
