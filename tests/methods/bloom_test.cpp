// Bloom has the same angular width and energy at 135 lines and at 1080, and nothing else of the picture changes.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/methods/glow_fixture.h"

namespace airlight::test {
namespace {

// 135 lines over 30 degrees have the pixels of 270 over 60.
Scene chained_sun(int lines) {
  return lone_sun(lines, BloomModel::chain);
}

struct Glow {
  double half = 0.0;    // degrees around the sun that hold half of the glow's energy
  double most = 0.0;    // nine tenths
  double energy = 0.0;  // sum of glow x solid angle
};

Glow glow_of(const Scene& scene, const RadianceImage& bloom) {
  std::vector<std::pair<double, double>> shares;  // distance in degrees, energy
  for (int y = 0; y < bloom.height; ++y) {
    for (int x = 0; x < bloom.width; ++x) {
      shares.emplace_back(degrees_off_middle(scene, x, y), channel_of(bloom, x, y, 1) * solid_angle(scene, x, y));
    }
  }
  std::sort(shares.begin(), shares.end());
  Glow glow;
  for (const auto& [distance, energy] : shares) {
    glow.energy += energy;
  }
  double sum = 0.0;
  for (const auto& [distance, energy] : shares) {
    sum += energy;
    glow.half = sum <= 0.5 * glow.energy ? distance : glow.half;
    glow.most = sum <= 0.9 * glow.energy ? distance : glow.most;
  }
  return glow;
}

// For comparison: in mips of the picture's own size the glow's radius would be 5.9, 4.6, 3.4 degrees at 270, 540, 1080
// lines.
TEST(Bloom, IsAsWideInAngleAtEveryResolution) {
  std::vector<Glow> glows;
  for (const int lines : {135, 270, 540, 1080}) {
    const Scene scene = chained_sun(lines);
    const Rendering rendering = with_bloom(scene);
    ASSERT_TRUE(rendering.bloom.has_value()) << lines;
    glows.push_back(glow_of(scene, *rendering.bloom));
    RecordProperty("degrees_of_90_percent_at_" + std::to_string(lines), std::to_string(glows.back().most));
  }
  for (const Glow& glow : glows) {
    EXPECT_NEAR(glow.half / glows.back().half, 1.0, 0.1);
    EXPECT_NEAR(glow.most / glows.back().most, 1.0, 0.05);
    EXPECT_NEAR(glow.energy / glows.back().energy, 1.0, 0.1);
  }
}

// The threshold is on exposed luminance: a sun k times as bright at 1/k of the exposure glows k times as much.
TEST(Bloom, FollowsTheExposure) {
  Scene scene = chained_sun(90);
  const RadianceImage one = *with_bloom(scene).bloom;
  scene.sun.irradiance = {1000.0, 1000.0, 1000.0};
  scene.display.exposure = 1e-3;
  const RadianceImage other = *with_bloom(scene).bloom;
  for (std::size_t i = 0; i < one.rgba.size(); ++i) {
    if (i % 4 != 3) {
      const double expected = 1000.0 * static_cast<double>(one.rgba[i]);
      EXPECT_NEAR(static_cast<double>(other.rgba[i]), expected, 1e-4 * expected + 1e-6) << i;
    }
  }
}

TEST(Bloom, IsInTheToneCurveAsItIsInItsPicture) {
  Scene round = all_round(chained_sun(8), 0.001, 72, 36);
  round.sun.azimuth = std::numbers::pi;  // on the seam
  for (Scene scene : {chained_sun(90), round}) {
    scene.bloom.intensity = 0.01;
    expect_glow_in_tone_curve(scene, 1e-3);
  }
}

TEST(Bloom, LeavesThePictureAlone) {
  const Scene scene = chained_sun(60);
  EXPECT_TRUE(with_bloom(scene).radiance.rgba == render_now(scene).radiance.rgba);
}

TEST(Bloom, IsLeftOutWhereNothingExceedsItsThreshold) {
  Scene scene = chained_sun(60);
  scene.display.exposure = 1e-6;
  const Rendering dim = with_bloom(scene);
  EXPECT_FALSE(dim.bloom.has_value());
  EXPECT_TRUE(std::any_of(dim.left_out.begin(), dim.left_out.end(),
                          [](const std::string& line) { return line.starts_with("bloom: nothing is brighter"); }));
  scene.display.exposure = 1.0;
  scene.bloom.enabled = false;
  EXPECT_FALSE(with_bloom(scene).bloom.has_value());
}

// A picture that goes all the way round has no seam: a sun on its edge glows like one in its middle.
TEST(Bloom, GoesOnAcrossTheSeam) {
  Scene scene = all_round(chained_sun(8), 0.001, 144, 72);
  scene.sun.azimuth = 0.0;
  const RadianceImage middle = *with_bloom(scene).bloom;
  scene.sun.azimuth = std::numbers::pi;
  const RadianceImage edge = *with_bloom(scene).bloom;
  const double most = greatest(middle);
  ASSERT_GT(most, 0.0);
  for (int y = 0; y < 72; ++y) {
    for (int x = 0; x < 144; ++x) {
      EXPECT_NEAR(channel_of(edge, (x + 72) % 144, y, 0), channel_of(middle, x, y, 0), 0.01 * most) << x << ", " << y;
    }
  }
}

TEST(Bloom, IsRoundAndCentred) {
  const Scene scene = chained_sun(120);
  const RadianceImage bloom = *with_bloom(scene).bloom;
  const double most = greatest(bloom);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      EXPECT_NEAR(channel_of(bloom, x, y, 0), channel_of(bloom, 119 - x, y, 0), 0.01 * most) << x << ", " << y;
      EXPECT_NEAR(channel_of(bloom, x, y, 0), channel_of(bloom, y, x, 0), 0.02 * most) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace airlight::test
