// The transmittance in probes and layers, in haze so thick and peaked that `orders` computes it delta-scaled.

#include <algorithm>
#include <cmath>

#include "core/render/layers.h"
#include "core/render/spans.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

constexpr double kThickness = 0.3;  // vertical optical depth of the haze
constexpr double kScaleHeight = 1.5;

Scene thick_haze(const std::string& method) {
  Scene scene = with_method(earth(), *find_method(method), true);
  Medium haze = medium("haze", {kThickness / kScaleHeight, kThickness / kScaleHeight, kThickness / kScaleHeight}, {},
                       exponential(kScaleHeight), PhaseFunction::henyey_greenstein, 0.8);
  scene.media = {haze};
  scene.sun.elevation = 30.0 * kDegree;
  scene.camera.altitude = 0.0;
  return scene;
}

// exp(-depth) straight up; along other rays the quadrature of the extinction on double. Scattering takes light out of a
// beam whatever its angle.
void expect_beam_as_on_double(Scene scene, const std::string& what) {
  if (scene.render.parameters.contains("steps")) {
    scene.render.parameters.insert_or_assign("steps", 512);
  }
  physics::Physics p = make_physics(scene);
  std::vector<Direction> directions;
  for (const double elevation : {90.0, 30.0, 8.0, 2.0}) {
    directions.push_back({elevation * kDegree, 1.0});
  }
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const physics::vec3 depth = p.optical_depth_to_top(p.scene.planet, 0.0, std::sin(directions[i].elevation), 4000);
    EXPECT_NEAR(found[i].transmittance[0] / std::exp(-depth.x), 1.0, 3e-3) << what << ", " << i;
  }
}

void expect_beam(const Scene& scene, const std::string& what) {
  physics::Physics p = make_physics(scene);
  EXPECT_NEAR(p.optical_depth_to_top(p.scene.planet, 0.0, 1.0, 4000).x, kThickness, 1e-4);
  expect_beam_as_on_double(scene, what);
}

TEST(Beam, ProbesTellItsTransmittance) {
  for (const char* method : {"march", "path-trace"}) {
    expect_beam(thick_haze(method), method);
  }
  for (const char* shells : {"never", "always"}) {
    Scene scene = thick_haze("orders");
    scene.render.parameters.insert_or_assign("shells", std::string(shells));
    expect_beam(scene, std::string("orders, shells ") + shells);
  }
}

// The search among layers takes as many steps as the longest list needs: lists of powers of two and of neighbouring
// lengths.
TEST(Beam, GoesThroughEachOfManyLayers) {
  for (const int count : {1, 2, 3, 16, 17, 256}) {
    Scene scene = thick_haze("march");
    Density& density = scene.media.front().density;
    density.profile = DensityProfile::layers;
    density.layers.clear();
    for (int i = 0; i < count; ++i) {
      const double altitude = 20.0 * i / count;
      density.layers.push_back({altitude, std::exp(-altitude / 4.0)});
    }
    density.layers.push_back({20.0, 0.0});
    if (count == 256) {
      density.layers.erase(density.layers.begin() + 1);
    }
    expect_beam_as_on_double(scene, std::to_string(count) + " layers and an end");
  }
}

// Layers agree with the probe. The air before things takes less out of a thing's light, and the same sky stands behind
// it.
TEST(Beam, LayersTellItAndThingsSeeMore) {
  for (const char* tabulate : {"never", "always"}) {
    Scene scene = all_round(thick_haze("orders"), 0.1, 8, 4);
    scene.render.parameters.insert_or_assign("tabulate", std::string(tabulate));
    RenderRequest request;
    request.layers = LayerSet::light;
    const Rendering rendering = render_now(scene, request);
    const auto layer = std::ranges::find_if(rendering.layers, [](const Layer& l) { return l.name == "transmittance"; });
    const AirTo whole = air_to(executor(), scene, std::vector<Span>{{3, 1, 1e6F}}).front();
    const Direction direction{22.5 * kDegree, scene.camera.azimuth - 22.5 * kDegree};
    const double probed = probe_now(scene, {direction}).front().transmittance[0];
    EXPECT_NEAR(static_cast<double>(layer->planes[8 + 3]) / probed, 1.0, 1e-4) << tabulate;
    EXPECT_GT(static_cast<double>(whole.transmittance[0]), 1.02 * probed);
  }
}

}  // namespace
}  // namespace airlight::test
