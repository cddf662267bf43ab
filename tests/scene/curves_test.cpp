// Curves over the wavelength in a preset: every form, every refusal, and the way back to JSON.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

#include "core/scene/curve_reader.h"
#include "core/scene/density_column.h"
#include "core/spectra/data.h"
#include "tests/of_scene.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

// A preset of one medium with this scattering and more keys.
std::string with_scattering(const std::string& scattering, const std::string& extra = "") {
  return R"({"airlight": 1, "media": [{"name": "a", "scattering_per_km": )" + scattering +
         R"(, "density": {"profile": "exponential", "scale_height_km": 8}}])" + (extra.empty() ? "" : ", " + extra) +
         "}";
}

constexpr const char* kSamples = R"({"wavelengths_nm": [400, 700], "values": [0.03, 0.01]})";

TEST(Curves, AreReadInEveryForm) {
  EXPECT_FALSE(scene_from(with_scattering("0.01")).spectra.has_value());
  EXPECT_FALSE(scene_from(with_scattering("[0.01, 0.02, 0.03]")).spectra.has_value());
  const Scene sampled = scene_from(with_scattering(kSamples));
  ASSERT_TRUE(sampled.spectra);
  EXPECT_NEAR(value_at(sampled.media[0].scattering.curve, 550.0), 0.02, 1e-15);
  EXPECT_EQ(value_at(sampled.media[0].absorption.curve, 550.0), 0.0);
  EXPECT_EQ(value_at(sampled.spectra->sun, 555.0), value_at(solar_irradiance(), 555.0));
  const Scene power = scene_from(with_scattering(R"({"at_nm": 550, "value": 0.0114, "exponent": -1.3})"));
  EXPECT_NEAR(value_at(power.media[0].scattering.curve, 440.0), 0.0114 * std::pow(0.8, -1.3), 1e-12);
  const Scene air = scene_from(with_scattering(R"({"named": "air", "scale": 2})"));
  EXPECT_NEAR(value_at(air.media[0].scattering.curve, 500.0), 2.0 * rayleigh_scattering(500.0), 1e-12);
  const Scene lamp = scene_from(with_scattering("0.01", R"("sun": {"spectrum": {"black_body_k": 3000}})"));
  EXPECT_NEAR(value_at(lamp.spectra->sun, 560.0), 1.0, 1e-12);
  EXPECT_GT(value_at(lamp.spectra->sun, 700.0), 1.5);
}

// The channels that stand for the curves in code for three channels: 615, 541 and 449 nm.
TEST(Curves, FillTheChannels) {
  const Scene scene = scene_from(with_scattering(kSamples, R"("sun": {"irradiance": 3})"));
  const double nm[] = {615.0, 541.0, 449.0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(scene.media[0].scattering[c], 0.03 - 0.02 * (nm[c] - 400.0) / 300.0, 1e-12);
    EXPECT_NEAR(scene.sun.irradiance[c], 3.0, 1e-9);
  }
}

// Media are checked before the channels of their curves are found: until then these are 0, whatever stood there before.
TEST(Curves, ChannelsBeginAsZeros) {
  alignas(SpectralValue) std::array<std::byte, sizeof(SpectralValue)> place;
  std::byte* const bytes = place.data();
  std::memset(bytes, 0x42, sizeof place);      // doubles of 1.6e11
  asm volatile("" : : "r"(bytes) : "memory");  // they stay, though nothing reads them
  const auto* value = new (bytes) SpectralValue;
  for (const double channel : *value) {
    EXPECT_EQ(channel, 0.0);
  }
  std::destroy_at(value);
}

