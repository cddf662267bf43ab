#pragma once
// A sky for image-based lighting: its effect on a diffuse surface, as a map over normals and as spherical harmonics
// [RH01], and the sun apart, so that no renderer has to find a tiny disc by chance.
// Directions are in the preset's frame (x east, y up, -z north), colours in linear BT.709, in the unit of the sun's
// irradiance.

#include <array>

#include "core/render/render.h"

namespace airlight {

using Vector3 = std::array<double, 3>;

// Real orthonormal spherical harmonics up to degree 2 at a unit vector, without the Condon-Shortley sign:
// 0.282095, 0.488603 (y, z, x), 1.092548 (xy, yz), 0.315392 (3zz - 1), 1.092548 xz, 0.546274 (xx - yy). [RH01] eq. 3.
std::array<double, 9> sh_basis(const Vector3& direction);

// RGB coefficients of radiance in that order: the integral of radiance x basis over the sphere, W/m2 and the like.
using ShRadiance = std::array<Vector3, 9>;

// Projects an equirectangular picture whose centre looks at `azimuth` (radians): multiplies each pixel's radiance by
// the integral of the basis over the pixel's solid angle.
ShRadiance project_to_sh(const RadianceImage& latlong, double azimuth);

// The harmonics of the same light in axes turned about the vertical, for someone whose -z looks toward `azimuth`.
ShRadiance turned(const ShRadiance& light, double azimuth);

// Irradiance over normals, an equirectangular map whose centre is the normal toward `azimuth`: the sum of radiance x
// cosine over the sphere, by the exact integral of the direction over each pixel of the sky.
RadianceImage irradiance_map(const RadianceImage& latlong, double latlong_azimuth, int width, int height,
                             double azimuth);

// Irradiance of a level surface by an equirectangular picture, likewise.
Vector3 level_irradiance(const RadianceImage& latlong);

// The stage's light, sun or moon, as a directional light: the light that reaches the camera's place from its disc,
// darkened toward its limb or lit on one side, dimmed by the air and cut by the planet. It ignores sun.disc.visible and
// radiance_scale, which concern the picture alone.
struct SunLight {
  Vector3 direction{};          // to the disc's centre
  double elevation = 0.0;       // radians
  double azimuth = 0.0;         // radians
  double angular_radius = 0.0;  // radians
  Vector3 irradiance{};         // on a plane that faces it
  Vector3 irradiance_above_air{};
  double visible_share = 0.0;  // share of the disc's light that the planet leaves, before the air
};
SunLight sun_light(const DeviceOnDemand& device, const Stage& stage);

// Its irradiance at listed wavelengths, of a scene with spectra: SpectralImage's unit times sr.
std::vector<double> sun_spectrum(const DeviceOnDemand& device, const Stage& stage, const Nodes& nodes);

// The whole sphere around the camera's place, ground included, without discs: an equirectangular picture whose centre
// looks north, whatever the camera looks at. Throws RunError where it holds a NaN, infinity or negative value.
// `spectrum`: wavelengths of a spectrum beside the picture.
Rendering whole_sky(const DeviceOnDemand& device, const Stage& stage, const HostOptions& host, ImageSize size,
                    const std::optional<Nodes>& spectrum = {});

inline constexpr int kIrradianceWidth = 64;
inline constexpr int kIrradianceHeight = 32;

struct Lighting {
  RadianceImage irradiance;  // kIrradianceWidth x kIrradianceHeight, the centre toward the camera's azimuth
  ShRadiance sh{};
  Vector3 level{};  // irradiance of a level surface by the sky, without sun and moon
  SunLight sun;
  std::optional<SunLight> moon = {};
};

// By whole_sky(), and throws as that does.
Lighting lighting_of(const DeviceOnDemand& device, const Stage& stage, const HostOptions& host);

}  // namespace airlight
