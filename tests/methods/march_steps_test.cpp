// The march's choices where its keys leave steps and resolution to the scene.

#include "core/methods/march_steps.h"

#include "core/methods/marched_picture.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/stage/wavelengths.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using Parameters = std::vector<std::pair<std::string_view, ParameterValue>>;

Scene marched(Scene scene, const Parameters& values = {}) {
  return with_quality(std::move(scene), *find_method("march"), {"", values});
}

std::string text(const char* value) {
  return value;
}

MarchSteps chosen(const Scene& scene) {
  return march_steps(part_of(scene));
}

constexpr MarchSteps kUsual{kUsualSteps, physics::kStepsQuadratic};

Scene by_day(double altitude = 0.001, double elevation = 20.0) {
  Scene scene = earth();
  scene.sun.elevation = elevation * kDegree;
  scene.camera.altitude = altitude;
  return marched(scene);
}

// Haze `share` times as thick as the air's own aerosol takes more nodes, until they cost as much as steps.
TEST(AutomaticSteps, AreNodesInSmoothAirAsManyAsItsThicknessAsksFor) {
  const auto hazy = [](double share) {
    Scene scene = by_day();
    for (std::size_t c = 0; c < 3; ++c) {
      scene.media[1].scattering[c] *= share;
      scene.media[1].absorption[c] *= share;
    }
    return chosen(scene);
  };
  EXPECT_EQ(hazy(1.0), (MarchSteps{14, physics::kStepsGaussLegendre}));
  EXPECT_EQ(hazy(10.0), (MarchSteps{16, physics::kStepsGaussLegendre}));
  EXPECT_EQ(hazy(1000.0), kUsual);
  int last = 14;
  for (double share = 1.0; share < 1000.0 && hazy(share) != kUsual; share *= 1.1) {
    EXPECT_GE(hazy(share).count, last);
    EXPECT_LE(hazy(share).count, 24);
    last = hazy(share).count;
  }
  EXPECT_GE(last, 22);
}

TEST(AutomaticSteps, AreQuadraticWhereADensityHasAnEdge) {
  Medium fog = medium("fog", {0.3, 0.3, 0.3}, {}, exponential(1.0), PhaseFunction::henyey_greenstein, 0.7);
  for (const DensityProfile profile : {DensityProfile::constant, DensityProfile::height_fog, DensityProfile::tent}) {
    Scene scene = by_day();
    fog.density.profile = profile;
    fog.density.below = 0.5;
    fog.density.scale_height = 0.1;
    fog.density.center = 1.0;
    fog.density.half_width = 0.5;
    scene.media.push_back(fog);
    EXPECT_EQ(chosen(scene), kUsual);
    scene.media.back().scattering = {1e-3, 1e-3, 1e-3};  // of no account
    EXPECT_EQ(chosen(scene).count, 14);
  }
  // The whole air is thin, but the air at the ground is thick.
  Scene low = by_day();
  fog.density = exponential(0.1);
  low.media.push_back(fog);
  EXPECT_EQ(chosen(low), kUsual);
}

TEST(AutomaticSteps, AreQuadraticWhereNightIsInSight) {
  EXPECT_EQ(chosen(by_day(0.0, 0.0)).count, 14);
  EXPECT_EQ(chosen(by_day(0.0, -0.1)), kUsual);
  EXPECT_EQ(chosen(by_day(10.0, 4.0)).count, 14);
  EXPECT_EQ(chosen(by_day(10.0, 3.0)), kUsual);
}

TEST(AutomaticSteps, AreQuadraticAboveMostOfTheAir) {
  EXPECT_EQ(chosen(by_day(12.0, 60.0)).count, 14);
  EXPECT_EQ(chosen(by_day(35.0, 60.0)), kUsual);
  EXPECT_EQ(chosen(by_day(100.0, 60.0)), kUsual);
  EXPECT_EQ(chosen(by_day(500.0, 60.0)), kUsual);
}

TEST(AutomaticSteps, LeaveWhatIsToldAsItIs) {
  const auto told = [](const Parameters& values) { return chosen(marched(by_day(), values)); };
  EXPECT_EQ(told({{"steps", 12}}), (MarchSteps{12, physics::kStepsQuadratic}));
  EXPECT_EQ(told({{"step_distribution", text("uniform")}}), (MarchSteps{32, physics::kStepsUniform}));
  EXPECT_EQ(told({{"step_distribution", text("quadratic")}}), kUsual);
  EXPECT_EQ(told({{"step_distribution", text("gauss-legendre")}}), (MarchSteps{32, physics::kStepsGaussLegendre}));
  EXPECT_EQ(told({{"steps", 7}, {"step_distribution", text("gauss-legendre")}}),
            (MarchSteps{7, physics::kStepsGaussLegendre}));
  EXPECT_EQ(told({{"jitter", text("blue-noise")}}), kUsual);
}

// Half resolution is used where pixels are so fine that it adds no error, unless a key is given.
TEST(AutomaticSteps, HalveFinePixelsAlone) {
  Scene scene = by_day();
  scene.camera.vertical_fov = 60.0 * kDegree;
  scene.image = {640, 360};
  EXPECT_FALSE(halves(scene));  // 0.18 degrees
  scene.image = {1280, 720};
  EXPECT_TRUE(halves(scene));
  scene.sun.elevation = -4.0 * kDegree;
  EXPECT_TRUE(halves(scene));
  const auto told = [&](const Parameters& values) { return halves(marched(scene, values)); };
  EXPECT_FALSE(told({{"resolution", text("full")}}));
  EXPECT_FALSE(told({{"steps", 32}}));
  EXPECT_FALSE(told({{"step_distribution", text("gauss-legendre")}}));
  EXPECT_FALSE(told({{"jitter", text("fixed")}}));
  EXPECT_TRUE(told({{"steps", 32}, {"resolution", text("half")}}));
  scene.camera.projection = Projection::cube;
  EXPECT_FALSE(halves(scene));
}

Scene narrow() {
  Scene scene = by_day();
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.vertical_fov = 6.0 * kDegree;
  scene.camera.pitch = 2.0 * kDegree;
  scene.image = {77, 49};
  return scene;
}

// The chosen picture is the one that its keys give, bit for bit.
TEST(AutomaticSteps, MakeThePictureOfTheirKeys) {
  const Scene scene = narrow();
  const Scene told =
      marched(scene, {{"steps", 14}, {"step_distribution", text("gauss-legendre")}, {"resolution", text("half")}});
  const Rendering chosen_picture = render_now(scene);
  EXPECT_TRUE(chosen_picture.radiance.rgba == render_now(told).radiance.rgba);
  EXPECT_EQ(chosen_picture.left_out.size(), render_now(told).left_out.size() + 2);
  EXPECT_FALSE(chosen_picture.radiance.rgba == render_now(marched(scene, {{"steps", 32}})).radiance.rgba);
}

// All wavelengths of a scene are marched alike, though the air is thicker at some.
TEST(AutomaticSteps, AreTheSameAtAllWavelengths) {
  Scene scene = resolve(load_preset(std::string(AIRLIGHT_SOURCE_DIR) + "/presets/earth-noon.json"), method_infos());
  scene = marched(scene);
  scene.spectra->wavelengths = 24;
  const MarchSteps steps = chosen(scene);
  EXPECT_EQ(steps.distribution, physics::kStepsGaussLegendre);
  const Stage stage = ready(scene);
  for (const Part& group : stage.parts()) {
    EXPECT_EQ(chosen(group.scene), steps);
    EXPECT_EQ(halves(group.scene), halves(scene));
  }
}

}  // namespace
}  // namespace airlight::test
