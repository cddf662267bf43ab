// The air between the camera and things: against the whole ray, against itself cut in two, against path-trace.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

Scene hazy(double altitude) {
  Scene scene = earth();
  scene.sun.elevation = 20.0 * kDegree;
  scene.camera.altitude = altitude;
  return with_method(scene, *find_method("orders"));
}

// The direction of a pixel's centre.
Direction direction_at(const Scene& scene, int x, int y) {
  physics::Physics p = make_physics(scene);
  const auto ray = p.view_ray(p.scene.camera, projection_code(scene.camera.projection), x + 0.5, y + 0.5);
  const physics::vec3 d = ray.direction;
  return angles_of(d);
}

// Optical depths from the scene's camera along a zenith cosine up to a distance, km, by ten thousand midpoints in
// double: of the air as `orders` takes it, whose forward peaks above degree 2 count as light not scattered, and of
// those peaks.
struct Depths {
  physics::vec3 scaled;
  physics::vec3 peaks;
};

Depths depths_to(const Scene& scene, double mu, double distance) {
  constexpr int kSteps = 10000;
  physics::Physics p = make_physics(scene);
  p.degree = 2;
  p.delta = true;
  const double h = scene.camera.altitude;
  const auto whole = p.ray_up_to(p.scene.planet, h, mu, p.ray_in_atmosphere(p.scene.planet, h, mu, 0.3, 0.0), distance);
  const double width = whole.length_ / kSteps;
  Depths depths;
  for (int k = 0; k < kSteps; ++k) {
    const double altitude = p.point_on_ray(p.scene.planet, whole, width * (k + 0.5)).h;
    const auto air = p.diffuse_air(p.densities_at(altitude), p.equal_phases(0.0));
    depths.scaled = depths.scaled + air.extinction * width;
    depths.peaks = depths.peaks + air.peaks * width;
  }
  return depths;
}

TEST(Spans, NothingLiesBeforeAThingAtTheCamera) {
  const Scene scene = all_round(hazy(0.1), 0.1, 16, 8);
  for (const AirTo& air : air_to(executor(), scene, spans_at(scene, 0.0))) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(air.radiance[c], 0.0F);
      EXPECT_EQ(air.transmittance[c], 1.0F);
    }
  }
}

// Row by row and thing by thing agree, in both ways; where there is no thing there is no air.
TEST(Spans, RowsAreAsAList) {
  const Scene scene = all_round(hazy(0.1), 0.1, 16, 8);
  std::vector<Span> list;
  std::vector<float> rows;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool there = (x + y) % 3 != 0;
      rows.push_back(there ? 0.1F * static_cast<float>(1 + x * y) : std::numeric_limits<float>::infinity());
      if (there) {
        list.push_back(span_at(x, y, static_cast<double>(rows.back())));
      }
    }
  }
  for (const bool volume : {false, true}) {
    const std::vector<AirTo> listed = air_to(executor(), scene, list, {volume, {}});
    const std::vector<AirTo> all = air_to_all(executor(), scene, rows, {volume, {}});
    ASSERT_EQ(all.size(), rows.size());
    auto next = listed.begin();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const AirTo expected = std::isfinite(rows[i]) ? *next++ : AirTo{{}, {1.0F, 1.0F, 1.0F}};
      EXPECT_EQ(all[i].radiance, expected.radiance) << i;
      EXPECT_EQ(all[i].transmittance, expected.transmittance) << i;
    }
  }
}

