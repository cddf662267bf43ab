// Every method of the device against the references of tests/truth, region by region, within tests/truth/bounds.json.
//
// AIRLIGHT_FIGURES=FILE appends the results, a line a region: scene,method,region,mean,p95,max (CSV);
// scripts/update-agreement makes core/AGREEMENT.md of them.

#include <cstdlib>
#include <fstream>

#include "tests/methods/picture_file.h"
#include "tests/methods/render_fixture.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const fs::path path = fs::path(AIRLIGHT_SOURCE_DIR) / "tests/truth";
  return path;
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
    if (entry.path().extension() == ".exr") {
      list.push_back(entry.path().stem());
    }
  }
  std::sort(list.begin(), list.end());
  // The plain build judges the figures; the sanitized build only runs the host's code.
  const std::size_t stride = sanitized() ? 6 : 1;
  std::vector<std::string> judged;
  for (std::size_t i = 0; i < list.size(); i += stride) {
    judged.push_back(list[i]);
  }
  return judged;
}

void note(const std::string& scene, std::string_view method, const RegionError& error) {
  if (const char* file = std::getenv("AIRLIGHT_FIGURES")) {
    std::ofstream(file, std::ios::app) << scene << ',' << method << ',' << error.region << ',' << error.mean << ','
                                       << error.p95 << ',' << error.max << '\n';
  }
}

// The reference's own noise as an error: mean of |x| of a normal x, over the region.
std::vector<RegionError> noise_errors(const Scene& scene, const RadianceImage& truth, const RadianceImage& sigma) {
  RadianceImage off = truth;
  for (std::size_t i = 0; i < off.rgba.size(); ++i) {
    off.rgba[i] += 0.79788456f * sigma.rgba[i];
  }
  return region_errors(scene, off, truth);
}

class Agreement : public testing::TestWithParam<std::string> {};

TEST_P(Agreement, OfEveryMethodWithTheTruth) {
  const std::string& name = GetParam();
  const Scene truth_scene = scene_from_file(folder() / (name + ".json"));
  const std::optional<RadianceImage> truth = read_layer(folder() / (name + ".exr"));
  const std::optional<RadianceImage> sigma = read_layer(folder() / (name + ".exr"), "standard_error");
  ASSERT_TRUE(truth.has_value() && sigma.has_value()) << name;
  std::map<std::string, double> noise;
  for (const RegionError& error : noise_errors(truth_scene, *truth, *sigma)) {
    note(name, "noise", error);
    noise[error.region] = error.mean;
  }
  static const std::map<std::string, double> bounds = numbers_in(folder() / "bounds.json");
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    const Scene scene = with_method(truth_scene, method);
    const Rendering rendering = render_now(scene);
    expect_sound(rendering, name);
    for (const RegionError& error : region_errors(scene, without_edge(scene, rendering.radiance, *truth), *truth)) {
      note(name, method.info.name, error);
      const std::string key = std::string(method.info.name) + "/" + name + "/" + error.region;
      const auto bound = bounds.find(key);
      EXPECT_TRUE(bound != bounds.end() || method.info.name != "orders") << "bounds.json has no " << key;
      if (bound != bounds.end()) {
        EXPECT_LE(error.mean, bound->second + noise.at(error.region)) << key;
      }
    }
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (const char c : {'-', '.'}) {
    std::replace(name.begin(), name.end(), c, '_');
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, testing::ValuesIn(names()), name_of);

}  // namespace
}  // namespace airlight::test
