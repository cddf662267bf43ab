#include "tests/methods/render_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/of_scene.h"
#include "tests/shared_executor.h"

namespace airlight::test {
namespace {

class ValidationEnvironment : public testing::Environment {
 public:
  void SetUp() override { setenv("AIRLIGHT_VALIDATION", "1", 0); }
  void TearDown() override {
    EXPECT_EQ(Executor::validation_message_count(), 0) << "the validation layer's messages stand above";
  }
};

const auto* const environment = testing::AddGlobalTestEnvironment(new ValidationEnvironment);

auto* const shared_device = new SharedExecutor;
const auto* const device_environment = testing::AddGlobalTestEnvironment(shared_device);

constexpr TableSize kSmallTable{32, 16};
constexpr int kFewSteps = 16;
constexpr int kFewSamples = 32;

void make_cheap(const ParameterInfo& parameter, ParameterValue& value) {
  if (parameter.kind == ParameterKind::table_size) {
    const auto smallest = static_cast<int>(parameter.minimum);
    auto& size = std::get<TableSize>(value);
    size = {std::clamp(kSmallTable[0], smallest, size[0]), std::clamp(kSmallTable[1], smallest, size[1])};
  } else if (parameter.key == "steps") {
    value = kFewSteps;
  } else if (parameter.key == "samples") {
    value = kFewSamples;
  } else if (parameter.key == "degree") {
    value = std::string("2");
  }
}

}  // namespace

Executor& executor() {
  return shared_device->get();
}

Rendering render_now(const Scene& scene, const RenderRequest& request) {
  return render([]() -> Executor& { return executor(); }, scene, request);
}

std::vector<ProbeResult> probe_now(const Scene& scene, const std::vector<Direction>& directions) {
  return probe([]() -> Executor& { return executor(); }, scene, directions).directions;
}

Scene with_method(Scene scene, const SkyMethod& method, bool cheap) {
  scene.render.method = method.info.name;
  const auto wished = scene.render.parameters;
  scene.render.parameters.clear();
  for (const ParameterInfo& parameter : method.info.parameters) {
    ParameterValue value = parameter.default_value;
    if (cheap) {
      make_cheap(parameter, value);
    }
    const auto found = wished.find(parameter.key);
    scene.render.parameters.emplace(parameter.key, found == wished.end() ? value : found->second);
  }
  return scene;
}

bool takes(const SkyMethod& method, std::string_view parameter) {
  return std::any_of(method.info.parameters.begin(), method.info.parameters.end(),
                     [&](const ParameterInfo& info) { return info.key == parameter; });
}

bool on_device(const SkyMethod& method) {
  return method.render_on_host == nullptr;
}

Scene all_round(Scene scene, double altitude, int width, int height) {
  scene.camera.altitude = altitude;
  scene.camera.projection = Projection::equirectangular;
  scene.image = {width, height};
  return scene;
}

Span span_at(int x, int y, double distance) {
  return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<float>(distance)};
}

std::vector<Span> spans_at(const Scene& scene, double distance) {
  std::vector<Span> spans;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      spans.push_back(span_at(x, y, distance));
    }
  }
  return spans;
}

void expect_sound(const Rendering& rendering, const std::string& what) {
  EXPECT_EQ(rendering.fault(), "") << what;
  std::size_t bad = 0;
  const auto count = [&](float x) { bad += std::isfinite(x) && x >= 0.0f ? 0U : 1U; };
  std::for_each(rendering.radiance.rgba.begin(), rendering.radiance.rgba.end(), count);
  for (const TableDump& table : rendering.tables) {
    const auto is_it = [&](const NamedStatistics& watched) { return watched.name == table.name; };
    if (std::ranges::any_of(rendering.tables_statistics, is_it)) {
      std::for_each(table.rgba.begin(), table.rgba.end(), count);
    }
  }
  EXPECT_EQ(bad, 0U) << what;
}

double channel_of(const RadianceImage& image, int x, int y, std::size_t c) {
  return static_cast<double>(image.at(x, y)[c]);
}

double greatest(const RadianceImage& image) {
  float most = 0.0f;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    most = i % 4 == 3 ? most : std::max(most, image.rgba[i]);
  }
  return static_cast<double>(most);
}

double solid_angle(const Scene& scene, int x, int y) {
  const double width = scene.image.width;
  const double height = scene.image.height;
  if (scene.camera.projection == Projection::equirectangular) {
    const auto sine = [&](double row) { return std::sin(std::numbers::pi * (0.5 - row / height)); };
    return 2.0 * std::numbers::pi / width * (sine(y) - sine(y + 1.0));
  }
  if (is_cut(scene.camera.projection)) {
    // The triangles that a 4 x 4 grid of directions spans on the sphere (Van Oosterom and Strackee 1983).
    physics::Physics p = make_physics(scene);
    const auto at = [&](int i, int j) {
      // Moved inward by a hair, since a corner may lie on a face's edge.
      const auto inner = [](int k) { return std::clamp(0.25 * k, 1e-9, 1.0 - 1e-9); };
      return p.view_ray(p.scene.camera, projection_code(scene.camera.projection), x + inner(i), y + inner(j)).direction;
    };
    double sum = 0.0;
    for (int k = 0; k < 16; ++k) {
      const physics::vec3 a = at(k % 4, k / 4);
      const physics::vec3 c = at(k % 4 + 1, k / 4 + 1);
      for (const physics::vec3& b : {at(k % 4 + 1, k / 4), at(k % 4, k / 4 + 1)}) {
        const physics::vec3 across(b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x);
        sum += 2.0 * std::atan2(std::abs(physics::dot(a, across)),
                                1.0 + physics::dot(a, b) + physics::dot(b, c) + physics::dot(c, a));
      }
    }
    return sum;
  }
  // Flat pictures: 8 x 8 points, by cos^3 of the angle over the squared distance to the picture's plane, and by
  // sin(angle)/angle for the equidistant fisheye.
  const bool fisheye = scene.camera.projection == Projection::fisheye;
  const double pixel = fisheye ? scene.camera.vertical_fov / std::min(width, height)
                               : 2.0 * std::tan(0.5 * scene.camera.vertical_fov) / height;
  double sum = 0.0;
  for (int k = 0; k < 64; ++k) {
    const double u = (x + (k % 8 + 0.5) / 8.0 - 0.5 * width) * pixel;
    const double v = (y + (k / 8 + 0.5) / 8.0 - 0.5 * height) * pixel;
    const double far = std::hypot(u, v);
    sum += fisheye ? std::sin(far) / far : std::pow(1.0 + far * far, -1.5);
  }
  return pixel * pixel * sum / 64.0;
}

double flux(const Scene& scene, const RadianceImage& image, std::size_t c) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      sum += channel_of(image, x, y, c) * solid_angle(scene, x, y);
    }
  }
  return sum;
}

}  // namespace airlight::test
