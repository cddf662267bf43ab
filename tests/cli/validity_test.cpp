#include "app/render/validity.h"

#include <gtest/gtest.h>

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
  EXPECT_TRUE(cli::exceeded_limits({}, plain_scene()).empty());
}

TEST(Validity, EachLimitIsNamedWithBothNumbers) {
  Validity validity;
  validity.sun_elevation_min = radians_from_degrees(-2.0);
  validity.altitude_max = 10.0;
  validity.optical_depth_max = 0.4;
  const std::vector<std::string> limits = cli::exceeded_limits(validity, plain_scene());
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
  EXPECT_TRUE(cli::exceeded_limits(validity, plain_scene()).empty());
}

TEST(Validity, TheWarningIsEmptyWhereTheMethodHolds) {
  Scene scene = plain_scene();
  scene.sun.elevation = radians_from_degrees(45.0);
  scene.camera.altitude = 0.001;
  scene.render.method = "march";
  EXPECT_EQ(cli::validity_warning(scene), "");
}

}  // namespace
}  // namespace airlight::test