// The sun's unit does not matter: from a billionth to a billion, the volume's halves and the result's 21 bits hold what
// floats do.
TEST(Spans, TheSunsUnitIsNoMatter) {
  Scene scene = all_round(hazy(0.1), 0.1, 16, 8);
  const std::vector<Span> spans = spans_at(scene, 20.0);
  Executor as_a_gpu(DeviceOptions{.halves = true});
  for (const bool volume : {false, true}) {
    scene.sun.irradiance = {1.0, 1.0, 1.0};
    const std::vector<AirTo> one = air_to(as_a_gpu, scene, spans, {volume, {}});
    for (const double sun : {1e-9, 1e9}) {
      scene.sun.irradiance = {sun, sun, sun};
      const std::vector<AirTo> airs = air_to(as_a_gpu, scene, spans, {volume, {}});
      for (std::size_t i = 0; i < airs.size(); ++i) {
        // 2^-13, twice the rounding of 13 bits of mantissa.
        EXPECT_NEAR(static_cast<double>(airs[i].radiance[1]) / (sun * static_cast<double>(one[i].radiance[1])), 1.0,
                    1.3e-4);
        EXPECT_EQ(airs[i].transmittance, one[i].transmittance);
      }
    }
  }
}

// The error of halves, against the floats that processors keep in their place. Over black ground the whole ray's light
// is the air's.
TEST(Spans, HalvesAreGoodToTwoThousandths) {
  Scene scene = all_round(hazy(0.1), 0.1, 16, 8);
  const std::vector<Span> spans = spans_at(scene, 20.0);
  Executor halves(DeviceOptions{.halves = true});
  Executor floats(DeviceOptions{.halves = false});
  for (const double elevation : {20.0, -5.0}) {
    scene.sun.elevation = elevation * kDegree;
    for (const bool volume : {false, true}) {
      const std::vector<AirTo> a = air_to(halves, scene, spans, {volume, {}});
      const std::vector<AirTo> b = air_to(floats, scene, spans, {volume, {}});
      double greatest = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double truth = static_cast<double>(b[i].radiance[c]);
          greatest = std::max(greatest, std::abs(static_cast<double>(a[i].radiance[c]) / truth - 1.0));
        }
      }
      EXPECT_LT(greatest, 2e-3) << elevation << (volume ? " volume" : " march");
      EXPECT_GT(greatest, 0.0) << elevation << (volume ? " volume" : " march");
    }
  }
}

TEST(Spans, BeyondTheAirTheyAreTheSky) {
  for (const double altitude : {0.1, 20.0, 400.0}) {
    Scene scene = all_round(hazy(altitude), altitude, 16, 8);
    scene.planet.ground_albedo = {};
    scene.sun.disc.visible = false;
    const Rendering sky = render_now(scene);
    const std::vector<AirTo> airs = air_to(executor(), scene, spans_at(scene, 1e6));
    Scene finer = scene;  // spans take half of the picture's steps
    finer.render.parameters.insert_or_assign("steps", 96);
    const std::vector<AirTo> finer_airs = air_to(executor(), finer, spans_at(scene, 1e6));
    physics::Physics p = make_physics(scene);
    const physics::uint projection = projection_code(scene.camera.projection);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 16; ++x) {
        const auto view = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
        if (p.pixel_rays(p.scene.planet, p.scene.camera, projection, x + 0.5, y + 0.5, view.direction).count > 1) {
          continue;  // the picture's value is a mean across the planet's edge
        }
        for (std::size_t c = 0; c < 3; ++c) {
          const float whole = sky.radiance.at(x, y)[c];
          // From within the air a ray to the ground takes fewer steps, only as many as its part of the air needs. The
          // moments' ratios in halves are good to 5e-4.
          const float bound = altitude < 100.0 && y >= 4 ? 2e-3F : 5e-4F;
          const auto i = static_cast<std::size_t>(16 * y + x);
          EXPECT_NEAR(finer_airs[i].radiance[c], whole, bound * whole) << altitude << " km, " << x << ", " << y;
          EXPECT_NEAR(airs[i].radiance[c], whole, 2e-3F * whole) << altitude << " km, " << x << ", " << y;
        }
      }
    }
  }
}

