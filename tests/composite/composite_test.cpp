// Depth, blending, cameras and fogs of `airlight composite`, checked by hand-computed values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/composite/blend.h"
#include "core/composite/camera.h"
#include "core/composite/depth.h"
#include "core/composite/fog.h"
#include "tests/of_scene.h"

namespace airlight::composite {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(CompositeDepth, EachKindBecomesADistance) {
  EXPECT_FLOAT_EQ(distance_of(2500.0, DepthKind::distance, 1e-3, 0.5), 2.5F);
  EXPECT_FLOAT_EQ(distance_of(2500.0, DepthKind::planar, 1e-3, 0.5), 5.0F);
  EXPECT_FLOAT_EQ(distance_of(1.0 / 2500.0, DepthKind::inverse, 1e-3, 0.5), 5.0F);
}

TEST(CompositeDepth, WhatIsNoDepthIsSky) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, -1.0, nan, infinity, 1e9, 1e10}) {
    EXPECT_EQ(distance_of(value, DepthKind::distance, 1e-3, 1.0), kSky) << value;
  }
  EXPECT_EQ(distance_of(0.0, DepthKind::inverse, 1e-3, 1.0), kSky);
  EXPECT_EQ(distance_of(1e-10, DepthKind::inverse, 1e-3, 1.0), kSky);
  EXPECT_EQ(distance_of(5.0, DepthKind::planar, 1e-3, -0.1), kSky);  // behind the camera
  DepthCounts counts;
  const std::vector<float> values{1.0F, std::numeric_limits<float>::quiet_NaN(), 1e10F};
  const std::vector<float> cosines{1.0F, 1.0F, 1.0F};
  EXPECT_EQ(distances(values, DepthKind::distance, 1.0, cosines, {}, counts).size(), 3U);
  EXPECT_EQ(counts.sky, 2U);
  EXPECT_EQ(counts.nan, 1U);
}

const AirTo kAir{{0.1F, 0.2F, 0.3F}, {0.9F, 0.8F, 0.7F}};
const Rgb kSkyColour{1.0F, 2.0F, 4.0F};

TEST(CompositeBlend, OpaqueAndEmptyAndHalf) {
  const Rgb opaque = behind_air({{0.5F, 0.5F, 0.5F}, 1.0F}, kAir, kSkyColour);
  EXPECT_FLOAT_EQ(opaque[0], 0.5F * 0.9F + 0.1F);
  EXPECT_EQ(behind_air({{}, 0.0F}, AirTo{{}, {1.0F, 1.0F, 1.0F}}, kSkyColour), kSkyColour);  // bit for bit
  // Half a thing: the whole sky, including the air before the thing, shows through it.
  const Rgb half = behind_air({{0.25F, 0.25F, 0.25F}, 0.5F}, kAir, kSkyColour);
  EXPECT_FLOAT_EQ(half[2], 0.25F * 0.7F + 0.5F * 0.3F + 0.5F * 4.0F);
}

// One sample equals a flat pixel, and a sample without cover changes nothing.
TEST(CompositeBlend, DeepAgreesWithFlat) {
  const Thing thing{{0.2F, 0.3F, 0.4F}, 0.6F};
  const AirTo nearer{{0.05F, 0.1F, 0.15F}, {0.95F, 0.9F, 0.85F}};
  const Rgb flat = behind_air(thing, kAir, kSkyColour);
  const std::vector<Thing> things{{{}, 0.0F}, thing};
  const std::vector<AirTo> airs{nearer, kAir};
  const Rgb deep = behind_air(things, airs, kSkyColour);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(deep[c], flat[c], 1e-6F);
  }
  EXPECT_EQ(behind_air(std::span<const Thing>(), {}, kSkyColour), kSkyColour);
}

// The parts together transmit and send what the whole does.
TEST(CompositeBlend, SplitSamplesAddUp) {
  const Thing thing{{0.3F, 0.6F, 0.9F}, 0.7F};
  Rgb sum{};
  double clear = 1.0;
  for (const Thing& part : split(thing, 5)) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += static_cast<float>(clear) * part.colour[c];
    }
    clear *= 1.0 - static_cast<double>(part.alpha);
  }
  EXPECT_NEAR(clear, 0.3, 1e-6);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sum[c], thing.colour[c], 1e-6F);
  }
}

// Our own matrix, read back, gives every angle and the altitude.
TEST(CompositeCamera, WorldToCameraGivesBackTheAngles) {
  for (const double pitch : {-90.0, -30.0, 0.0, 10.0, 80.0}) {
    Camera camera;
    camera.altitude = 2.5;
    camera.azimuth = 200.0 * kDegree;
    camera.pitch = pitch * kDegree;
    camera.roll = std::abs(pitch) == 90.0 ? 0.0 : 25.0 * kDegree;
    const CameraBasis b = camera_basis(camera);
    // The rows of the inverse are the axes and the place in the world. The matrix has the transposed axes.
    const physics::vec3 back = b.forward * -1.0;
    const Matrix m{b.right.x, b.up.x, back.x, 0.0, b.right.y,        b.up.y,        back.y,        0.0,
                   b.right.z, b.up.z, back.z, 0.0, -2.5 * b.right.y, -2.5 * b.up.y, -2.5 * back.y, 1.0};
    const FileCamera found = camera_of("f", m, std::nullopt, UpAxis::y, 1.0);
    EXPECT_NEAR(found.altitude, 2.5, 1e-9);
    EXPECT_NEAR(std::remainder(found.azimuth - camera.azimuth, 2.0 * std::numbers::pi), 0.0, 1e-9) << pitch;
    EXPECT_NEAR(found.pitch, camera.pitch, 1e-7);
    EXPECT_NEAR(found.roll, camera.roll, 1e-9) << pitch;
    EXPECT_FALSE(found.vertical_fov.has_value());
    // RenderMan's camera space looks along +z: its third column turned over is the same camera.
    Matrix left = m;
    for (std::size_t i = 2; i < 16; i += 4) {
      left[i] = -left[i];
    }
    EXPECT_NEAR(camera_of("f", left, std::nullopt, UpAxis::y, 1.0).pitch, camera.pitch, 1e-7);
  }
}

