// Bloom: as wide in angle at 135 lines as at 1080, its energy with it; nothing else of the picture touched.

#include <algorithm>
#include <cmath>

#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

// A black sky with the sun in the middle, `lines` high over 30 degrees: 135 lines here have the pixels of 270 over 60.
Scene lone_sun(int lines) {
  Scene scene = vacuum();
  scene.sun.elevation = 45.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = 30.0 * kDegree;
  scene.image = {lines, lines};
  scene.display.exposure = 1.0;
  scene.bloom.model = BloomModel::chain;
  return with_method(scene, *find_method("march"), true);
}

Rendering with_bloom(const Scene& scene) {
  RenderRequest request;
  request.bloom = true;
  return render_now(scene, request);
}

struct Glow {
  double half = 0.0;    // degrees around the sun that hold half of the glow's energy
  double most = 0.0;    // nine tenths
  double energy = 0.0;  // sum of glow x solid angle
};

Glow glow_of(const Scene& scene, const RadianceImage& bloom) {
  std::vector<std::pair<double, double>> shares;  // distance in degrees, energy
  const double middle = 0.5 * scene.image.height;
  for (int y = 0; y < bloom.height; ++y) {
    for (int x = 0; x < bloom.width; ++x) {
      const double off = std::hypot(x + 0.5 - middle, y + 0.5 - middle) / middle;
      shares.emplace_back(std::atan(off * std::tan(15.0 * kDegree)) / kDegree,
                          channel_of(bloom, x, y, 1) * solid_angle(scene, x, y));
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

// In mips of the picture's own size the glow's radius is 5.9, 4.6, 3.4 degrees at 270, 540, 1080 lines.
TEST(Bloom, IsAsWideInAngleAtEveryResolution) {
  std::vector<Glow> glows;
  for (const int lines : {135, 270, 540, 1080}) {
    const Scene scene = lone_sun(lines);
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
  Scene scene = lone_sun(90);
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

double linear(std::uint16_t code) {  // IEC 61966-2-1
  const double y = code / 65535.0;
  return y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
}

// The tone pass samples the chain by itself: what it shows is the picture and the bloom that others are given.
TEST(Bloom, IsInTheToneCurveAsItIsInItsPicture) {
  Scene round = all_round(lone_sun(8), 0.001, 72, 36);
  round.sun.azimuth = std::numbers::pi;  // on the seam
  for (Scene scene : {lone_sun(90), round}) {
    scene.display.tonemap = ToneCurve::clamp;
    scene.display.exposure = 0.5;
    scene.bloom.intensity = 0.01;
    const Rendering seen = with_bloom(scene);
    ASSERT_TRUE(seen.bloom.has_value());
    RenderRequest request;
    request.bloom = true;
    request.bloom_picture = false;
    request.gpu_tone = true;
    const Rendering shown = render_now(scene, request);
    EXPECT_FALSE(shown.bloom.has_value());
    ASSERT_EQ(shown.encoded.size(), seen.radiance.rgba.size());
    int lit = 0;
    for (std::size_t i = 0; i < shown.encoded.size(); ++i) {
      const double sum = static_cast<double>(seen.radiance.rgba[i]) + 0.01 * static_cast<double>(seen.bloom->rgba[i]);
      if (i % 4 != 3) {
        EXPECT_NEAR(linear(shown.encoded[i]), std::min(0.5 * sum, 1.0), 5e-5) << i;
        lit += 0.5 * sum > 1e-3 && 0.5 * sum < 1.0 ? 1 : 0;
      }
    }
    EXPECT_GT(lit, 100);
  }
}

TEST(Bloom, LeavesThePictureAlone) {
  const Scene scene = lone_sun(60);
  EXPECT_TRUE(with_bloom(scene).radiance.rgba == render_now(scene).radiance.rgba);
}

TEST(Bloom, IsLeftOutWhereNothingExceedsItsThreshold) {
  Scene scene = lone_sun(60);
  scene.display.exposure = 1e-6;
  const Rendering dim = with_bloom(scene);
  EXPECT_FALSE(dim.bloom.has_value());
  EXPECT_TRUE(std::any_of(dim.left_out.begin(), dim.left_out.end(),
                          [](const std::string& line) { return line.starts_with("bloom: nothing is brighter"); }));
  scene.display.exposure = 1.0;
  scene.bloom.enabled = false;
  EXPECT_FALSE(with_bloom(scene).bloom.has_value());
}

// A picture that goes all the way round has no seam: the glow of a sun on its edge is that of a sun in its middle.
TEST(Bloom, GoesOnAcrossTheSeam) {
  Scene scene = all_round(lone_sun(8), 0.001, 144, 72);
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
  const Scene scene = lone_sun(120);
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
