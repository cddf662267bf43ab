#include "core/physics/scene_data.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <variant>

#include "core/physics/moment_axes.h"
#include "core/physics/shells.h"

namespace airlight {
namespace {

using physics::vec3;

// One filler for both precisions: `Real`, `Vec3` and the structs come from the target.
template <class Vec3>
Vec3 convert(const vec3& v) {
  using Real = decltype(Vec3::x);
  Vec3 out;
  out.x = static_cast<Real>(v.x);
  out.y = static_cast<Real>(v.y);
  out.z = static_cast<Real>(v.z);
  return out;
}

vec3 vector_of(const Spectrum& s) {
  return {s[0], s[1], s[2]};
}

vec3 direction_of(double elevation, double azimuth) {
  const double c = std::cos(elevation);
  return {std::sin(azimuth) * c, std::sin(elevation), -std::cos(azimuth) * c};
}

// Radiance at the disc's centre: the limb-darkened profile 1 - u(1 - mu) has mean 1 - u/3 over the disc, and
// radiance_scale 1 makes the mean radiance irradiance / solid angle.
vec3 disc_radiance(const Sun& sun) {
  const double half = std::sin(0.5 * sun.disc.angular_radius);
  const double solid_angle = 4.0 * std::numbers::pi * half * half;
  const double mean_over_centre = 1.0 - sun.disc.limb_darkening / 3.0;
  return vector_of(sun.irradiance) * (sun.disc.radiance_scale / (solid_angle * mean_over_centre));
}

SunFade fade_of(const Scene& scene) {
  const auto found = scene.render.parameters.find("sun_fade");
  if (found == scene.render.parameters.end() || !std::holds_alternative<SunFade>(found->second)) {
    return {};
  }
  return std::get<SunFade>(found->second);
}

double scattering_scale_of(const Scene& scene) {
  const auto found = scene.render.parameters.find("multiple_scattering_scale");
  return found == scene.render.parameters.end() ? 1.0 : std::get<double>(found->second);
}

template <class Data>
void fill_media(Data& data, const Scene& scene) {
  using Vec3 = decltype(data.planet.ground_albedo);
  using Real = decltype(data.planet.ground_radius);
  assert(scene.media.size() <= static_cast<std::size_t>(kMaxMedia));
  unsigned int layer = 0;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const Medium& from = scene.media[i];
    auto& m = data.media[i];
    m.scattering = convert<Vec3>(vector_of(from.scattering));
    m.absorption = convert<Vec3>(vector_of(from.absorption));
    m.scale_height = static_cast<Real>(from.density.scale_height);
    m.center = static_cast<Real>(from.density.center);
    m.half_width = static_cast<Real>(from.density.half_width);
    m.below = static_cast<Real>(from.density.below);
    m.g = static_cast<Real>(from.phase_g);
    m.first_layer = layer;
    m.layer_count = static_cast<unsigned int>(from.density.layers.size());
    for (const DensityLayer& l : from.density.layers) {
      assert(layer < static_cast<unsigned int>(kMaxDensityLayers));
      data.layers[layer].x = static_cast<Real>(l.altitude);
      data.layers[layer].y = static_cast<Real>(l.density);
      ++layer;
    }
  }
}

// Taken over from the physics on double, which computes them.
template <class Data>
void fill_moments(Data& data, const physics::SceneData& from) {
  using Real = decltype(data.planet.ground_radius);
  data.moments.top = static_cast<Real>(from.moments.top);
  data.moments.elevation_scale = static_cast<Real>(from.moments.elevation_scale);
  data.moments.v_low = static_cast<Real>(from.moments.v_low);
  data.moments.v_high = static_cast<Real>(from.moments.v_high);
  data.shell_rows = from.shell_rows;
  std::transform(std::begin(from.shell_altitudes), std::end(from.shell_altitudes), std::begin(data.shell_altitudes),
                 [](double h) { return static_cast<Real>(h); });
  for (std::size_t i = 0; i < static_cast<std::size_t>(kMaxMedia); ++i) {
    data.media[i].legendre1 = static_cast<Real>(from.media[i].legendre1);
    data.media[i].legendre2 = static_cast<Real>(from.media[i].legendre2);
    data.media[i].legendre3 = static_cast<Real>(from.media[i].legendre3);
    data.media[i].legendre4 = static_cast<Real>(from.media[i].legendre4);
    data.media[i].legendre5 = static_cast<Real>(from.media[i].legendre5);
    data.media[i].legendre6 = static_cast<Real>(from.media[i].legendre6);
    data.media[i].legendre7 = static_cast<Real>(from.media[i].legendre7);
    data.media[i].legendre8 = static_cast<Real>(from.media[i].legendre8);
    data.media[i].legendre9 = static_cast<Real>(from.media[i].legendre9);
  }
}

std::uint32_t cube_layout_code(CubeLayout layout) {
  switch (layout) {
    case CubeLayout::stack:
      return physics::kCubeStack;
    case CubeLayout::strip:
      return physics::kCubeStrip;
    case CubeLayout::cross:
      return physics::kCubeCross;
  }
  return physics::kCubeStack;
}

template <class Data>
Data fill(const Scene& scene) {
  Data data{};
  using Vec3 = decltype(data.planet.ground_albedo);
  using Real = decltype(data.planet.ground_radius);
  data.planet.ground_radius = static_cast<Real>(scene.planet.ground_radius);
  data.planet.atmosphere_height = static_cast<Real>(scene.planet.atmosphere_height);
  data.planet.ground_albedo = convert<Vec3>(vector_of(scene.planet.ground_albedo));
  data.sun.direction = convert<Vec3>(direction_of(scene.sun.elevation, scene.sun.azimuth));
  data.sun.irradiance = convert<Vec3>(vector_of(scene.sun.irradiance));
  data.sun.angular_radius = static_cast<Real>(scene.sun.disc.angular_radius);
  data.sun.limb_darkening = static_cast<Real>(scene.sun.disc.limb_darkening);
  data.sun.disc_radiance = convert<Vec3>(disc_radiance(scene.sun));
  const SunFade fade = fade_of(scene);
  data.sun.fade_scale = static_cast<Real>(fade.scale);
  data.sun.fade_bias = static_cast<Real>(fade.bias);
  const CameraBasis basis = camera_basis(scene.camera);
  data.camera.altitude = static_cast<Real>(scene.camera.altitude);
  data.camera.right = convert<Vec3>(basis.right);
  data.camera.up = convert<Vec3>(basis.up);
  data.camera.forward = convert<Vec3>(basis.forward);
  data.camera.azimuth = static_cast<Real>(scene.camera.azimuth);
  data.camera.half_fov = static_cast<Real>(0.5 * scene.camera.vertical_fov);
  data.camera.width = static_cast<unsigned int>(scene.image.width);
  data.camera.height = static_cast<unsigned int>(scene.image.height);
  data.tile.width = static_cast<unsigned int>(scene.image.width);
  data.camera.cube_layout = cube_layout_code(scene.camera.cube_layout);
  data.multiple_scattering_scale = static_cast<Real>(scattering_scale_of(scene));
  fill_media(data, scene);
  return data;
}

bool schlick_for_all(const Scene& scene) {
  const auto found = scene.render.parameters.find("phase");
  return found != scene.render.parameters.end() && found->second == ParameterValue(std::string("schlick"));
}

template <class Code>
std::uint32_t packed_codes(const Scene& scene, Code code) {
  std::uint32_t codes = 0;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    codes |= code(scene.media[i]) << (physics::kBitsPerMedium * static_cast<unsigned int>(i));
  }
  return codes;
}

}  // namespace

