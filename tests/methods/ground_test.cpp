// The planet's ground by maps in pictures: against path-trace, against one albedo, and from far.
#include "core/things/ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/methods/ground_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// Bright land and dark water, tens of degrees wide.
Scene patched(const char* method) {
  Scene scene = with_method(earth(), *find_method(method));
  put_map(scene, "patches", 64, [](int i, int j) {
    const bool land = std::sin(0.13 * i) * std::cos(0.21 * j) > 0.1;
    return land ? Spectrum{0.35, 0.3, 0.2} : Spectrum{0.05, 0.07, 0.1};
  });
  scene.ground->ocean = Ocean{};
  auto files = std::make_shared<GroundFiles>(*scene.ground->files);
  files->water_rows = files->colour_rows;
  for (std::size_t k = 0; k < files->colours.size(); k += 3) {
    files->water.push_back(files->colours[k] < 0.1F ? 1.0F : 0.0F);
  }
  scene.ground->files = files;
  scene.sun.elevation = 40.0 * kDegree;
  scene.camera.latitude = 20.0 * kDegree;
  scene.camera.longitude = 35.0 * kDegree;
  return scene;
}

struct Views {
  double altitude;
  double lowest;  // elevation, degrees
  double highest;
};

// The bound covers two simplifications: the mean albedo, not the ground below, lights the air from below, and the
// glint's light is not scattered again. path-trace has neither.
TEST(GroundSky, AgreesWithPathTrace) {
  for (const Views& v : {Views{2.0, -80.0, -4.0}, Views{9000.0, -88.0, -68.0}}) {
    std::vector<Direction> directions;
    for (int k = 0; k < 16; ++k) {
      const double x = (k % 4) / 3.0;
      directions.push_back({(v.lowest + (v.highest - v.lowest) * x) * kDegree, (90.0 * (k / 4) + 20.0 * x) * kDegree});
    }
    if (v.altitude < 100.0) {
      directions.push_back({-40.0 * kDegree, 0.0});  // into the glint
    }
    Scene traced = patched("path-trace");
    traced.render.polarisation = false;  // which the march leaves out
    traced.camera.altitude = v.altitude;
    traced.render.parameters.find("samples")->second = 512;
    const HostPicture truth = airlight::traced(traced, View{directions}, {});
    double least = 1e9;
    double most = 0.0;
    for (const char* method : {"orders", "march"}) {
      Scene scene = patched(method);
      scene.render.polarisation = false;
      scene.camera.altitude = v.altitude;
      const std::vector<ProbeResult> found = probe_now(scene, directions);
      double sum = 0.0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
          const double noise = static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[c]);
          EXPECT_NEAR(found[i].radiance[c], want, 0.12 * want + 3.0 * noise)
              << method << " from " << v.altitude << " km, direction " << i << ", channel " << c;
          sum += std::abs(found[i].radiance[c] / want - 1.0) / (3.0 * static_cast<double>(directions.size()));
          least = std::min(least, want);
          most = std::max(most, want);
        }
      }
      EXPECT_LT(sum, 0.03) << method << " from " << v.altitude << " km";
      std::printf("%s from %g km: mean %.4f\n", method, v.altitude, sum);
    }
    EXPECT_GT(most, 5.0 * least);
  }
}

// A map of one value gives the picture with that albedo, the planet's edge included, with every method that supports
// maps.
TEST(GroundSky, AMapOfOneValueIsThatAlbedo) {
  for (const char* method : {"orders", "march", "sky-view"}) {
    for (const double altitude : {0.05, 30.0, 12720.0, 1e5}) {
      Scene with = with_method(earth(), *find_method(method));
      with.camera.altitude = altitude;
      with.camera.vertical_fov = (altitude > 1e4 ? 12.0 : 70.0) * kDegree;
      with.camera.pitch = (altitude > 1e4 ? -88.0 : -20.0) * kDegree;
      with.sun.disc.visible = false;
      with.image = {16, 16};
      Scene without = with;
      without.planet.ground_albedo = {0.3, 0.2, 0.1};
      put_map(with, "even", 16, [](int, int) { return Spectrum{0.3, 0.2, 0.1}; });
      const Rendering a = render_now(with);
      const Rendering b = render_now(without);
      expect_sound(a, method);
      const double brightest = greatest(b.radiance);
      for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
          for (std::size_t c = 0; c < 3; ++c) {
            const double truth = channel_of(b.radiance, x, y, c);
            EXPECT_NEAR(channel_of(a.radiance, x, y, c), truth, 0.012 * truth + 1e-3 * brightest)
                << method << " from " << altitude << " km: " << x << ", " << y;
          }
        }
      }
    }
  }
}

// Texels far smaller than a pixel, alternately black and white, from 100 000 km: a grey planet, even at limb and poles.
TEST(GroundSky, FromFarFineTexelsAreTheirMean) {
  Scene fine = with_method(earth(), *find_method("orders"));
  fine.camera.altitude = 1e5;
  fine.camera.vertical_fov = 8.0 * kDegree;
  fine.camera.pitch = -90.0 * kDegree;
  fine.camera.latitude = 65.0 * kDegree;
  fine.sun.disc.visible = false;
  fine.image = {40, 40};
  Scene even = fine;
  put_map(fine, "fine", 512, [](int i, int j) {
    const double white = (i + j) % 2 == 0 ? 0.8 : 0.0;
    return Spectrum{white, white, white};
  });
  put_map(even, "grey", 8, [](int, int) { return Spectrum{0.4, 0.4, 0.4}; });
  const Rendering a = render_now(fine);
  const Rendering b = render_now(even);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double grey = channel_of(b.radiance, x, y, 1);
      EXPECT_NEAR(channel_of(a.radiance, x, y, 1), grey, 0.02 * grey) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace airlight::test
