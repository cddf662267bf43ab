// Every method of the registry at the edges of what a preset may ask for: finite, not negative, not black where there
// is light.

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

// Checks the picture and returns its brightest value.
double checked(const Scene& scene, const std::string& what) {
  RenderRequest request;
  request.tables = true;
  const Rendering rendering = render_now(scene, request);
  expect_sound(rendering, what);
  return greatest(rendering.radiance);
}

template <class F>
void for_each_method(const F& f) {
  for (const SkyMethod& method : methods()) {
    SCOPED_TRACE(std::string(method.info.name));
    f(method);
  }
}

// for_each_method(), but with the sanitizers only the two methods with the most tables and passes: these tests vary
// what the device computes, where no sanitizer looks.
template <class F>
void for_each_shader(const F& f) {
  for_each_method([&](const SkyMethod& method) {
    if (!sanitized() || method.info.name == "march" || method.info.name == "orders") {
      f(method);
    }
  });
}

// Odd sizes, so that a row of pixels looks exactly level.
Scene small(const Scene& scene, const SkyMethod& method, double altitude) {
  const Scene picture = on_device(method) ? all_round(scene, altitude, 9, 7) : all_round(scene, altitude, 3, 5);
  return with_method(picture, method, true);
}

double next_float(double x, double toward) {
  return static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(toward)));
}

// On the ground, a hair above it, at heights where other code fails, at the top, an ulp to either side, outside.
std::vector<double> altitudes() {
  return {0.0,
          std::numeric_limits<double>::denorm_min(),
          static_cast<double>(std::numeric_limits<float>::denorm_min()),
          static_cast<double>(std::numeric_limits<float>::min()),
          1e-4,
          2.5e-4,
          99.9,
          next_float(100.0, 0.0),
          std::nextafter(100.0, 0.0),
          100.0,
          std::nextafter(100.0, 200.0),
          next_float(100.0, 200.0),
          500.0,
          400000.0};
}

TEST(Stability, CameraAndSunAtEveryEdge) {
  for_each_method([](const SkyMethod& method) {
    for (const double altitude : altitudes()) {
      Scene scene = small(earth(), method, altitude);
      physics::Physics p = make_physics(scene);
      const double horizon = std::asin(p.horizon_mu(p.scene.planet, altitude));
      for (const double sun : {90.0 * kDegree, 20.0 * kDegree, 0.0, horizon, -4.0 * kDegree, -90.0 * kDegree}) {
        scene.sun.elevation = sun;
        const std::string what = "from " + std::to_string(altitude) + " km, sun at " + std::to_string(sun / kDegree);
        const double light = checked(scene, what);
        // From very far the planet falls between the pixels' centres.
        if (sun > -5.0 * kDegree && altitude < 1000.0) {
          EXPECT_GT(light, 0.0) << what;
        }
      }
    }
  });
}

// Rays that no pixel centre hits: the true horizon and a hair to either side, nadir, zenith, the tangent to the top.
TEST(Stability, RaysAtEveryEdge) {
  for_each_method([](const SkyMethod& method) {
    for (const double altitude : {0.0, 1e-4, 1.0, 100.0, 500.0}) {
      Scene scene = with_method(earth(), method, true);
      scene.camera.altitude = altitude;
      scene.planet.ground_albedo = {0.5, 0.5, 0.5};
      physics::Physics p = make_physics(scene);
      const double horizon = std::asin(p.horizon_mu(p.scene.planet, altitude));
      const double tangent = altitude > 100.0 ? -std::acos(6460.0 / (6360.0 + altitude)) : 0.0;
      std::vector<Direction> directions;
      for (const double elevation :
           {90.0 * kDegree, -90.0 * kDegree, 0.0, horizon, horizon + 1e-9, horizon - 1e-9, horizon + 1e-7,
            horizon - 1e-7, horizon + 1e-4, horizon - 1e-4, tangent, tangent + 1e-7, tangent - 1e-7, tangent - 1e-3}) {
        directions.push_back({elevation, 0.0});
        if (on_device(method)) {
          directions.push_back({elevation, 2.0});
        }
      }
      for (const double sun : {30.0 * kDegree, horizon}) {
        scene.sun.elevation = sun;
        double sum = 0.0;
        for (const ProbeResult& result : probe_now(scene, directions)) {
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(std::isfinite(result.radiance[c]) && result.radiance[c] >= 0.0)
                << altitude << " km toward " << result.direction.elevation << ": " << result.radiance[c];
            EXPECT_TRUE(result.transmittance[c] >= 0.0 && result.transmittance[c] <= 1.0)
                << altitude << " km toward " << result.direction.elevation << ": " << result.transmittance[c];
            sum += result.radiance[c];
          }
        }
        EXPECT_GT(sum, 0.0) << altitude;
      }
    }
  });
}

