// Layers among things in air that bends light: the air before a slope is that of a span as long as its depth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include "core/air/refraction.h"
#include "tests/methods/bent_scene.h"
#include "tests/methods/terrain_scene.h"

namespace airlight::test {
namespace {

// A range under air whose index falls as ExactAir's does, in a picture.
Scene pictured_range() {
  Scene scene = range_in_haze("orders", 20.0);
  scene.planet.ground_radius = ExactAir{}.radius;
  scene.planet.refraction.emplace().n_minus_1 = ExactAir{}.n_minus_1;
  scene.planet.refraction->density.scale_height = ExactAir{}.scale_height;
  scene.render.polarisation = false;
  scene.sun.disc.visible = false;
  scene.camera.azimuth = 90.0 * kDegree;
  scene.camera.pitch = 4.0 * kDegree;
  scene.camera.vertical_fov = 20.0 * kDegree;
  scene.image = {32, 18};
  return scene;
}

const std::vector<float>& planes_of(const Rendering& rendering, std::string_view name) {
  return std::ranges::find(rendering.layers, name, &Layer::name)->planes;
}

// The gap of relative transmittance that three quarters of the pixels keep: those at a ridge are the mean of several
// depths.
double usual_gap(const std::vector<double>& found, const std::vector<double>& truth) {
  std::vector<double> gaps;
  for (std::size_t k = 0; k < found.size(); ++k) {
    gaps.push_back(std::abs(found[k] / truth[k] - 1.0));
  }
  std::ranges::sort(gaps);
  return gaps[gaps.size() * 3 / 4];
}

std::vector<double> green_through(const Scene& scene, const std::vector<Span>& spans) {
  std::vector<double> out;
  for (const AirTo& air : air_to(executor(), scene, spans)) {
    out.push_back(static_cast<double>(air.transmittance[1]));
  }
  return out;
}

TEST(BentLayers, TheAirBeforeASlopeIsThatOfASpanToIt) {
  for (const char* tabulate : {"never", "always"}) {
    Scene scene = pictured_range();
    scene.render.parameters.insert_or_assign("tabulate", std::string(tabulate));
    RenderRequest request;
    request.layers = LayerSet::light;
    const Rendering rendering = render_now(scene, request);
    const std::vector<float>& depth = planes_of(rendering, "depth");
    const std::vector<float>& through = planes_of(rendering, "transmittance");
    physics::Physics p = geometry_of(part_of(scene).scene);
    std::vector<Span> spans;
    std::vector<Span> unbent;  // as long as the true length of that optical one
    std::vector<double> layer;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const auto x = static_cast<int>(i % 32);
      const auto y = static_cast<int>(i / 32);
      if (depth[i] > 15.0F && depth[i] < 80.0F) {
        const auto d = static_cast<double>(depth[i]);
        spans.push_back(span_at(x, y, d));
        const auto view = p.view_ray(p.scene.camera, physics::kProjectionPerspective, x + 0.5, y + 0.5);
        unbent.push_back(span_at(x, y, true_length(p, view.direction.y, d)));
        layer.push_back(static_cast<double>(through[depth.size() + i]));
      }
    }
    ASSERT_GT(spans.size(), 100u);
    const std::vector<double> truth = green_through(scene, spans);
    const double gap = usual_gap(layer, truth);
    const double by_length = usual_gap(green_through(scene, unbent), truth);
    std::printf("%s: %zu slopes, gap %.5f, of an optical length %.5f\n", tabulate, spans.size(), gap, by_length);
    EXPECT_LT(gap, 0.5 * by_length) << tabulate;
  }
}

}  // namespace
}  // namespace airlight::test
