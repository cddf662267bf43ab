// Terrain by path-trace, which finds it by steps of its own: where rays meet it, against the shaders' way; and its
// picture and its shadow in the air, against `orders`.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/methods/path_trace/things_trace.h"
#include "core/render/spans.h"
#include "core/things/terrain.h"
#include "tests/methods/spectral_scene.h"
#include "tests/methods/terrain_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

physics::vec3 camera_of(const Scene& scene) {
  return {0.0, scene.planet.ground_radius + scene.camera.altitude, 0.0};
}

TEST(TracedTerrain, IsMetWhereTheShadersMeetIt) {
  const Scene scene = range_in_haze("orders", 20.0);
  physics::Physics p = make_physics(scene);
  p.terrain_maps = shadowed_terrain(scene);
  const TracedTerrain traced(scene, terrain_of(scene));
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int hits = 0;
  int apart = 0;
  for (int k = 0; k < 2000; ++k) {
    const physics::vec3 view =
        p.direction_from_angles((8.0 * uniform(engine) - 1.0) * kDegree, (30.0 + 120.0 * uniform(engine)) * kDegree);
    const auto theirs = p.terrain_hit(p.scene.planet, p.ground_track(scene.camera.altitude, view));
    const auto ours = traced.hit(camera_of(scene), view, 1e3);
    const bool same = theirs.hit == ours.has_value() && (!ours || std::abs(*ours - theirs.distance_) < 0.02);
    apart += same ? 0 : 1;  // grazes between the three points of a cell that the shaders' way looks at
    hits += ours ? 1 : 0;
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 1900);
  EXPECT_LE(apart, 100);
}

// Long steps over what is lower pass through no slope: rays between the peaks, up and down, against steps of a fiftieth
// of a cell.
TEST(TracedTerrain, StepsOverNothing) {
  const Scene scene = range_in_haze("orders", 20.0);
  const auto maps = terrain_of(scene);
  physics::Physics p = make_physics(scene);
  const TracedTerrain traced(scene, maps);
  const double radius = scene.planet.ground_radius;
  const auto clearance = [&](physics::vec3 place) {
    const physics::vec2 at = traced.on_map(place);
    return length(place) - radius - p.map_height(maps->shape, at.x, at.y);
  };
  p.terrain_maps = maps;
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int hits = 0;
  int apart = 0;
  constexpr int kRays = 300;
  for (int k = 0; k < kRays; ++k) {
    const auto random = [&] { return uniform(engine); };
    const double a = 0.3 + 0.4 * random();
    const auto from = place_in_range(p, radius, a, random(), random());
    if (!from) {
      continue;
    }
    const physics::vec3 place = from->up * (radius + from->h);
    const physics::vec3 direction =
        p.direction_from_angles((16.0 * random() - 8.0) * kDegree, 360.0 * random() * kDegree);
    constexpr double kLimit = 10.0;
    const double step = 0.02 * maps->shape.texel;
    double expected = kLimit;
    for (double t = 0.0; t < kLimit && expected == kLimit; t += step) {
      expected = clearance(place + direction * t) < 0.0 ? t : expected;
    }
    const double found = traced.hit(place, direction, kLimit).value_or(kLimit);
    hits += expected < kLimit ? 1 : 0;
    apart += std::abs(found - expected) > 2.0 * step ? 1 : 0;
  }
  EXPECT_GT(hits, 60);
  EXPECT_LE(apart, 2) << "more than rays that graze";
}

TEST(TracedTerrain, HidesTheSunWhereTheTableOfShadowsSaysSo) {
  const Scene scene = range_in_haze("orders", 5.0);
  physics::Physics p = make_physics(scene);
  p.terrain_maps = shadowed_terrain(scene);
  const TracedThings traced(part_of(scene));
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int hidden = 0;
  int wrong = 0;
  constexpr int kPoints = 1000;
  for (int k = 0; k < kPoints; ++k) {
    const double a = uniform(engine);
    const double b = uniform(engine);
    const auto at = place_in_range(p, scene.planet.ground_radius, a, b, uniform(engine));
    if (!at) {
      continue;
    }
    const double share = p.terrain_sunlit(p.terrain_shape(), at->east, at->north, at->h);
    const bool dark = traced.hides_sun(p, at->up * (scene.planet.ground_radius + at->h), at->h, Sunbeam{}, kNoThing);
    hidden += dark ? 1 : 0;
    wrong += std::abs(share - (dark ? 0.0 : 1.0)) > 0.75 ? 1 : 0;
  }
  EXPECT_GT(hidden, 100);
  EXPECT_LE(wrong, kPoints / 100);
}