CameraBasis camera_basis(const Camera& camera) {
  const double cos_azimuth = std::cos(camera.azimuth);
  const double sin_azimuth = std::sin(camera.azimuth);
  const double cos_pitch = std::cos(camera.pitch);
  const double sin_pitch = std::sin(camera.pitch);
  const vec3 forward{sin_azimuth * cos_pitch, sin_pitch, -cos_azimuth * cos_pitch};
  const vec3 right{cos_azimuth, 0.0, sin_azimuth};
  const vec3 up{-sin_azimuth * sin_pitch, cos_pitch, cos_azimuth * sin_pitch};
  const double c = std::cos(camera.roll);
  const double s = std::sin(camera.roll);
  return {right * c - up * s, right * s + up * c, forward};
}

physics::Physics make_physics(const Scene& scene) {
  physics::Physics p;
  p.scene = fill<physics::SceneData>(scene);
  p.media = static_cast<unsigned int>(scene.media.size());
  p.density_profiles = density_profile_codes(scene);
  p.phase_functions = phase_function_codes(scene);
  const auto fade = scene.render.parameters.find("sun_fade");
  p.fade = fade != scene.render.parameters.end() && std::holds_alternative<SunFade>(fade->second);
  for (physics::uint i = 0; i < p.media; ++i) {
    physics::MediumData& m = p.scene.media[i];
    const std::array<double, 10> moments = legendre_moments(p, p.phase_of(i), m.g);
    m.legendre1 = moments[1];
    m.legendre2 = moments[2];
    m.legendre3 = moments[3];
    m.legendre4 = moments[4];
    m.legendre5 = moments[5];
    m.legendre6 = moments[6];
    m.legendre7 = moments[7];
    m.legendre8 = moments[8];
    m.legendre9 = moments[9];
  }
  p.scene.moments = moment_axes(p);
  if (uses_shells(scene, p)) {
    const std::vector<double> rows = shell_altitudes(scene, p);
    assert(rows.size() <= static_cast<std::size_t>(physics::kMaxShellRows));
    p.scene.shell_rows = static_cast<physics::uint>(rows.size());
    std::copy(rows.begin(), rows.end(), std::begin(p.scene.shell_altitudes));
    p.scene.moments = shell_moment_axes(p);
  }
  return p;
}