// Blender's world: z up, y north, metres. The camera is 100 m up and looks north, 10 degrees down, through a 40 degree
// lens.
TEST(CompositeCamera, WorldToNdcHoldsTheLens) {
  const double s = std::sin(10.0 * kDegree);
  const double c = std::cos(10.0 * kDegree);
  const double cot = 1.0 / std::tan(20.0 * kDegree);
  // Camera axes: right (1,0,0), up (0,s,c), forward (0,c,-s); w = along forward.
  const Matrix m{cot / 1.5,       0.0,      0.0, 0.0, 0.0, cot * s, c, c, 0.0, cot * c, -s, -s, 0.0, -100.0 * cot * c,
                 100.0 * s - 0.1, 100.0 * s};
  const FileCamera found = camera_of("f", std::nullopt, m, UpAxis::z, 1e-3);
  EXPECT_NEAR(found.altitude, 0.1, 1e-9);
  EXPECT_NEAR(found.azimuth, 0.0, 1e-9);
  EXPECT_NEAR(found.pitch, -10.0 * kDegree, 1e-9);
  EXPECT_NEAR(found.roll, 0.0, 1e-9);
  EXPECT_NEAR(found.vertical_fov.value_or(0.0), 40.0 * kDegree, 1e-9);
  Matrix shifted = m;
  for (std::size_t i = 0; i < 4; ++i) {
    shifted[4 * i] += 0.2 * m[4 * i + 3];  // x + 0.2 w
  }
  EXPECT_THROW(camera_of("f", std::nullopt, shifted, UpAxis::z, 1e-3), InputError);
  EXPECT_THROW(camera_of("f", std::nullopt, Matrix{}, UpAxis::z, 1e-3), InputError);
  EXPECT_THROW(camera_of("f", std::nullopt, std::nullopt, UpAxis::z, 1e-3), InputError);
}

Fog fog_of_kind(FogKind kind) {
  Fog fog;
  fog.kind = kind;
  return fog;
}

// The published forms at one distance, with numbers computed by hand.
TEST(CompositeFog, ClosedForms) {
  const FogRay ray{10.0, 0.0, 0.2, 0.9};
  const FogTerms even = fog_terms(fog_of_kind(FogKind::exponential), ray);
  EXPECT_NEAR(even.keeps.x, 0.36787944117, 1e-10);
  EXPECT_NEAR(even.adds.y, 0.6 * 0.63212055883, 1e-10);
  const FogTerms tinted = fog_terms(fog_of_kind(FogKind::sun_tinted), ray);
  const double toward = std::pow(0.9, 8);  // 0.43046721
  EXPECT_NEAR(tinted.adds.x, (0.5 + 0.5 * toward) * 0.63212055883, 1e-10);
  EXPECT_NEAR(fog_terms(fog_of_kind(FogKind::sun_tinted), {10.0, 0.0, 0.2, -0.9}).adds.x, 0.5 * 0.63212055883, 1e-10);
  const FogTerms parts = fog_terms(fog_of_kind(FogKind::extinction_inscatter), ray);
  EXPECT_NEAR(parts.keeps.z, std::exp(-0.3), 1e-12);
  EXPECT_NEAR(parts.adds.x, 0.5 * (1.0 - std::exp(-0.15)), 1e-12);
}

// The amount is the integral of a exp(-b y) along the ray, here by ten thousand midpoints: level, rising and falling.
TEST(CompositeFog, HeightFogIsAnIntegral) {
  const Fog fog = fog_of_kind(FogKind::height);
  for (const double rise : {-0.1, -1e-9, 0.0, 1e-9, 1e-3, 0.5}) {
    const FogRay ray{4.0, 1.5, rise, 0.0};
    double sum = 0.0;
    constexpr int kSteps = 10000;
    for (int i = 0; i < kSteps; ++i) {
      sum += 0.5 * std::exp(-0.3 * (1.5 + rise * 4.0 * (i + 0.5) / kSteps)) * 4.0 / kSteps;
    }
    EXPECT_NEAR(height_fog_amount(fog, ray), sum, 1e-8) << rise;
    const double held = std::min(sum, 1.0);
    EXPECT_NEAR(fog_terms(fog, ray).keeps.x, 1.0 - held, 1e-7);
    Fog exact = fog;
    exact.exact = true;
    EXPECT_NEAR(fog_terms(exact, ray).keeps.x, std::exp(-sum), 1e-7);
  }
}

TEST(CompositeFog, NothingAtNoDistance) {
  for (const FogKind kind :
       {FogKind::exponential, FogKind::sun_tinted, FogKind::height, FogKind::extinction_inscatter}) {
    const FogTerms terms = fog_terms(fog_of_kind(kind), {0.0, 0.5, 0.3, 0.7});
    EXPECT_EQ(terms.keeps.x, 1.0);
    EXPECT_EQ(terms.adds.x, 0.0);
  }
}

}  // namespace
}  // namespace airlight::composite
