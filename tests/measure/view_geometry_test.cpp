#include "core/measure/view_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/output/files.h"

namespace airlight::measure {
namespace {

PixelFrame whole(int width, int height) {
  return {.width = width, .height = height, .left = 0, .top = 0, .columns = width, .rows = height};
}

Viewpoint all_round(double altitude_km, double sun_elevation_deg) {
  Viewpoint viewpoint;
  viewpoint.camera.projection = Projection::equirectangular;
  viewpoint.camera.altitude = altitude_km;
  viewpoint.camera.azimuth = 90.0 * kDegree;
  viewpoint.sun_elevation = sun_elevation_deg * kDegree;
  viewpoint.sun_azimuth = 90.0 * kDegree;
  return viewpoint;
}

std::size_t count(const std::vector<RegionBits>& regions, Region region) {
  std::size_t result = 0;
  for (const RegionBits bits : regions) result += (bits & region) != 0 ? 1U : 0U;
  return result;
}

TEST(ViewGeometry, EquirectangularAngles) {
  const auto look = look_direction(all_round(0.001, 20.0), whole(360, 180), 180, 0);
  ASSERT_TRUE(look);
  EXPECT_NEAR(look->elevation / kDegree, 89.5, 1e-9);
  EXPECT_NEAR(look->azimuth / kDegree, 90.5, 1e-9);
  const auto left = look_direction(all_round(0.001, 20.0), whole(360, 180), 0, 90);
  EXPECT_NEAR(left->elevation / kDegree, -0.5, 1e-9);
  EXPECT_NEAR(left->azimuth / kDegree, 270.5, 1e-9);
}

TEST(ViewGeometry, DistanceFromTheSun) {
  // Pixel (180, 69): elevation 20.5, azimuth 90.5; the sun at 20, 90.
  const auto look = look_direction(all_round(0.001, 20.0), whole(360, 180), 180, 69);
  const double expected = std::acos(std::sin(20.5 * kDegree) * std::sin(20.0 * kDegree) +
                                    std::cos(20.5 * kDegree) * std::cos(20.0 * kDegree) * std::cos(0.5 * kDegree));
  EXPECT_NEAR(look->sun_distance, expected, 1e-9);
}

// At 1 m the true horizon is 0.032 degrees down: rows of one degree divide at the middle.
TEST(ViewGeometry, RegionsFromTheGround) {
  const auto regions = classify(all_round(0.001, 20.0), whole(360, 180));
  EXPECT_EQ(count(regions, kSky), 360U * 90U);
  EXPECT_EQ(count(regions, kGround), 360U * 90U);
  EXPECT_EQ(count(regions, kHorizon), 360U * 3U);  // rows at 0.5, 1.5 and 2.5 degrees
  EXPECT_EQ(count(regions, kZenith), 360U * 15U);
}

TEST(ViewGeometry, AureoleIsACircleAroundTheSunAboveTheHorizon) {
  // Solid angle of the cap: 2 pi (1 - cos 10 degrees).
  const PixelFrame frame = whole(720, 360);
  const auto regions = classify(all_round(0.001, 30.0), frame);
  double solid_angle = 0.0;
  for (int row = 0; row < frame.rows; ++row) {
    const double pixel = std::cos((90.0 - (row + 0.5) / 2.0) * kDegree) * 0.25 * kDegree * kDegree;
    for (int column = 0; column < frame.columns; ++column) {
      if ((regions[static_cast<std::size_t>(row * frame.columns + column)] & kAureole) != 0) solid_angle += pixel;
    }
  }
  EXPECT_NEAR(solid_angle, 2.0 * std::acos(-1.0) * (1.0 - std::cos(10.0 * kDegree)), 2e-3);
  const auto low = classify(all_round(0.001, 0.0), frame);
  for (std::size_t i = 0; i < low.size(); ++i) EXPECT_FALSE((low[i] & kAureole) != 0 && (low[i] & kGround) != 0);
  EXPECT_EQ(count(classify(all_round(0.001, -15.0), frame), kAureole), 0U);
}

// From 500 km the horizon is acos(6360 / 6860) = 22.0 degrees down.
TEST(ViewGeometry, TrueHorizonSinksWithAltitude) {
  const auto regions = classify(all_round(500.0, 20.0), whole(4, 1800));
  const double dip = std::acos(6360.0 / 6860.0) / kDegree;
  EXPECT_NEAR(static_cast<double>(count(regions, kGround)) / 4.0 / 10.0, 90.0 - dip, 0.1);
  EXPECT_NEAR(static_cast<double>(count(regions, kHorizon)) / 4.0 / 10.0, 3.0, 0.11);
}

TEST(ViewGeometry, FisheyeHasNothingOutsideItsCircle) {
  Viewpoint viewpoint = all_round(0.001, 20.0);
  viewpoint.camera.projection = Projection::fisheye;
  viewpoint.camera.pitch = 90.0 * kDegree;
  viewpoint.camera.vertical_fov = 180.0 * kDegree;
  const auto regions = classify(viewpoint, whole(100, 100));
  EXPECT_EQ(regions.front(), 0);
  EXPECT_FALSE(look_direction(viewpoint, whole(100, 100), 0, 0));
  EXPECT_NEAR(static_cast<double>(count(regions, kSky)), 100.0 * 100.0 * std::acos(-1.0) / 4.0, 60.0);
  EXPECT_NEAR(look_direction(viewpoint, whole(101, 101), 50, 50)->elevation / kDegree, 90.0, 1e-6);
}

TEST(ViewGeometry, PerspectiveCentreLooksWhereTheCameraDoes) {
  Viewpoint viewpoint = all_round(0.001, 20.0);
  viewpoint.camera.projection = Projection::perspective;
  viewpoint.camera.pitch = 12.0 * kDegree;
  viewpoint.camera.vertical_fov = 60.0 * kDegree;
  const auto centre = look_direction(viewpoint, whole(101, 51), 50, 25);
  EXPECT_NEAR(centre->elevation / kDegree, 12.0, 1e-9);
  EXPECT_NEAR(centre->azimuth / kDegree, 90.0, 1e-9);
  EXPECT_GT(look_direction(viewpoint, whole(101, 51), 100, 25)->azimuth / kDegree, 91.0);
}

TEST(ViewGeometry, StoredPartKnowsItsPlace) {
  PixelFrame part = whole(360, 180);
  part.left = 10;
  part.top = 20;
  part.columns = 5;
  part.rows = 5;
  const Viewpoint viewpoint = all_round(0.001, 20.0);
  EXPECT_EQ(look_direction(viewpoint, part, 1, 2)->elevation,
            look_direction(viewpoint, whole(360, 180), 11, 22)->elevation);
  EXPECT_EQ(classify(viewpoint, part).size(), 25U);
}

TEST(ViewGeometry, ReadsAResolvedPreset) {
  const Viewpoint viewpoint = viewpoint_from_preset(
      R"({"planet":{"radius_km":3390},"sun":{"elevation_deg":5,"azimuth_deg":100},"camera":{"altitude_km":2,)"
      R"("azimuth_deg":90,"pitch_deg":10,"roll_deg":-5,"projection":"fisheye","vertical_fov_deg":120}})");
  EXPECT_EQ(viewpoint.ground_radius, 3390.0);
  EXPECT_NEAR(viewpoint.sun_elevation, 5.0 * kDegree, 1e-15);
  EXPECT_NEAR(viewpoint.sun_azimuth, 100.0 * kDegree, 1e-15);
  EXPECT_EQ(viewpoint.camera.altitude, 2.0);
  EXPECT_EQ(viewpoint.camera.projection, Projection::fisheye);
  EXPECT_NEAR(viewpoint.camera.pitch, 10.0 * kDegree, 1e-15);
  EXPECT_NEAR(viewpoint.camera.roll, -5.0 * kDegree, 1e-15);
  EXPECT_NEAR(viewpoint.camera.vertical_fov, 120.0 * kDegree, 1e-15);
}

TEST(ViewGeometry, RefusesAPresetWithoutACamera) {
  const auto said = [](std::string_view preset) {
    return test::message_of<InputError>([&] { viewpoint_from_preset(preset); });
  };
  const std::string damaged = "the preset that it carries is damaged: it ";
  EXPECT_EQ(said("{"), damaged + "is not JSON from byte 2 on; render or copy the picture again");
  for (const char* preset : {"[]", R"({"camera":{}})"}) {
    EXPECT_EQ(said(preset), damaged + "does not tell camera, sun and planet; render or copy the picture again");
  }
}

}  // namespace
}  // namespace airlight::measure
