// Clouds in pictures by `orders`: level clouds against adding and doubling, what stands behind them, and what is
// refused.

#include <cmath>

#include "core/error.h"
#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/slab.h"

namespace airlight::test {
namespace {

constexpr double kAsymmetryOfDrops = 0.85;

// An even cloud round a planet so large that it is level, in air that hardly scatters.
Scene under_level_cloud(double optical_depth, double sun_mu) {
  Scene scene = vacuum();
  scene.planet.ground_radius = 1e6;
  scene.planet.atmosphere_height = 20.0;
  scene.planet.ground_albedo = {0.0, 0.0, 0.0};
  scene.media = {medium(PhaseFunction::rayleigh, 0.0, {1e-9, 1e-9, 1e-9}, {0.0, 0.0, 0.0}, exponential(8.0))};
  scene.sun.elevation = std::asin(sun_mu);
  scene.sun.azimuth = 0.0;
  scene.sun.disc.visible = false;
  Cloud cloud;
  cloud.kind = CloudKind::volume;
  cloud.base = 1.0;
  cloud.top = 2.0;
  cloud.repeats = true;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = kAsymmetryOfDrops;
  auto contents = std::make_shared<CloudFile>();
  contents->nx = 4;
  contents->ny = 4;
  contents->nz = 20;
  contents->dx = 1.0;
  contents->dy = 1.0;
  contents->dz = 0.05;
  contents->lowest = 1.0;
  contents->extinction.assign(4 * 4 * 20, static_cast<float>(optical_depth));
  contents->identity = "level " + std::to_string(optical_depth);
  cloud.contents = contents;
  scene.clouds = {cloud};
  return with_method(scene, *find_method("orders"));
}

// Above and below, in directions all around but within 25 degrees of the sun, where light that the peak scatters is
// taken for sunlight and scattered once more; thick clouds and thin ones, by a high sun and a low one.
TEST(CloudPicture, LevelCloudsMeetAddingAndDoubling) {
  constexpr int kNodes = 24;
  for (const double depth : {0.5, 4.0, 16.0}) {
    for (const int sun : {10, 20}) {
      const Slab judge({depth, 1.0, henyey_greenstein_moments(kAsymmetryOfDrops, 48), 0.0}, kNodes, sun);
      double error = 0.0;
      double found = 0.0;
      double expected = 0.0;
      int count = 0;
      for (const bool above : {true, false}) {
        Scene scene = under_level_cloud(depth, judge.nodes()[static_cast<std::size_t>(sun)]);
        scene.camera.altitude = above ? 5.0 : 0.0;
        std::vector<Direction> directions;
        std::vector<double> truth;
        for (const std::size_t node : {8U, 12U, 16U, 20U, 23U}) {
          for (const double azimuth : {0.4, 1.6, 2.9}) {
            const double elevation = std::asin(judge.nodes()[node]);
            const double mu_sun = judge.nodes()[static_cast<std::size_t>(sun)];
            const double across = std::cos(elevation) * std::sqrt(1.0 - mu_sun * mu_sun) * std::cos(azimuth);
            if (!above && judge.nodes()[node] * mu_sun + across > std::cos(radians(25.0))) {
              continue;
            }
            directions.push_back({above ? -elevation : elevation, azimuth});
            truth.push_back(above ? judge.reflected(node, azimuth) : judge.transmitted(node, azimuth));
          }
        }
        const std::vector<ProbeResult> results = probe_now(scene, directions);
        for (std::size_t i = 0; i < truth.size(); ++i) {
          const double value = results[i].radiance[1] / scene.sun.irradiance[1];
          error += std::abs(value / truth[i] - 1.0);
          found += value;
          expected += truth[i];
          ++count;
        }
      }
      std::printf("depth %4.1f, sun %.2f: bias %+.2f %%, mean relative error %.2f %%\n", depth,
                  judge.nodes()[static_cast<std::size_t>(sun)], 100.0 * (found / expected - 1.0),
                  100.0 * error / count);
      // Thin clouds send little light to the sides, and harmonics of degree 2 do not hold it.
      EXPECT_LT(error / count, depth < 1.0 ? 0.12 : 0.06) << depth << " " << sun;
      EXPECT_NEAR(found / expected, 1.0, depth < 1.0 ? 0.18 : 0.045) << depth << " " << sun;
    }
  }
}

// A cloud without water is no cloud; one that is thick hides the sun's disc.
TEST(CloudPicture, HidesWhatStandsBehind) {
  Scene scene = under_level_cloud(30.0, 0.7);
  scene.sun.disc.visible = true;
  scene.image = {24, 24};
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = 4.0 * scene.sun.disc.angular_radius;
  const double behind = greatest(render_now(scene).radiance);
  auto empty = std::make_shared<CloudFile>(*scene.clouds.front().contents);
  empty->extinction.assign(empty->extinction.size(), 0.0F);
  empty->identity = "empty";
  scene.clouds.front().contents = empty;
  const double seen = greatest(render_now(scene).radiance);
  EXPECT_LT(behind, 1e-3 * seen);
  Scene clear = scene;
  clear.clouds.clear();
  EXPECT_NEAR(seen / greatest(render_now(clear).radiance), 1.0, 1e-5);
}

// A field may be thinner than its cells are wide, and of one cell.
TEST(CloudPicture, TakesTheThinnestField) {
  Scene scene = under_level_cloud(1.0, 0.7);
  Cloud cloud;
  cloud.kind = CloudKind::stratocumulus;
  cloud.cover = 1.0;
  cloud.base = 1.0;
  cloud.top = 1.1;
  cloud.cell = 0.5;
  cloud.period = 1.0;
  cloud.detail = 1.0;
  cloud.water = 0.3;
  cloud.effective_radius = 8.0;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = kAsymmetryOfDrops;
  scene.clouds = {cloud};
  scene.image = {4, 4};
  scene.camera.pitch = 1.0;
  scene.camera.vertical_fov = 1.0;
  EXPECT_GT(greatest(render_now(scene).radiance), 0.0);
}

void expect_refused(const Scene& scene, const std::string& words) {
  try {
    render_now(scene);
    FAIL() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("path-trace"), std::string::npos) << error.what();
  }
}

TEST(CloudPicture, RefusesWhatItDoesNotKnow) {
  Scene scene = under_level_cloud(1.0, 0.7);
  scene.image = {4, 4};
  Scene two = scene;
  two.clouds.push_back(two.clouds.front());
  expect_refused(two, "renders one cloud, and there are 2");
  Scene far = scene;
  far.camera.altitude = 30.0;
  expect_refused(far, "lower camera.altitude_km");
  Scene ball = scene;
  ball.spheres.push_back({});
  expect_refused(ball, "terrain or spheres");
}

}  // namespace
}  // namespace airlight::test
