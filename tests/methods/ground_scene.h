#pragma once
// Ground by maps that a test makes itself.

#include <memory>

#include "core/things/ground.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {

// `albedo`: of the texel in column i and row j, row 0 in the north. The planet's albedo is the map's mean.
template <class F>
inline void put_map(Scene& scene, const char* name, int rows, const F& albedo) {
  auto files = std::make_shared<GroundFiles>();
  files->identity = name;
  files->colour_rows = rows;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < 2 * rows; ++i) {
      const Spectrum at = albedo(i, j);
      for (const double channel : at) {
        files->colours.push_back(static_cast<float>(channel));
      }
    }
  }
  scene.ground = GroundMap{.albedo_map = name, .ocean = std::nullopt, .files = files};
  scene.planet.ground_albedo = mean_albedo(*files);
}

}  // namespace airlight::test
