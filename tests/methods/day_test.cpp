// A day of frames bakes its tables once; another air bakes them anew.
#include <gtest/gtest.h>

#include "core/methods/method.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

Scene scene_at(double sun_elevation, double haze, std::string_view method) {
  Preset preset = parse_preset(R"({"airlight": 1, "image": {"width": 16, "height": 9}, "media": [
      {"name": "air", "scattering_per_km": [0.0058, 0.0135, 0.0331],
       "density": {"profile": "exponential", "scale_height_km": 8}, "phase": {"function": "rayleigh"}},
      {"name": "haze", "scattering_per_km": 0.004, "density": {"profile": "exponential", "scale_height_km": 1.2}}]})",
                               "test", {});
  apply_override(preset, "/sun/elevation_deg=" + std::to_string(sun_elevation));
  apply_override(preset, "/media/1/scattering_per_km=" + std::to_string(haze));
  apply_override(preset, "/render/method=" + std::string(method));
  return resolve(preset, method_infos());
}

bool ran(const Rendering& rendering, const std::string& pass) {
  for (const PassTiming& timing : rendering.passes) {
    if (timing.name.starts_with(pass)) return true;
  }
  return false;
}

TEST(Day, BakesItsTablesOnce) {
  Executor executor{DeviceOptions{}};
  const auto picture = [&](double sun, double haze, std::string_view method) {
    return render([&]() -> Executor& { return executor; }, scene_at(sun, haze, method), {});
  };
  for (const std::string_view method : {"march", "orders"}) {
    const std::string table = method == "march" ? "multiple_scattering" : "orders_sum";
    const Rendering first = picture(5, 0.004, method);
    EXPECT_TRUE(ran(first, table)) << method;
    for (int i = 0; i < 3; ++i) {
      const Rendering next = picture(6 + i, 0.004, method);
      EXPECT_FALSE(ran(next, table)) << method;
      EXPECT_FALSE(ran(next, "transmittance")) << method;
      EXPECT_FALSE(next.passes.empty());
    }
    EXPECT_TRUE(ran(picture(6, 0.005, method), table)) << method;
    EXPECT_FALSE(ran(picture(7, 0.004, method), table)) << method;  // the first air's are still there
  }
  // Thick air, by shells.
  EXPECT_TRUE(ran(picture(30, 3.0, "orders"), "orders_level0"));
  EXPECT_FALSE(ran(picture(31, 3.0, "orders"), "order"));
}

}  // namespace
}  // namespace airlight::test