// 300 DU are a layer of 3 mm: the vertical optical depth is that of so many molecules, whatever the density's shape.
TEST(Curves, OfOzoneHaveTheColumnAskedFor) {
  for (const char* density : {R"({"profile": "tent", "center_km": 25, "half_width_km": 15})",
                              R"({"profile": "exponential", "scale_height_km": 7})",
                              R"({"profile": "layers", "layers": [[0, 0.2], [20, 1], [60, 0]]})"}) {
    const Scene scene = scene_from(R"({"airlight": 1, "media": [{"name": "o", "absorption_per_km": {"named": "ozone", )"
                                   R"("dobson_units": 300}, "density": )" +
                                   std::string(density) + "}]}");
    physics::Physics p = make_physics(scene);
    const physics::vec3 depth = p.optical_depth_to_top(p.scene.planet, 0.0, 1.0, 4096);
    const double expected = 300.0 * 2.6868e20 * mean_over(ozone_cross_section(), 610.0, 620.0);  // about 615 nm
    EXPECT_NEAR(depth.x / expected, 1.0, 1e-4) << density;
  }
}

TEST(Curves, ColumnsOfDensities) {
  Density density;
  density.profile = DensityProfile::exponential;
  density.scale_height = 8.0;
  EXPECT_NEAR(density_column(density, 100.0), 8.0 * (1.0 - std::exp(-12.5)), 1e-5);
  density.profile = DensityProfile::tent;
  density.center = 25.0;
  density.half_width = 15.0;
  EXPECT_NEAR(density_column(density, 100.0), 15.0, 1e-9);
  EXPECT_NEAR(density_column(density, 25.0), 7.5, 1e-9);
  density.profile = DensityProfile::constant;
  density.below = 3.0;
  EXPECT_NEAR(density_column(density, 100.0), 3.0, 1e-12);
  density.profile = DensityProfile::height_fog;
  EXPECT_NEAR(density_column(density, 100.0), 3.0 + 8.0 * (1.0 - std::exp(-97.0 / 8.0)), 1e-5);
  density.profile = DensityProfile::layers;
  density.layers = {{0.0, 1.0}, {10.0, 0.0}};
  EXPECT_NEAR(density_column(density, 100.0), 5.0, 1e-12);
}