Scene with_air(std::vector<Medium> media) {
  Scene scene = vacuum();
  scene.media = std::move(media);
  return scene;
}

TEST(Stability, AirOfEveryThickness) {
  const auto air = [](double optical_depth, double absorbed) {
    const double s = optical_depth * (1.0 - absorbed) / 8.0;
    const double a = optical_depth * absorbed / 8.0;
    return with_air({medium("air", {s, s, 0.1 * s}, {a, a, a}, exponential(8.0), PhaseFunction::rayleigh)});
  };
  for_each_method([&](const SkyMethod& method) {
    for (const double depth : {0.0, 1e-30, 1e-6, 1.0, 30.0, 1000.0}) {
      for (const double absorbed : {0.0, 1.0}) {
        for (const double albedo : {0.0, 1.0}) {
          // f_ms nears 1 where nothing absorbs; a sampling method would follow paths for minutes there.
          if (!on_device(method) && absorbed == 0.0 && depth > 1.0) {
            continue;
          }
          // A black ground behind such air tests nothing beyond the white one, where light dies out slowest, and each
          // takes seconds of tables.
          if (depth > 1.0 && absorbed == 0.0 && albedo == 0.0) {
            continue;
          }
          Scene scene = small(air(depth, absorbed), method, 0.5);
          scene.sun.disc.visible = false;
          scene.planet.ground_albedo = {albedo, albedo, albedo};
          const std::string what = "depth " + std::to_string(depth) + ", albedo " + std::to_string(albedo) +
                                   ", absorbed " + std::to_string(absorbed);
          const double light = checked(scene, what);
          const bool dark = (depth == 0.0 || absorbed == 1.0) && albedo == 0.0;
          if (dark) {
            EXPECT_EQ(light, 0.0) << what;
          } else if (depth <= 30.0 && absorbed == 0.0) {
            EXPECT_GT(light, 0.0) << what;
          }
        }
      }
    }
  });
}

// Each kind of medium with the two methods that have the most tables and passes, a third of the kinds with each other
// method, whose shaders treat media by the same functions.
TEST(Stability, OneMediumOfEachKind) {
  std::size_t turn = 0;
  for_each_method([&](const SkyMethod& method) {
    const std::size_t share = method.info.name == "march" || method.info.name == "orders" ? 1 : 3;
    for (const Medium& only : every_kind().media) {
      if (++turn % share != 0) {
        continue;
      }
      Scene scene = small(with_air({only}), method, 1.0);
      EXPECT_GT(checked(scene, only.name), 0.0) << only.name;
    }
    checked(small(every_kind(), method, 1.0), "all together");
    Scene no_media = small(vacuum(), method, 1.0);
    no_media.sun.disc.visible = false;
    EXPECT_EQ(checked(no_media, "no media"), 0.0);
  });
}

// The sharpest peaks, forward and backward, with the sun in the middle of a pixel and behind.
TEST(Stability, SharpestPhaseFunctionsTowardTheSun) {
  for_each_method([](const SkyMethod& method) {
    for (const PhaseFunction phase :
         {PhaseFunction::henyey_greenstein, PhaseFunction::cornette_shanks, PhaseFunction::schlick}) {
      for (const double g : {-0.99, 0.99}) {
        Scene scene = with_air({medium("peak", {0.01, 0.01, 0.01}, {}, exponential(2.0), phase, g)});
        scene.sun.elevation = 0.0;
        scene = small(scene, method, 0.01);
        EXPECT_GT(checked(scene, "g " + std::to_string(g)), 0.0);
      }
    }
  });
}