struct Compared {
  double mean = 0.0;
  double worst = 0.0;  // beyond three standard errors, of the truth
  double bias = 0.0;   // of the sum over directions
};

Compared compare(const std::vector<ProbeResult>& found, const HostPicture& truth) {
  Compared all;
  double sum = 0.0;
  double truths = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
      const double noise = static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[c]);
      const double error = std::abs(found[i].radiance[c] - want);
      all.mean += error / want / (3.0 * static_cast<double>(found.size()));
      all.worst = std::max(all.worst, (error - 3.0 * noise) / want);
      sum += found[i].radiance[c];
      truths += want;
    }
  }
  all.bias = sum / truths - 1.0;
  return all;
}

HostPicture traced_at(const Scene& scene, const std::vector<Direction>& directions, int samples, int orders) {
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters.insert_or_assign("samples", samples);
  traced.render.parameters.insert_or_assign("max_orders", orders);
  return airlight::traced(traced, View{directions}, {});
}

// The light that shadows take out of the sky over the range: path-trace of one scattering with and without terrain, in
// directions that end on nothing.
TEST(TerrainTruth, ShaftsAreWhatPathTraceTakesOutOfTheSky) {
  const Scene scene = range_in_haze("orders", 4.0);
  std::vector<Direction> directions;
  for (const double elevation : {7.5, 8.2, 9.0, 11.0, 14.0}) {
    for (const double azimuth : {75.0, 82.0, 88.0, 94.0, 101.0}) {
      directions.push_back({elevation * kDegree, azimuth * kDegree});
    }
  }
  Scene open = scene;
  open.render.parameters.insert_or_assign("volumetric_shadows", std::string("false"));
  const std::vector<ProbeResult> with = probe_now(scene, directions);
  const std::vector<ProbeResult> without = probe_now(open, directions);
  Scene bare = scene;
  bare.terrain.reset();
  const HostPicture shaded = traced_at(scene, directions, 32, 1);
  const HostPicture lit = traced_at(bare, directions, 32, 1);
  double greatest_share = 0.0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = static_cast<int>(k);
      const double truth =
          static_cast<double>(lit.radiance.at(at, 0)[c]) - static_cast<double>(shaded.radiance.at(at, 0)[c]);
      const double taken = without[k].radiance[c] - with[k].radiance[c];
      greatest_share = std::max(greatest_share, truth / without[k].radiance[c]);
      EXPECT_NEAR(taken, truth, 0.06 * truth + 0.003 * without[k].radiance[c]) << k << ", " << c;
    }
  }
  EXPECT_GT(greatest_share, 0.1) << "no shaft to see";
}

// The air before things in front of the range or over it, with the range's shadow: a black wall, against path-trace.
TEST(TerrainTruth, TheAirBeforeThingsIsPathTraces) {
  Scene scene = range_in_haze("orders", 4.0);
  scene.camera.projection = Projection::equirectangular;
  scene.camera.azimuth = 90.0 * kDegree;
  scene.image = {48, 96};
  physics::Physics p = make_physics(scene);
  p.terrain_maps = terrain_of(scene);
  Scene open = scene;
  open.terrain.reset();
  double most_shaded = 0.0;
  for (const double wall : {5.0, 15.0, 40.0}) {
    std::vector<Span> spans;
    std::vector<Direction> directions;
    for (int k = 0; k < 12; ++k) {
      const int x = 21 + k % 6;
      const int y = k < 6 ? 42 : 45;
      const auto view = p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, x + 0.5, y + 0.5);
      const physics::vec3 d = view.direction;
      const auto hit = p.terrain_hit(p.scene.planet, p.ground_track(scene.camera.altitude, d));
      if (!hit.hit || hit.distance_ > wall) {
        spans.push_back(span_at(x, y, wall));
        directions.push_back({std::atan2(d.y, std::hypot(d.x, d.z)), std::atan2(d.x, -d.z)});
      }
    }
    ASSERT_GT(spans.size(), 5u);
    const std::vector<AirTo> airs = air_to(executor(), scene, spans);
    const std::vector<AirTo> unshaded = air_to(executor(), open, spans);
    Scene traced = with_method(scene, *find_method("path-trace"));
    traced.render.parameters.insert_or_assign("samples", 512);
    View view{directions};
    view.wall = wall;
    const HostPicture truth = airlight::traced(traced, view, {});
    for (std::size_t i = 0; i < spans.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
        const double noise = static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[c]);
        EXPECT_NEAR(static_cast<double>(airs[i].radiance[c]), want,
                    0.07 * static_cast<double>(unshaded[i].radiance[c]) + 3.0 * noise)
            << wall << " km, " << i << ", " << c;
        EXPECT_NEAR(airs[i].transmittance[c], unshaded[i].transmittance[c], 1e-3F);
        most_shaded = std::max(most_shaded, 1.0 - static_cast<double>(airs[i].radiance[c] / unshaded[i].radiance[c]));
      }
    }
  }
  EXPECT_GT(most_shaded, 0.1);
}

