// Places of the probes in a picture, and their cost.
#include "core/choice/probes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/choice/candidates.h"
#include "tests/choice/of_scene.h"
#include "tests/choice/preset_scene.h"

namespace airlight::choice {
namespace {

TEST(Probes, AreFewInsideThePictureAndTheSameAgain) {
  const Scene scene = preset("sunset");
  const Probes probes = choose_probes(scene, 256);
  EXPECT_NEAR(static_cast<double>(probes.directions.size()), 256.0, 16.0);
  EXPECT_EQ(probes.directions.size(), probes.weights.size());
  const Probes again = choose_probes(scene, 256);
  ASSERT_EQ(again.directions.size(), probes.directions.size());
  for (std::size_t i = 0; i < probes.directions.size(); ++i) {
    EXPECT_EQ(again.directions[i].elevation, probes.directions[i].elevation);
    EXPECT_LT(std::abs(probes.directions[i].elevation - scene.camera.pitch), 0.8);
  }
  const Probes all = choose_probes(preset("sunset", {16, 9}), 256);
  EXPECT_EQ(all.directions.size(), 144U);
  EXPECT_EQ(std::set<double>(all.weights.begin(), all.weights.end()), std::set<double>{1.0});
}

struct Shares {
  double by_weight = 0.0;
  double by_count = 0.0;
};

// Shares of the probes within two degrees of the horizon.
Shares beside_the_horizon(const Probes& probes) {
  Shares shares;
  double total = 0.0;
  for (std::size_t i = 0; i < probes.directions.size(); ++i) {
    const bool in_band = std::abs(probes.directions[i].elevation) < 2.0 * 0.01745;
    shares.by_weight += in_band ? probes.weights[i] : 0.0;
    shares.by_count += in_band ? 1.0 / static_cast<double>(probes.directions.size()) : 0.0;
    total += probes.weights[i];
  }
  shares.by_weight /= total;
  return shares;
}

TEST(Probes, AreDenserAtTheHorizonYetStandForAllPixelsAlike) {
  const Shares of_pixels = beside_the_horizon(choose_probes(preset("noon", {320, 180}), 320 * 180));
  EXPECT_NEAR(of_pixels.by_weight, of_pixels.by_count, 1e-9);
  const Shares of_probes = beside_the_horizon(choose_probes(preset("noon"), 256));
  EXPECT_GT(of_probes.by_count, 2.0 * of_probes.by_weight);
  EXPECT_NEAR(of_probes.by_weight, of_pixels.by_weight, 0.2 * of_pixels.by_weight);
}

// A single row of pixels at the horizon may be wrong, so each row has a chance of a probe.
TEST(Probes, StandInEveryRowOfPixels) {
  const Scene scene = preset("noon", {160, 150});
  physics::Physics p = make_physics(scene);
  std::set<int> rows;
  for (const Direction& d : choose_probes(scene, 256).directions) {
    const physics::vec3 direction = p.direction_from_angles(d.elevation, d.azimuth);
    const double y = p.pixel_of(p.scene.camera, physics::kProjectionPerspective, direction).y;
    rows.insert(static_cast<int>(y));
  }
  EXPECT_GT(rows.size(), 100U) << "of 150 rows";
}

// By predicted cost, since no test may depend on the clock: near-truth tables and rays, against the march that they
// save.
TEST(Probes, CostLessThanAFifthOfAMarchAtFullSize) {
  const Scene scene = preset("noon");
  Scene rays = scene;
  rays.image = {256, 1};
  const double probing = reference(rays, false).cost.total();
  for (const Candidate& candidate : candidates(scene, 0.01, "march", {})) {
    if (candidate.quality == "32") {
      EXPECT_LT(probing, 0.2 * candidate.cost.total());
    }
  }
}

}  // namespace
}  // namespace airlight::choice