device::SceneData device_scene(const Scene& scene) {
  device::SceneData data = fill<device::SceneData>(scene);
  fill_moments(data, make_physics(scene).scene);
  return data;
}

std::vector<std::byte> device_scene_bytes(const Scene& scene) {
  return device_scene_bytes(scene, {0, 0, scene.image.width, scene.image.height});
}

std::vector<std::byte> device_scene_bytes(const Scene& scene, const Tile& tile) {
  device::SceneData data = device_scene(scene);
  data.tile.x = static_cast<unsigned int>(tile.x);
  data.tile.y = static_cast<unsigned int>(tile.y);
  data.tile.width = static_cast<unsigned int>(tile.width);
  std::vector<std::byte> bytes(sizeof data);
  std::memcpy(bytes.data(), &data, sizeof data);
  return bytes;
}

std::uint32_t density_profile_codes(const Scene& scene) {
  return packed_codes(scene, [](const Medium& m) -> std::uint32_t {
    switch (m.density.profile) {
      case DensityProfile::exponential:
        return physics::kDensityExponential;
      case DensityProfile::tent:
        return physics::kDensityTent;
      case DensityProfile::lorentzian:
        return physics::kDensityLorentzian;
      case DensityProfile::constant:
        return physics::kDensityConstant;
      case DensityProfile::layers:
        return physics::kDensityLayers;
    }
    return physics::kDensityExponential;
  });
}

std::uint32_t phase_function_codes(const Scene& scene) {
  const bool rational = schlick_for_all(scene);
  return packed_codes(scene, [rational](const Medium& m) -> std::uint32_t {
    switch (m.phase) {
      case PhaseFunction::rayleigh:
        return physics::kPhaseRayleigh;
      case PhaseFunction::henyey_greenstein:
        return rational ? physics::kPhaseSchlick : physics::kPhaseHenyeyGreenstein;
      case PhaseFunction::cornette_shanks:
        return rational ? physics::kPhaseSchlick : physics::kPhaseCornetteShanks;
      case PhaseFunction::schlick:
        return physics::kPhaseSchlick;
      case PhaseFunction::isotropic:
        return physics::kPhaseIsotropic;
    }
    return physics::kPhaseIsotropic;
  });
}

std::uint32_t scattering_media(const Scene& scene) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const Spectrum& s = scene.media[i].scattering;
    bits |= s[0] > 0.0 || s[1] > 0.0 || s[2] > 0.0 ? 1u << i : 0u;
  }
  return bits;
}

std::uint32_t projection_code(Projection projection) {
  switch (projection) {
    case Projection::perspective:
      return physics::kProjectionPerspective;
    case Projection::equirectangular:
      return physics::kProjectionEquirectangular;
    case Projection::fisheye:
      return physics::kProjectionFisheye;
    case Projection::cube:
      return physics::kProjectionCube;
    case Projection::octahedral:
      return physics::kProjectionOctahedral;
  }
  return physics::kProjectionPerspective;
}

}  // namespace airlight
