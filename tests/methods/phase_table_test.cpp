// Phase functions by table, by every method.

#include <cmath>
#include <numeric>

#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/stage/wavelengths.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

// Hillaire's air with a real haze: Earth's aerosol of CosmoScout VR at 595 nm (CC0), every few degrees.
PhaseTable haze() {
  PhaseTable table;
  table.angles_deg = {0, 1, 2, 3, 5, 8, 12, 17, 23, 30, 40, 52, 65, 80, 95, 110, 125, 140, 152, 163, 172, 180};
  table.rows = {{5.7,   3.6,    2.3,    1.87,   1.58,   1.35,   1.07,   0.76,   0.49,   0.29,  0.145,
                 0.071, 0.0376, 0.0214, 0.0146, 0.0124, 0.0134, 0.0185, 0.0245, 0.0295, 0.034, 0.041}};
  const double norm = sphere_integral(table, 0);
  for (double& value : table.rows[0]) {
    value /= norm;
  }
  return table;
}

double mean_difference(const RadianceImage& a, const RadianceImage& b) {
  const double mean = std::accumulate(b.rgba.begin(), b.rgba.end(), 0.0) / static_cast<double>(b.rgba.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    sum +=
        std::fabs(static_cast<double>(a.rgba[i] - b.rgba[i])) / std::max(static_cast<double>(b.rgba[i]), 1e-3 * mean);
  }
  return sum / static_cast<double>(a.rgba.size());
}

// A table of Henyey-Greenstein's values renders like the formula by march, table, harmonics or closed form.
TEST(PhaseTables, OfAFormulaRenderAsTheFormula) {
  Scene scene = all_round(earth(), 0.001, 24, 12);
  scene.sun.disc.visible = false;
  Scene by_table = scene;
  take_table(by_table.media[1], peaked_table({0.8}));
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    const Rendering expected = render_now(with_method(scene, method));
    const Rendering found = render_now(with_method(by_table, method));
    EXPECT_EQ(found.fault(), "") << method.info.name;
    EXPECT_LT(mean_difference(found.radiance, expected.radiance), 3e-4) << method.info.name;
  }
}

// Light of all orders depends on the table's moments too; random walks, which use no moments, are the reference.
TEST(PhaseTables, OrdersAgreesWithPathTrace) {
  Scene scene = all_round(earth(), 0.001, 16, 8);
  scene.sun.disc.visible = false;
  scene.sun.elevation = 25.0 * kDegree;
  scene.media[0].depolarization = {0.0147, 0.0147, 0.0147};
  take_table(scene.media[1], haze());
  for (double& c : scene.media[1].scattering) {
    c *= 3.0;
  }
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters["samples"] = 512;
  const Rendering truth = render_now(traced);
  const Rendering found = render_now(with_method(scene, *find_method("orders")));
  // 0.4 % of it is the truth's noise.
  EXPECT_LT(mean_difference(found.radiance, truth.radiance), 0.012);
  // With a formula of another mean cosine the same sky differs.
  Scene formula = scene;
  formula.media[1].phase = PhaseFunction::henyey_greenstein;
  formula.media[1].phase_g = 0.2;
  EXPECT_GT(mean_difference(render_now(with_method(formula, *find_method("orders"))).radiance, truth.radiance), 0.03);
}

// Blue is scattered more forward than red, so the aureole is bluer than the sky away from the sun, in the three
// channels of a group and in the colours made of them.
TEST(PhaseTables, OverTheWavelengthColourTheAureole) {
  const auto scene = [](const std::string& phase) {
    return resolve(parse_preset(R"({"airlight": 1, "media": [{"name": "dust", "scattering_per_km": 0.02, "phase": )" +
                                    phase + R"(, "density": {"profile": "exponential", "scale_height_km": 8}}],
      "sun": {"elevation_deg": 30, "spectrum": {"named": "solar"}}, "image": {"width": 8, "height": 4},
      "render": {"method": "march", "wavelengths": 6}})",
                                "test", {}),
                   method_infos());
  };
  const auto ratio = [&](const std::string& phase) {
    const auto found = probe_now(scene(phase), {{35.0 * kDegree, 0.0}, {30.0 * kDegree, 120.0 * kDegree}});
    const auto blueness = [&](std::size_t i) { return found[i].radiance[2] / found[i].radiance[0]; };
    return blueness(0) / blueness(1);
  };
  const auto rows = [](double blue, double red) {
    const PhaseTable a = peaked_table({blue}, 60);
    const PhaseTable b = peaked_table({red}, 60);
    const auto list = [](const std::vector<double>& values) {
      std::string text;
      for (const double value : values) {
        text += (text.empty() ? "[" : ", ") + std::to_string(value);
      }
      return text + "]";
    };
    return R"({"function": "table", "wavelengths_nm": [400, 700], "angles_deg": )" + list(a.angles_deg) +
           R"(, "values": [)" + list(a.rows[0]) + ", " + list(b.rows[0]) + "]}";
  };
  EXPECT_NEAR(ratio(rows(0.7, 0.7)), 1.0, 1e-3);
  EXPECT_GT(ratio(rows(0.8, 0.6)), 1.5);
  EXPECT_LT(ratio(rows(0.6, 0.8)), 0.67);
}

}  // namespace
}  // namespace airlight::test