// All orders: slopes in sun and shade, and the sky over them. Without the shares of light among terrain the slopes in
// the range's own shadow are 71 % too bright and the sky over it 6 %.
TEST(TerrainTruth, OrdersIsNearPathTrace) {
  struct Case {
    double elevation;  // of the sun
    bool terrain;      // slopes, or the sky over them
    int samples;
    double mean;
    double worst;
    double bias;
  };
  for (const Case& c : {Case{35.0, true, 2048, 0.025, 0.025, 0.02}, Case{35.0, false, 256, 0.025, 0.02, 0.02},
                        Case{4.0, true, 1024, 0.2, 0.35, 0.1}, Case{4.0, false, 256, 0.03, 0.03, 0.025}}) {
    const Scene scene = range_in_haze("orders", c.elevation);
    physics::Physics p = make_physics(scene);
    p.terrain_maps = terrain_of(scene);
    std::vector<Direction> directions;
    for (double elevation = 0.4; elevation < 20.0 && directions.size() < 24; elevation *= 1.6) {
      for (double azimuth = 60.0; azimuth < 125.0; azimuth += 12.0) {
        const Direction d{elevation * kDegree, azimuth * kDegree};
        const auto track = p.ground_track(scene.camera.altitude, p.direction_from_angles(d.elevation, d.azimuth));
        if (p.terrain_hit(p.scene.planet, track).hit == c.terrain) {
          directions.push_back(d);
        }
      }
    }
    ASSERT_GT(directions.size(), 8u);
    const Compared found = compare(probe_now(scene, directions), traced_at(scene, directions, c.samples, 0));
    EXPECT_LT(found.mean, c.mean) << c.elevation << (c.terrain ? " slopes" : " sky");
    EXPECT_LT(found.worst, c.worst) << c.elevation << (c.terrain ? " slopes" : " sky");
    EXPECT_LT(std::abs(found.bias), c.bias) << c.elevation << (c.terrain ? " slopes" : " sky");
    std::printf("sun %g, %s: mean %.4f, worst %.4f, bias %.4f\n", c.elevation, c.terrain ? "slopes" : "sky", found.mean,
                found.worst, found.bias);
  }
}

// A scene with curves and a red and green map over its slopes: `orders` at the wavelengths that it takes against paths
// with twelve. Three, which are within 1 % for the sky, are 17 % off on a slope.
TEST(TerrainTruth, SpectraAndTheirMapsArePathTraces) {
  Scene scene = scene_of(clear_air(R"({"named": "air"})", R"({"elevation_deg": 35, "azimuth_deg": 90})",
                                   R"(, "render": {"method": "orders"})"));
  scene.sun.elevation = 35.0 * kDegree;
  scene.sun.azimuth = 270.0 * kDegree;
  scene.camera.altitude = 0.1;
  scene.terrain = range_in_haze("orders", 35.0).terrain;
  scene.terrain->albedo_map = "in memory";
  TerrainFiles files;
  files.identity = "red and green";
  files.colour_columns = 2;
  files.colour_rows = 1;
  files.colours = {0.5F, 0.2F, 0.1F, 0.15F, 0.4F, 0.1F};
  scene.terrain->files = std::make_shared<const TerrainFiles>(files);
  scene.terrain->albedo.curve = constant_curve(0.8);
  std::vector<Direction> directions;
  for (const double elevation : {0.8, 1.5, 2.5, 3.5}) {
    for (double azimuth = 60.0; azimuth < 121.0; azimuth += 12.0) {
      directions.push_back({elevation * kDegree, azimuth * kDegree});
    }
  }
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  Scene fine = scene;
  fine.spectra->wavelengths = 12;
  const Compared all = compare(found, traced_at(fine, directions, 512, 0));
  std::printf("spectra: mean %.4f, worst %.4f, bias %.4f\n", all.mean, all.worst, all.bias);
  EXPECT_LT(all.mean, 0.02);
  EXPECT_LT(all.worst, 0.04);
  EXPECT_LT(std::abs(all.bias), 0.02);
}

}  // namespace
}  // namespace airlight::test
