#pragma once
// Shared by the tests of both models of bloom.

#include <algorithm>
#include <cmath>

#include "core/base/srgb.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {

// A black sky with the sun in the middle of 30 degrees, `lines` high.
inline Scene lone_sun(int lines, BloomModel model) {
  Scene scene = vacuum();
  scene.sun.elevation = 45.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.vertical_fov = 30.0 * kDegree;
  scene.image = {lines, lines};
  scene.display.exposure = 1.0;
  scene.bloom.model = model;
  return with_method(scene, *find_method("march"), true);
}

// Degrees from the middle of such a picture, at a pixel's centre.
inline double degrees_off_middle(const Scene& scene, double x, double y) {
  const double middle = 0.5 * scene.image.height;
  return std::atan(std::hypot(x + 0.5 - middle, y + 0.5 - middle) / middle * std::tan(15.0 * kDegree)) / kDegree;
}

inline Rendering with_bloom(const Scene& scene) {
  RenderRequest request;
  request.bloom = true;
  return render_now(scene, request);
}

// The tone pass takes the glow by itself: it shows the picture plus the glow that others get. At least a hundred values
// are brighter than `dark`, and none of those is clipped.
inline void expect_glow_in_tone_curve(Scene scene, double dark) {
  scene.display.tonemap = ToneCurve::clamp;
  scene.display.exposure = 0.5;
  const Rendering seen = with_bloom(scene);
  ASSERT_TRUE(seen.bloom.has_value());
  RenderRequest request;
  request.bloom = true;
  request.bloom_picture = false;
  request.gpu_tone = true;
  const Rendering shown = render_now(scene, request);
  EXPECT_FALSE(shown.bloom.has_value());
  ASSERT_EQ(shown.encoded.size(), seen.radiance.rgba.size());
  int lit = 0;
  for (std::size_t i = 0; i < shown.encoded.size(); ++i) {
    const double sum =
        static_cast<double>(seen.radiance.rgba[i]) + scene.bloom.intensity * static_cast<double>(seen.bloom->rgba[i]);
    if (i % 4 != 3) {
      EXPECT_NEAR(srgb_decoded(shown.encoded[i] / 65535.0), std::min(0.5 * sum, 1.0), 5e-5) << i;
      lit += 0.5 * sum > dark && 0.5 * sum < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(lit, 100);
}

}  // namespace airlight::test