// The air up to a and from there to b add up to the air up to b: straight up, where the sun has the same angle all the
// way.
TEST(Spans, AddUpAlongARay) {
  for (const char* shells : {"never", "always"}) {
    Scene scene = hazy(0.5);
    scene.camera.pitch = 90.0 * kDegree;
    scene.image = {1, 1};
    scene.render.parameters.find("shells")->second = std::string(shells);
    const auto up_from = [&](double altitude, double distance) {
      scene.camera.altitude = altitude;
      return air_to(executor(), scene, spans_at(scene, distance)).front();
    };
    const AirTo near = up_from(0.5, 4.0);
    const AirTo far = up_from(4.5, 6.0);
    const AirTo whole = up_from(0.5, 10.0);
    for (std::size_t c = 0; c < 3; ++c) {
      const float sum = near.radiance[c] + near.transmittance[c] * far.radiance[c];
      EXPECT_NEAR(sum, whole.radiance[c], 2e-3F * whole.radiance[c]) << shells << ", channel " << c;
      EXPECT_NEAR(near.transmittance[c] * far.transmittance[c], whole.transmittance[c], 2e-4F);
    }
  }
}

// Light only grows with the distance.
TEST(Spans, TransmittanceIsThatOfTheAirBetween) {
  const Scene scene = all_round(hazy(0.5), 0.5, 16, 8);
  std::vector<AirTo> before = air_to(executor(), scene, spans_at(scene, 0.01));
  for (const double distance : {1.0, 10.0, 100.0}) {
    const std::vector<Span> spans = spans_at(scene, distance);
    const std::vector<AirTo> airs = air_to(executor(), scene, spans);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const Depths depths = depths_to(scene, std::sin(direction_at(scene, spans[i].x, spans[i].y).elevation), distance);
      EXPECT_NEAR(airs[i].transmittance[0], std::exp(-depths.scaled.x), 2e-3) << distance << " km, span " << i;
      EXPECT_NEAR(airs[i].transmittance[2], std::exp(-depths.scaled.z), 2e-3) << distance << " km, span " << i;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_GE(airs[i].radiance[c] * 1.0001F, before[i].radiance[c]);
      }
    }
    before = airs;
  }
}

// A black wall at 1, 10, 50 and 200 km, from 500 m, with path-trace and with orders. The wall stops the camera's ray
// alone, so what forward peaks scatter of the light behind it still comes. `orders` counts that as light of the thing,
// in its transmittance, hence it is added here: the difference to the beam's transmittance, of the light behind.
TEST(Spans, AgreeWithPathTraceBeforeABlackWall) {
  Scene scene = hazy(0.5);
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.projection = Projection::equirectangular;
  scene.image = {8, 64};
  // Level, a little up, a little down; toward the sun and across.
  const std::vector<std::pair<int, int>> pixels{{4, 31}, {4, 27}, {6, 31}, {6, 29}, {0, 31}, {4, 33}};
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters.find("samples")->second = 1024;
  for (const double wall : {1.0, 10.0, 50.0, 200.0}) {
    std::vector<Span> spans;
    std::vector<Direction> directions;
    for (const auto& [x, y] : pixels) {
      spans.push_back(span_at(x, y, wall));
      directions.push_back(direction_at(scene, x, y));
    }
    const std::vector<AirTo> airs = air_to(executor(), scene, spans);
    const std::vector<ProbeResult> open = probe_now(scene, directions);
    View view{directions};
    view.wall = wall;
    const HostPicture truth = airlight::traced(traced, view, {});
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (pixels[i].second > 32 && wall > 5.0) {
        continue;  // the ground, which is not black, stands before the wall
      }
      const physics::vec3 peaks = depths_to(scene, std::sin(directions[i].elevation), wall).peaks;
      for (std::size_t c = 0; c < 3; ++c) {
        const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
        const double noise = static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[c]);
        const double light = static_cast<double>(airs[i].radiance[c]);
        const double kept = static_cast<double>(airs[i].transmittance[c]);
        const double beam = kept * std::exp(-channel(peaks, c));
        const double behind = (static_cast<double>(open[i].radiance[c]) - light) / kept;
        EXPECT_NEAR(light + (kept - beam) * behind, want, 0.02 * want + 3.0 * noise)
            << wall << " km, direction " << i << ", channel " << c;
        EXPECT_NEAR(beam, static_cast<double>(truth.transmittance.at(static_cast<int>(i), 0)[c]), 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
