#pragma once
// Air that bends light as ExactAir does, and how far a method is from path-trace in it.

#include <cmath>
#include <vector>

#include "tests/methods/exact_rays.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {

// Clear air of a tenth of Earth's molecules, whose index falls as ExactAir's does.
inline Scene clear_and_bent(const char* method, double altitude) {
  const ExactAir air;
  Scene scene = with_method(earth(), *find_method(method));
  scene.media.resize(1);
  for (double& coefficient : scene.media[0].scattering) {
    coefficient *= 0.1;
  }
  scene.planet.ground_radius = air.radius;
  scene.planet.refraction.emplace().n_minus_1 = air.n_minus_1;
  scene.planet.refraction->density.scale_height = air.scale_height;
  scene.camera.altitude = altitude;
  scene.render.polarisation = false;
  return scene;
}

// Mean relative difference from the judge, its noise included.
inline double mean_error(const Scene& scene, const HostPicture& truth, const std::vector<Direction>& directions) {
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  double sum = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
      sum += std::abs(found[i].radiance[c] / want - 1.0) / (3.0 * static_cast<double>(directions.size()));
    }
  }
  return sum;
}

// Mean over the directions of what the judge's noise adds to the difference, were there no other.
inline double noise_of(const HostPicture& truth) {
  constexpr double kMeanOfNormal = 0.798;
  double sum = 0.0;
  for (int i = 0; i < truth.radiance.width; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += static_cast<double>(truth.standard_error.at(i, 0)[c]) / static_cast<double>(truth.radiance.at(i, 0)[c]);
    }
  }
  return kMeanOfNormal * sum / (3.0 * truth.radiance.width);
}

inline HostPicture truth_of(Scene scene, const std::vector<Direction>& directions, int samples) {
  scene = with_method(scene, *find_method("path-trace"));
  scene.render.polarisation = false;
  scene.render.parameters.find("samples")->second = samples;
  return airlight::traced(scene, View{directions}, {});
}

}  // namespace airlight::test