TEST(Stability, PlanetsOfEverySize) {
  struct World {
    double radius;
    double height;
  };
  for_each_method([](const SkyMethod& method) {
    for (const World& world : {World{1.0, 100.0}, World{1.0, 0.1}, World{1e6, 100.0}, World{1e6, 1e5}}) {
      const double scale = 0.08 * world.height;
      Scene scene = with_air({medium("air", {0.2 / scale, 0.3 / scale, 0.5 / scale}, {}, exponential(scale))});
      scene.planet.ground_radius = world.radius;
      scene.planet.atmosphere_height = world.height;
      scene.planet.ground_albedo = {0.3, 0.3, 0.3};
      for (const double altitude : {0.0, 1e-6 * world.height, 0.5 * world.height, world.height, 3.0 * world.height}) {
        const std::string what = "radius " + std::to_string(world.radius) + ", height " + std::to_string(world.height) +
                                 ", from " + std::to_string(altitude);
        EXPECT_GT(checked(small(scene, method, altitude), what), 0.0) << what;
      }
    }
  });
}

TEST(Stability, PicturesOfEverySize) {
  const int sizes[][2] = {{1, 1}, {1, 5}, {5, 1}, {17, 3}, {65, 1}};
  for_each_method([&](const SkyMethod& method) {
    for (const auto& size : sizes) {
      for (const Projection projection : {Projection::perspective, Projection::equirectangular, Projection::fisheye}) {
        Scene scene = with_method(all_round(earth(), 0.001, size[0], size[1]), method, true);
        scene.camera.projection = projection;
        scene.camera.pitch = projection == Projection::equirectangular ? 0.0 : 25.0 * kDegree;
        RenderRequest request;
        request.bloom = true;
        request.gpu_tone = true;
        const Rendering rendering = render_now(scene, request);
        const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]);
        expect_sound(rendering, what);
        EXPECT_GT(greatest(rendering.radiance), 0.0) << what;
        EXPECT_EQ(rendering.encoded.size(), rendering.radiance.rgba.size()) << what;
        if (rendering.bloom) {
          for (const float x : rendering.bloom->rgba) {
            ASSERT_TRUE(std::isfinite(x) && x >= 0.0f) << what;
          }
        }
      }
    }
  });
}

// A kept table must not be used by a scene that needs another: the order of scenes changes no picture.
TEST(Stability, WhatWasRenderedBeforeChangesNothing) {
  for_each_shader([](const SkyMethod& method) {
    if (!on_device(method)) {
      return;
    }
    std::vector<Scene> scenes;
    Scene scene = small(earth(), method, 1.0);
    scene.sun.elevation = 3.0 * kDegree;
    scenes.push_back(scene);
    for (const ParameterInfo& parameter : method.info.parameters) {
      Scene other = scene;
      ParameterValue& value = other.render.parameters.at(std::string(parameter.key));
      if (parameter.kind == ParameterKind::table_size) {
        auto& size = std::get<TableSize>(value);
        size = {size[0] + 3, size[1] + 1};
        scenes.push_back(other);
      } else if (parameter.kind == ParameterKind::sun_fade) {
        value = SunFade{0.0, 0.0};
        scenes.push_back(other);
      } else if (parameter.kind == ParameterKind::choice) {
        // Only one choice of a list, since each needs its own pipelines. The march's keys have tests of their own.
        const auto isnt_default = [&](std::string_view choice) {
          return parameter.default_value != ParameterValue(std::string(choice));
        };
        value = std::string(*std::find_if(parameter.choices.begin(), parameter.choices.end(), isnt_default));
        scenes.push_back(other);
      }
    }
    for (const Spectrum& albedo : {Spectrum{}, Spectrum{0.9, 0.1, 0.4}}) {
      Scene other = scene;
      other.planet.ground_albedo = albedo;
      scenes.push_back(other);
    }
    // Forward on one device, backward on another, so that what a scene leaves behind meets different scenes.
    Executor there{{}};
    Executor back{{}};
    std::vector<RadianceImage> pictures;
    for (const Scene& one : scenes) {
      pictures.push_back(render([&]() -> Executor& { return there; }, one, {}).radiance);
    }
    for (std::size_t i = scenes.size(); i-- > 0;) {
      const RadianceImage again = render([&]() -> Executor& { return back; }, scenes[i], {}).radiance;
      EXPECT_TRUE(again.rgba == pictures[i].rgba) << "scene " << i;
    }
  });
}

}  // namespace
}  // namespace airlight::test
