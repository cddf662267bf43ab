#include "tests/bench/scenes.h"

#include <numbers>

namespace airlight::bench {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Look {  // degrees
  double sun_elevation = 0.0;
  double sun_azimuth = 0.0;
  double azimuth = 0.0;
  double pitch = 0.0;
};

Medium air_molecules() {
  Medium medium;
  medium.name = "rayleigh";
  medium.scattering = {5.802e-3, 13.558e-3, 33.1e-3};
  medium.density.scale_height = 8.0;
  medium.phase = PhaseFunction::rayleigh;
  return medium;
}

Medium aerosol(double amount) {
  Medium medium;
  medium.name = "aerosol";
  medium.scattering.fill(amount * 3.996e-3);
  medium.absorption.fill(amount * 0.444e-3);
  medium.density.scale_height = 1.2;
  medium.phase = PhaseFunction::henyey_greenstein;
  medium.phase_g = 0.8;
  return medium;
}

Medium ozone() {
  Medium medium;
  medium.name = "ozone";
  medium.absorption = {0.650e-3, 1.881e-3, 0.085e-3};
  medium.density.profile = DensityProfile::tent;
  medium.density.center = 25.0;
  medium.density.half_width = 15.0;
  return medium;
}

Scene earth(const Look& look, double altitude, double aerosol_amount = 1.0) {
  Scene scene;
  scene.planet.ground_albedo = {0.11, 0.12, 0.07};
  scene.media = {air_molecules(), aerosol(aerosol_amount), ozone()};
  scene.sun.elevation = look.sun_elevation * kDegree;
  scene.sun.azimuth = look.sun_azimuth * kDegree;
  scene.sun.disc.angular_radius = 0.2666 * kDegree;
  scene.camera.altitude = altitude;
  scene.camera.azimuth = look.azimuth * kDegree;
  scene.camera.pitch = look.pitch * kDegree;
  scene.camera.vertical_fov = 60.0 * kDegree;
  return scene;
}

}  // namespace

const std::vector<NamedScene>& scenes() {
  constexpr double kOnGround = 0.001;  // km
  static const std::vector<NamedScene> all = {
      {"sun-20", earth({20.0, 100.0, 90.0, 15.0}, kOnGround)},
      {"sun-60", earth({60.0, 180.0, 0.0, 22.0}, kOnGround)},
      {"sun-0.5", earth({0.5, 280.0, 270.0, 12.0}, kOnGround)},
      {"twilight", earth({-4.0, 280.0, 270.0, 15.0}, kOnGround)},
      {"haze", earth({20.0, 100.0, 90.0, 15.0}, kOnGround, 10.0)},
      {"10-km", earth({20.0, 100.0, 90.0, 5.0}, 10.0)},
      {"orbit", earth({30.0, 150.0, 90.0, -20.0}, 500.0)},
  };
  return all;
}

Scene rendered_by(const SkyMethod& method, Scene scene, ImageSize size) {
  scene.image = size;
  scene.render.method = method.info.name;
  scene.render.parameters.clear();
  for (const ParameterInfo& parameter : method.info.parameters) {
    scene.render.parameters.emplace(parameter.key, parameter.default_value);
  }
  return scene;
}

}  // namespace airlight::bench