TEST(Curves, ComeBackFromJson) {
  for (const char* scattering : {kSamples, R"({"at_nm": 550, "value": 0.0114, "exponent": -1.3})",
                                 R"({"named": "air", "scale": 0.5})", R"({"named": "air"})"}) {
    const Scene scene = scene_from(with_scattering(
        scattering, R"("sun": {"irradiance": 2, "spectrum": {"black_body_k": 5772}}, "image": {"white": "D65"},
                       "render": {"wavelengths": 6}, "planet": {"ground_albedo": 0.3})"));
    const Scene again = scene_from(to_json(scene));
    ASSERT_TRUE(again.spectra);
    EXPECT_EQ(again.media[0].scattering.curve, scene.media[0].scattering.curve);
    EXPECT_EQ(again.planet.ground_albedo.curve, scene.planet.ground_albedo.curve);
    EXPECT_EQ(again.spectra->sun, scene.spectra->sun);
    EXPECT_EQ(again.spectra->irradiance, 2.0);
    EXPECT_EQ(again.spectra->wavelengths, 6);
    EXPECT_EQ(again.spectra->white, White::d65);
    EXPECT_EQ(to_json(again), to_json(scene));
  }
}

class CurveFile : public FolderTest {
 protected:
  std::string preset_with(const std::string& text) const {
    write("x.csv", text);
    return write("p.json", with_scattering(R"({"file": "x.csv", "scale": 0.5})")).string();
  }
};

TEST_F(CurveFile, IsReadBesideThePreset) {
  const std::string preset = preset_with("# a comment\nnm,value\n400,0.06\n\n700 , 0.02\r\n");
  const Scene scene = resolve(load_preset(preset), local_methods());
  EXPECT_EQ(value_at(scene.media[0].scattering.curve, 700.0), 0.01);
  EXPECT_NEAR(value_at(scene.media[0].scattering.curve, 550.0), 0.02, 1e-15);
  // The file's samples are written out, so that an EXR carries the whole preset.
  EXPECT_EQ(scene_from(to_json(scene)).media[0].scattering.curve.values, scene.media[0].scattering.curve.values);
}

TEST_F(CurveFile, IsRefusedByLine) {
  const std::string place = (folder_ / "x.csv").string();
  const auto expect = [&](const std::string& text, const std::string& message) {
    EXPECT_EQ(problems_of_file(preset_with(text)),
              (folder_ / "p.json").string() + ":1: /media/0/scattering_per_km/file: " + place + message);
  };
  expect("400,1\n500,x\n", ":2: \"500,x\" is not nm,value; expected two numbers");
  expect("400,1\n500,1,2\n", ":2: \"500,1,2\" is not nm,value; expected two numbers");
  expect("400,1\n", ": 1 points; expected 2 to 4096: a curve that is the same everywhere is a number");
  expect("400,1\n400,2\n", ": 400 nm does not follow 400; expected ascending wavelengths");
  expect("100,1\n400,2\n", ":1: 100 is outside 200 to 4000 nm");
  expect("300,1\n400,-2\n", ":2: -1 is outside 0 to 100000 per km");
  // A first line that begins with a number is a sample, not a heading.
  expect("400,nan\n500,1\n600,1\n", ":1: \"400,nan\" is not nm,value; expected two numbers");
  expect("nan,1\n500,1\n600,1\n", ":1: \"nan,1\" is not nm,value; expected two numbers");
  expect("+400,1\n500,1\n600,1\n", ":1: \"+400,1\" is not nm,value; expected two numbers");
}

// Some editors begin a file so; the first sample must not be taken for a heading.
TEST_F(CurveFile, MayBeginWithAByteOrderMark) {
  const Scene scene = resolve(load_preset(preset_with("\xef\xbb\xbf"
                                                      "400,0.06\n500,0.02\n700,0.02\n")),
                              local_methods());
  EXPECT_EQ(scene.media[0].scattering.curve.wavelengths, (std::vector<double>{400.0, 500.0, 700.0}));
}

TEST_F(CurveFile, IsMissing) {
  const std::string preset = write("p.json", with_scattering(R"({"file": "none.csv"})")).string();
  EXPECT_EQ(problems_of_file(preset), preset +
                                          ":1: /media/0/scattering_per_km/file: " + (folder_ / "none.csv").string() +
                                          " cannot be read: No such file or directory; expected lines of nm,value");
}

TEST(Curves, AreRefusedWithPlaceAndRemedy) {
  const auto expect = [](const std::string& scattering, const std::string& message) {
    EXPECT_EQ(problems_of(with_scattering(scattering)), "test:1: /media/0/scattering_per_km" + message) << scattering;
  };
  expect(R"({"wavelengths_nm": [500, 400], "values": [1, 1]})",
         "/wavelengths_nm: 400 nm does not follow 500; expected ascending wavelengths");
  expect(R"({"wavelengths_nm": [400, 500, 600], "values": [1, 1]})",
         "/wavelengths_nm: 3 wavelengths for 2 values; expected as many of both");
  expect(R"({"wavelengths_nm": [400], "values": [1]})",
         "/wavelengths_nm: 1 points; expected 2 to 4096: a curve that is the same everywhere is a number");
  expect(R"({"wavelengths_nm": [400, 500], "values": [1, -1]})", "/values/1: -1 is outside 0 to 100000 per km");
  expect(R"({"wavelengths_nm": [100, 500], "values": [1, 1]})", "/wavelengths_nm/0: 100 is outside 200 to 4000 nm");
  expect(R"({"values": [1, 1]})",
         "/wavelengths_nm: missing; expected an array of as many numbers as its neighbour has");
  expect(R"({"at_nm": 550, "value": 1})", "/exponent: missing; expected a number, -20 to 20");
  expect(R"({"named": "ari"})",
         R"(/named: "ari" is no named curve; expected one of "air", "solar", "ozone"; did you mean "air"?)");
  expect(R"({"named": "air", "scael": 2})", "/scael: unknown key in this form of a curve; expected named, scale");
  expect(
      R"({"named": "ozone", "dobson_units": 300})",
      "/named: ozone is given by its column over a medium; expected it as a medium's absorption_per_km, of a density "
      "that is not 0 everywhere");
  expect(R"({"black_body_k": 5772})", "/black_body_k: a black body is light; expected it as sun.spectrum");
}

TEST(Curves, OfTheGroundReflectNoMoreThanThereIs) {
  const auto problem = [](const std::string& albedo) {
    return problems_of(with_scattering("0.01", "\"planet\": {\"ground_albedo\": " + albedo + "}"));
  };
  EXPECT_EQ(problem(R"({"wavelengths_nm": [400, 500], "values": [0.5, 1.1]})"),
            "test:1: /planet/ground_albedo/values/1: 1.1 is outside 0 to 1");
  EXPECT_EQ(problem(R"({"at_nm": 550, "value": 0.9, "exponent": 2})"),
            "test:1: /planet/ground_albedo/exponent: at 840 nm the value 2.099305785123967 is outside 0 to 1");
}

TEST(Curves, DoNotMixWithThreeChannels) {
  EXPECT_EQ(
      problems_of(with_scattering(kSamples, R"("planet": {"ground_albedo": [0.1, 0.1, 0.1]})")),
      "test:1: /planet/ground_albedo: three channels in a scene whose /media/0/scattering_per_km is a curve over the "
      "wavelength; write a number or a curve here as well, e.g. {\"at_nm\": 550, \"value\": ..., \"exponent\": "
      "...}");
  EXPECT_EQ(problems_of(with_scattering("0.01", R"("sun": {"irradiance": {"black_body_k": 5772}})")),
            "test:1: /sun/irradiance: a curve is no amount; give its shape as sun.spectrum, and a number here");
  EXPECT_EQ(
      problems_of(with_scattering("0.01", R"("sun": {"spectrum": {"wavelengths_nm": [400, 700], "values": [0, 0]}})")),
      "test:1: /sun/spectrum/wavelengths_nm: 0 at all wavelengths; expected light at some");
}

TEST(Curves, AreNeededByWhatTurnsThemIntoColours) {
  const std::string idle =
      " means nothing in a scene of three channels; give a curve to a medium, the ground or the sun, or remove it";
  EXPECT_EQ(problems_of(with_scattering("0.01", R"("image": {"white": "E"})")), "test:1: /image/white:" + idle);
  EXPECT_EQ(problems_of(with_scattering("0.01", R"("render": {"wavelengths": 6})")),
            "test:1: /render/wavelengths:" + idle);
  EXPECT_EQ(problems_of(with_scattering(kSamples, R"("render": {"wavelengths": 2})")),
            "test:1: /render/wavelengths: 2 is outside 3 to 48");
}

TEST(Curves, ThatEndInSightAreTold) {
  const std::vector<std::string> lines = curve_warnings(scene_from(with_scattering(kSamples)));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(
      lines[0],
      "/media/0/scattering_per_km: the curve has samples from 400 to 700 nm and is held constant to 380 and 780 nm");
  EXPECT_TRUE(curve_warnings(scene_from(with_scattering(R"({"named": "air"})"))).empty());
}

// A curve is one value: a file that extends another replaces it whole.
class CurveMerge : public FolderTest {};
TEST_F(CurveMerge, ReplacesACurveWhole) {
  write("base.json", with_scattering(kSamples));
  const auto over = write(
      "over.json",
      R"({"airlight": 1, "extends": "base.json", "media": [{"name": "a", "scattering_per_km": {"named": "air"}}]})");
  EXPECT_EQ(resolve(load_preset(over), local_methods()).media[0].scattering.curve.json, "{\"named\": \"air\"}");
}

}  // namespace
}  // namespace airlight::test
