
#include "core/library/validity.h"

#include <gtest/gtest.h>

#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/scene/angle.h"

namespace airlight::test {
namespace {

// Air of a vertical optical depth of 0.05 per km x 10 km x (1 - exp(-10)), 0.49998, in its densest channel.
Scene plain_scene() {
  Scene scene;
  Medium medium;
  medium.name = "air";
  medium.scattering = {0.01, 0.03, 0.05};
  medium.density.profile = DensityProfile::exponential;
  medium.density.scale_height = 10.0;
  scene.media = {medium};
  scene.sun.elevation = radians_from_degrees(-3.0);
  scene.camera.altitude = 20.0;
  return scene;
}

TEST(Validity, NoLimitHoldsForEverything) {
  EXPECT_TRUE(exceeded_limits({}, ready(plain_scene())).empty());
}

TEST(Validity, EachLimitIsNamedWithBothNumbers) {
  Validity validity;
  validity.sun_elevation_min = radians_from_degrees(-2.0);
  validity.altitude_max = 10.0;
  validity.optical_depth_max = 0.4;
  const std::vector<std::string> limits = exceeded_limits(validity, ready(plain_scene()));
  ASSERT_EQ(limits.size(), 3U);
  EXPECT_EQ(limits[0], "a sun below -2 degrees (it is at -3)");
  EXPECT_EQ(limits[1], "a camera above 10 km (it is at 20)");
  EXPECT_EQ(limits[2], "air of a vertical optical depth above 0.4 (it is 0.5)");
}

TEST(Validity, ALimitThatIsJustMetHolds) {
  Validity validity;
  validity.sun_elevation_min = plain_scene().sun.elevation;
  validity.altitude_max = 20.0;
  validity.optical_depth_max = 0.51;
  EXPECT_TRUE(exceeded_limits(validity, ready(plain_scene())).empty());
}

TEST(Validity, TheWarningIsEmptyWhereTheMethodHolds) {
  Scene scene = plain_scene();
  scene.sun.elevation = radians_from_degrees(45.0);
  scene.camera.altitude = 0.001;
  scene.render.method = "march";
  EXPECT_EQ(validity_warning(ready(scene)), "");
}

Scene rendered_by(std::string_view method) {
  Scene scene = with_quality(plain_scene(), *find_method(method), {});
  scene.sun.elevation = radians_from_degrees(45.0);
  scene.camera.altitude = 0.001;
  scene.camera.vertical_fov = radians_from_degrees(60.0);
  scene.image = {64, 36};
  return scene;
}

// A planet so large that dusk passes within a degree: orders is up to 7 % off there (core/STABILITY.md).
TEST(Validity, AKnownFailureIsTold) {
  Scene scene = rendered_by("orders");
  scene.planet.ground_radius = 1e6;
  EXPECT_EQ(known_failure_warning(ready(scene)), "");
  scene.sun.elevation = radians_from_degrees(-3.0);
  EXPECT_EQ(known_failure_warning(ready(scene)).rfind("method orders is known to be wrong here: a planet so large", 0),
            0U)
      << known_failure_warning(ready(scene));
  ASSERT_FALSE(scene_warnings(ready(scene)).empty());
  EXPECT_EQ(scene_warnings(ready(scene)).front(), known_failure_warning(ready(scene)));
  EXPECT_TRUE(scene_warnings(ready(scene), true).empty());  // with a tolerance, which has measured the error
}

// What methods lack over an ocean under a low sun is told as well.
TEST(Validity, AFailureAmongThingsIsTold) {
  Scene scene = rendered_by("orders");
  scene.sun.elevation = radians_from_degrees(7.0);
  EXPECT_EQ(known_failure_warning(ready(scene)), "");
  scene.ground.emplace().ocean.emplace();
  EXPECT_EQ(known_failure_warning(ready(scene)).rfind("method orders is known to be wrong here: an ocean", 0), 0U);
  scene.spheres.emplace_back();  // which not every method knows
  EXPECT_TRUE(known_failure_warning(ready(scene)).ends_with("; methods that hold: path-trace"));
  scene.sun.elevation = radians_from_degrees(45.0);
  EXPECT_EQ(known_failure_warning(ready(scene)), "");
}

// The failure exists only where nothing absorbs: for molecules over a white ground, not over a grey one.
TEST(Validity, WhatKeepsAllLightIsAQuantityOfItsOwn) {
  Scene scene = rendered_by("march");
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  EXPECT_NE(known_failure_warning(ready(scene)).find("white ground"), std::string::npos);
  EXPECT_EQ(known_failure_warning(ready(scene)).find("methods that hold: march"), std::string::npos);
  scene.planet.ground_albedo = {0.5, 0.5, 0.5};
  EXPECT_EQ(known_failure_warning(ready(scene)), "");
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  scene.media.front().absorption = {0.01, 0.01, 0.01};
  EXPECT_EQ(known_failure_warning(ready(scene)), "");
}

// The method's own quality is covered by its claim; a coarser one is not.
TEST(Validity, FewStepsAreTold) {
  Scene scene = rendered_by("march");
  scene.render.parameters["steps"] = 8;
  EXPECT_EQ(known_failure_warning(ready(scene)).rfind("method march is known to be wrong here: few steps; methods", 0),
            0U)
      << known_failure_warning(ready(scene));
  EXPECT_NE(known_failure_warning(ready(scene)).find("orders"), std::string::npos);
}

}  // namespace
}  // namespace airlight::test
