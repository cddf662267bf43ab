// Terrain, spheres and the ground by maps in one picture of `orders`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/things/ground.h"
#include "tests/methods/cloud_scene.h"
#include "tests/methods/listed_rays.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr unsigned int kTerrain = 1;
constexpr unsigned int kSpheres = 2;
constexpr unsigned int kOcean = 4;
constexpr unsigned int kAll = kTerrain | kSpheres | kOcean;

Sphere ball(SphereMaterial material, double azimuth, double elevation, double distance, double radius) {
  Sphere sphere;
  sphere.azimuth = azimuth * kDegree;
  sphere.elevation = elevation * kDegree;
  sphere.distance = distance;
  sphere.radius = radius;
  sphere.material = material;
  sphere.albedo = {0.6, 0.6, 0.6};
  return sphere;
}

// What a map's 10 bits for the root of an albedo hold exactly, near 0.24.
constexpr double kSeaAlbedo = (500.0 / 1023.0) * (500.0 / 1023.0);

// A map of one albedo, and water everywhere.
void put_sea(Scene& scene) {
  auto files = std::make_shared<GroundFiles>();
  files->identity = "sea";
  files->colour_rows = 4;
  files->colours.assign(3 * 4 * 8, static_cast<float>(kSeaAlbedo));
  scene.ground = GroundMap{.albedo_map = "sea", .ocean = Ocean{}, .files = files};
  scene.planet.ground_albedo = mean_albedo(*files);
}

// Mountains to the east, a ball of 600 m before them, one of 1 m and a mirror before the camera, the sea all about.
Scene shore(unsigned int things, const char* shells = "never") {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.render.parameters.find("shells")->second = std::string(shells);
  scene.planet.ground_albedo = {kSeaAlbedo, kSeaAlbedo, kSeaAlbedo};
  scene.sun.elevation = 30.0 * kDegree;
  scene.sun.azimuth = 200.0 * kDegree;
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.camera.altitude = 0.02;
  scene.camera.azimuth = 90.0 * kDegree;
  scene.camera.pitch = 0.0;
  scene.camera.vertical_fov = 50.0 * kDegree;
  scene.image = {40, 24};
  if ((things & kTerrain) != 0) {
    Terrain terrain;
    terrain.ridge = Ridge{7, 1.6};
    terrain.width = 20.0;
    terrain.bearing = 90.0 * kDegree;
    terrain.distance = 8.0;
    terrain.turn = 90.0 * kDegree;
    terrain.albedo = {0.4, 0.4, 0.4};
    scene.terrain = terrain;
  }
  if ((things & kSpheres) != 0) {
    scene.spheres = {ball(SphereMaterial::matte, 80.0, 8.0, 4.0, 0.6),
                     ball(SphereMaterial::matte, 110.0, -6.0, 0.02, 0.002),
                     ball(SphereMaterial::mirror, 98.0, -8.0, 0.02, 0.002)};
  }
  if ((things & kOcean) != 0) {
    put_sea(scene);
  }
  return scene;
}

Physics formulas_with_things(const Scene& scene) {
  const Part part = part_of(scene);
  Physics p = formulas_of(part.air, part.scene);
  part.things.put_into(p);
  return p;
}

std::vector<Direction> lattice(const Scene& scene) {
  std::vector<Direction> directions;
  for (double elevation = -18.0; elevation < 16.0; elevation += 1.7) {
    for (double azimuth = 62.0; azimuth < 120.0; azimuth += 2.9) {
      directions.push_back({elevation * kDegree, azimuth * kDegree});
    }
  }
  EXPECT_GT(directions.size(), 300u) << scene.name;
  return directions;
}

// Where no thing shades another, a ray's light is that of a scene with the nearest thing alone, but for the light that
// things send to one another and to the air and hide there: little under a high sun.
TEST(Things, ARayShowsTheNearestSurface) {
  for (const unsigned int things : {kTerrain | kSpheres, kTerrain | kOcean, kSpheres | kOcean, kAll}) {
    Scene scene = shore(things);
    scene.sun.elevation = 85.0 * kDegree;
    scene.render.parameters.find("volumetric_shadows")->second = std::string("false");
    Physics p = formulas_with_things(scene);
    const std::vector<Direction> directions = lattice(scene);
    const std::vector<ProbeResult> all = probe_now(scene, directions);
    std::array<std::vector<ProbeResult>, 4> alone;
    for (const unsigned int what : {p.kMeetsGround, p.kMeetsTerrain, p.kMeetsBody}) {
      Scene one = shore(what == p.kMeetsGround ? things & kOcean : what == p.kMeetsTerrain ? kTerrain : kSpheres);
      one.sun.elevation = scene.sun.elevation;
      one.render = scene.render;
      alone[what] = probe_now(one, directions);
    }
    alone[p.kMeetsSky] = alone[p.kMeetsGround];
    const bool lit_by_more = (things & (kTerrain | kSpheres)) != 0;
    std::array<int, 4> seen{};
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const vec3 view = p.direction_from_angles(directions[k].elevation, directions[k].azimuth);
      const auto sight = p.sight_of(view);
      const auto hit = p.nearest_thing(p.scene.planet, sight, physics::kNoBody);
      if (hit.what == p.kMeetsBody && p.spheres[hit.which].material == physics::kSphereMirror) {
        continue;
      }
      const vec3 point = view * hit.distance_;
      const bool under_a_ball =
          p.sun_past_bodies(point, p.scene.sun.direction, p.scene.sun.angular_radius, hit.which) < 1.0;
      if (hit.what != p.kMeetsSky && under_a_ball) {
        continue;
      }
      ++seen[hit.what];
      for (std::size_t c = 0; c < 3; ++c) {
        const double truth = alone[hit.what][k].radiance[c];
        EXPECT_NEAR(all[k].radiance[c], truth, lit_by_more ? 0.15 * truth + 0.03 : 0.004 * truth)
            << things << ": " << hit.what << " at " << directions[k].elevation / kDegree << ", "
            << directions[k].azimuth / kDegree;
      }
    }
    EXPECT_GT(seen[p.kMeetsSky], 20) << things;
    EXPECT_GT(seen[p.kMeetsGround], 20) << things;
    EXPECT_EQ(seen[p.kMeetsTerrain] > 20, (things & kTerrain) != 0) << things;
    EXPECT_EQ(seen[p.kMeetsBody] > 5, (things & kSpheres) != 0) << things;
  }
}

// In air that scatters nothing, what things hide from all of the sun's disc is black, and what faces all of it is lit.
struct Shades {
  std::array<int, 4> dark{};
  std::array<int, 4> lit{};
  int black = 0;  // of those that are lit
};

void look_for_leaks(double sun_azimuth, Shades& shades) {
  Scene scene = shore(kAll);
  scene.media = {scene.media[2]};
  scene.planet.ground_albedo = {};  // what lights things from below
  scene.sun.elevation = 14.0 * kDegree;
  scene.sun.azimuth = sun_azimuth;
  // Above the camera's eyes, so that its shadow is seen below it, on the water.
  scene.spheres.push_back(ball(SphereMaterial::matte, 60.0, 12.0, 0.02, 0.006));
  Physics p = formulas_with_things(scene);
  const double h = scene.camera.altitude;
  const vec3 sun = p.scene.sun.direction;
  const vec3 side = physics::normalize(vec3(-sun.z, 0.0, sun.x));
  const vec3 over =
      vec3(sun.y * side.z - sun.z * side.y, sun.z * side.x - sun.x * side.z, sun.x * side.y - sun.y * side.x);
  const std::vector<Direction> directions = lattice(scene);
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const vec3 view = p.direction_from_angles(directions[k].elevation, directions[k].azimuth);
    const auto sight = p.sight_of(view);
    const auto hit = p.nearest_thing(p.scene.planet, sight, physics::kNoBody);
    if (hit.what == p.kMeetsSky) {
      EXPECT_EQ(found[k].radiance[1], 0.0);
      continue;
    }
    const auto surface = p.surface_at(p.scene.planet, h, sight, hit, 0.0);
    if (surface.mirrors) {
      continue;
    }
    // Rays to points somewhat beyond the disc, as shadows on terrain are a table's.
    const double reach = 2.5 * p.scene.sun.angular_radius;
    int hidden = 0;
    for (int i = 0; i < 5; ++i) {
      const vec3 off = i == 0 ? vec3(0.0) : i == 1 ? side : i == 2 ? -side : i == 3 ? over : -over;
      const vec3 toward = physics::normalize(sun + off * reach);
      const vec3 start = surface.place.point + surface.normal * (hit.what == p.kMeetsTerrain ? 0.02 : 0.0);
      const auto ray = p.sight_from(p.scene.planet, h, start, toward, sun);
      hidden += p.hits_thing(p.nearest_thing(p.scene.planet, ray, hit.which)) ? 1 : 0;
    }
    const double facing = physics::dot(surface.normal, sun);
    if (facing < 0.0 || hidden == 5) {
      ++shades.dark[hit.what];
      // Balls in the sun shine into shadows.
      const auto sky = p.with_bodies({vec3(1.0), vec3(0.0)}, surface, sun, vec3(1.0), vec3(0.0), vec3(1.0), 1.0);
      EXPECT_LT(found[k].radiance[1], 1e-4 + surface.ground.albedo.y / std::numbers::pi * sky.more.y)
          << hit.what << " at " << directions[k].elevation / kDegree << ", " << directions[k].azimuth / kDegree;
    } else if (hidden == 0 && facing > 0.1) {
      ++shades.lit[hit.what];
      shades.black += found[k].radiance[1] > 0.01 * surface.ground.albedo.y ? 0 : 1;
    }
  }
}

TEST(Things, NoLightLeaksIntoShadows) {
  Shades shades;
  look_for_leaks(270.0 * kDegree, shades);
  look_for_leaks(25.0 * kDegree, shades);
  look_for_leaks(150.0 * kDegree, shades);
  const Physics p{};
  for (const unsigned int what : {p.kMeetsGround, p.kMeetsTerrain, p.kMeetsBody}) {
    EXPECT_GE(shades.dark[what], 3) << what;
    EXPECT_GT(shades.lit[what], 3) << what;
  }
  EXPECT_LE(shades.black, 3) << "next to a shadow's edge";
}

// The mirror shows mountains and sea as a camera at its middle sees them, which is metres away from its surface.
TEST(Things, MirrorsShowThings) {
  for (const char* shells : {"never", "always"}) {
    Scene scene = shore(kAll, shells);
    // West of the camera, so that it shows what stands in the east.
    scene.spheres = {ball(SphereMaterial::mirror, 270.0, -1.0, 0.02, 0.004)};
    Physics p = formulas_with_things(scene);
    std::vector<Direction> seen;
    std::vector<Direction> mirrored;
    std::array<int, 4> shown{};
    for (double elevation = -9.0; elevation < 9.0; elevation += 0.9) {
      for (double azimuth = 264.0; azimuth < 277.0; azimuth += 0.8) {
        const Direction direction{elevation * kDegree, azimuth * kDegree};
        const vec3 view = p.direction_from_angles(direction.elevation, direction.azimuth);
        const auto sight = p.sight_of(view);
        const auto hit = p.nearest_thing(p.scene.planet, sight, physics::kNoBody);
        if (hit.what != p.kMeetsBody) {
          continue;
        }
        const auto surface = p.surface_at(p.scene.planet, scene.camera.altitude, sight, hit, 0.0);
        const vec3 away = view - surface.normal * (2.0 * physics::dot(view, surface.normal));
        const auto second =
            p.sight_from(p.scene.planet, scene.camera.altitude, surface.place.point, away, p.scene.sun.direction);
        const auto behind = p.nearest_thing(p.scene.planet, second, hit.which);
        if (behind.distance_ > 0.1) {  // the ground at hand stands elsewhere for a camera there
          ++shown[behind.what];
          seen.push_back(direction);
          mirrored.push_back(angles_of(away));
        }
      }
    }
    Scene there = scene;
    there.spheres.clear();
    const std::vector<ProbeResult> found = probe_now(scene, seen);
    const std::vector<ProbeResult> truth = probe_now(there, mirrored);
    int apart = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double light = 0.6 * truth[i].radiance[1];
      apart += std::abs(found[i].radiance[1] - light) > 0.02 * light ? 1 : 0;
    }
    // Edges of slopes and shadows stand elsewhere, too.
    EXPECT_LE(apart, static_cast<int>(seen.size()) / 10) << shells << " of " << seen.size();
    EXPECT_GT(shown[p.kMeetsTerrain], 10);
    EXPECT_GT(shown[p.kMeetsGround], 3);
    EXPECT_GT(shown[p.kMeetsSky], 10);
  }
}

// The ways to find the air up to things.
constexpr std::array<const char*, 3> kShadowWays{"march", "froxels", "exact"};

Scene with_shadows(Scene scene, const std::string& way) {
  scene.render.parameters.insert_or_assign("volumetric_shadows", way);
  scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
  return scene;
}

void expect_tiles_are_the_picture(const Scene& scene, const std::string& what) {
  const Rendering whole = render_now(scene);
  expect_sound(whole, what);
  std::vector<float> rgba;
  BandsRequest request{.tile = ImageSize{7, 5}, .picture = {}, .exposure_first = false, .sink = {}};
  request.sink = [&](const Band& band) {
    rgba.insert(rgba.end(), band.rows.radiance.rgba.begin(), band.rows.radiance.rgba.end());
  };
  render_bands([]() -> Executor& { return executor(); }, scene, request);
  EXPECT_EQ(rgba, whole.radiance.rgba) << what;
}

// Pixels whose neighbours differ by less than a fifth.
bool is_even(const RadianceImage& picture, int x, int y) {
  const double here = channel_of(picture, x, y, 1);
  double most = 0.0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = std::clamp(x + dx, 0, picture.width - 1);
      const int row = std::clamp(y + dy, 0, picture.height - 1);
      most = std::max(most, std::abs(channel_of(picture, column, row, 1) / here - 1.0));
    }
  }
  return most < 0.2;
}

// Pixels that stand on rays; all others may lie between four of them (shaders/shared/thing_quads.glsl).
bool stands_on_a_ray(int x, int y) {
  constexpr std::array<bool, 8> kOnRay{true, false, true, false, false, true, false, true};
  return kOnRay[static_cast<std::size_t>(x) % 8] && kOnRay[static_cast<std::size_t>(y) % 8];
}

// How far pixels of a picture are off the same pixels' own rays: of those that stand on rays and of all others. Pixels
// whose neighbours differ are left out; of those with an edge, which are means of several rays, some remain.
struct OffOwnRays {
  std::vector<double> on_rays;
  std::vector<double> between;
};

// `own_rays`: three floats a pixel.
OffOwnRays off_own_rays(Scene scene, const std::function<std::vector<float>(const Scene&)>& own_rays) {
  scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
  scene.image = {101, 43};
  scene.camera.vertical_fov = 14.0 * kDegree;
  OffOwnRays off;
  for (const double azimuth : {0.0, 80.0, 160.0}) {
    scene.camera.azimuth = azimuth * kDegree;
    const RadianceImage picture = render_now(scene).radiance;
    const std::vector<float> rays = own_rays(scene);
    for (int k = 0; k < picture.width * picture.height; ++k) {
      const int x = k % picture.width;
      const int y = k / picture.width;
      if (is_even(picture, x, y)) {
        for (const std::size_t c : {0U, 1U, 2U}) {
          const double ray = rays[3 * static_cast<std::size_t>(k) + c];
          (stands_on_a_ray(x, y) ? off.on_rays : off.between)
              .push_back(std::abs(channel_of(picture, x, y, c) / ray - 1.0));
        }
      }
    }
  }
  std::ranges::sort(off.on_rays);
  std::ranges::sort(off.between);
  return off;
}

OffOwnRays off_listed_rays(const Scene& scene) {
  return off_own_rays(scene, listed_rays_of);
}

double at_share(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))];
}

void print_off(const char* what, const OffOwnRays& off) {
  for (const auto& [name, of] : {std::pair{"on rays", &off.on_rays}, std::pair{"between", &off.between}}) {
    std::printf("%s, pixels %s: 90 %% within %.2g of each ray's, 95 %% %.2g, 97 %% %.2g\n", what, name,
                at_share(*of, 0.9), at_share(*of, 0.95), at_share(*of, 0.97));
  }
}

TEST(Things, BlocksKnowTheAirOfTheirRays) {
  for (const unsigned int things : {kTerrain, kTerrain | kOcean}) {
    const OffOwnRays off = off_listed_rays(shore(things));
    print_off("air by blocks", off);
    for (const std::vector<double>& of : {off.on_rays, off.between}) {
      EXPECT_LT(at_share(of, 0.9), 0.003) << things;
      EXPECT_LT(at_share(of, 0.95), 0.006) << things;
    }
  }
}

// Around a low sun in haze the air's light changes by some percent across a square of blocks, and most squares are
// known between their corners still.
TEST(Things, BlocksOfASquareKnowTheirPartOfItsAir) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/mountain-sunrise.json"), method_infos());
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.image = {104, 72};
  scene.camera.vertical_fov = 8.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
  const RadianceImage picture = render_now(scene).radiance;
  const std::vector<float> rays = listed_rays_of(scene);
  std::vector<double> off;
  for (int k = 0; k < picture.width * picture.height; ++k) {
    const double ray = rays[3 * static_cast<std::size_t>(k) + 1];
    off.push_back(std::abs(channel_of(picture, k % picture.width, k / picture.width, 1) / ray - 1.0));
  }
  std::ranges::sort(off);
  std::printf("air of squares: half of the pixels within %.2g of each ray's, 90 %% %.2g\n", at_share(off, 0.5),
              at_share(off, 0.9));
  EXPECT_LT(at_share(off, 0.5), 0.003);
  EXPECT_LT(at_share(off, 0.9), 0.008);
}

// Without terrain, blocks from which bodies stand aside are rendered as if there were none but for what they hide of
// the sky.
TEST(Things, BlocksAsideOfBodiesAreTheirRays) {
  for (const unsigned int things : {kSpheres, kSpheres | kOcean}) {
    const OffOwnRays off = off_listed_rays(shore(things));
    print_off("aside of bodies", off);
    EXPECT_LT(at_share(off.on_rays, 0.9), 1e-5) << things;
    EXPECT_LT(at_share(off.on_rays, 0.97), 1e-3) << things;
    EXPECT_LT(at_share(off.between, 0.9), 1.5e-3) << things;
    EXPECT_LT(at_share(off.between, 0.97), 4e-3) << things;
  }
}

// Three wavelengths become colours where their pixels are written, more of them by passes over whole pictures. Listed
// rays go another way, so they tell whether the colours are right.
TEST(Things, OfThreeWavelengthsAreWrittenInColours) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/lookdev-spheres.json"), method_infos());
  scene.camera.pitch = 0.0;
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.spectra->wavelengths = 3;
  const OffOwnRays off = off_listed_rays(scene);
  print_off("three wavelengths", off);
  EXPECT_LT(at_share(off.on_rays, 0.9), 1e-5);
  EXPECT_LT(at_share(off.between, 0.9), 1.5e-3);
  for (const auto& [wavelengths, sums] : {std::pair{3, 0}, {6, 2}}) {
    scene.spectra->wavelengths = wavelengths;
    const Plan plan = plan_for(scene, {});
    EXPECT_EQ(std::ranges::count(plan.passes(), "spectral_sum", &PassDesc::shader), sums);
  }
}

// Under clouds, with shadows of a march, each pixel has rays of its own.
TEST(Things, BlocksUnderCloudsAreTheirRays) {
  const auto own_rays = [](const Scene& scene) {
    const RadianceImage picture = render_now(with_shadows(scene, "march")).radiance;
    std::vector<float> rays;
    for (int k = 0; k < picture.width * picture.height; ++k) {
      for (const std::size_t c : {0U, 1U, 2U}) {
        rays.push_back(static_cast<float>(channel_of(picture, k % picture.width, k / picture.width, c)));
      }
    }
    return rays;
  };
  for (const unsigned int things : {kTerrain | kOcean, kSpheres}) {
    Scene scene = with_shadows(shore(things), "exact");
    std::erase_if(scene.spheres, [](const Sphere& sphere) { return sphere.material == SphereMaterial::mirror; });
    scene.clouds = under_level_cloud(1.0, 0.5).clouds;
    const OffOwnRays off = off_own_rays(scene, own_rays);
    print_off("under clouds", off);
    EXPECT_LT(at_share(off.on_rays, 0.95), 1e-3) << things;
    EXPECT_LT(at_share(off.between, 0.9), 1.5e-3) << things;
    EXPECT_LT(at_share(off.between, 0.95), 4e-3) << things;
    const Plan plan = plan_for(scene, {});
    EXPECT_GT(std::ranges::count(plan.passes(), "thing_rays_clouds", &PassDesc::shader), 0) << things;
  }
}

TEST(Things, TilesAreThePicture) {
  for (const unsigned int things : {kTerrain | kSpheres, kTerrain | kOcean, kSpheres | kOcean, kAll}) {
    Scene scene = shore(things);
    scene.sun.disc.visible = true;
    scene.image = {24, 14};
    expect_tiles_are_the_picture(scene, std::to_string(things));
  }
  Scene scene = shore(kAll);
  scene.image = {37, 23};
  for (const char* way : kShadowWays) {
    expect_tiles_are_the_picture(with_shadows(scene, way), way);
  }
}

// How far a way of finding shadows is off the march: the mean over all pixels, the worst pixel away from edges, and
// what shadows take from the march in the mean.
struct OffTheMarch {
  double mean = 0.0;
  double worst = 0.0;
  double shade = 0.0;
};

OffTheMarch off_the_march(const Scene& scene, const std::string& way) {
  const RadianceImage march = render_now(with_shadows(scene, "march")).radiance;
  const RadianceImage open = render_now(with_shadows(scene, "false")).radiance;
  const RadianceImage found = render_now(with_shadows(scene, way)).radiance;
  const int pixels = scene.image.width * scene.image.height;
  OffTheMarch off;
  for (int k = 0; k < pixels; ++k) {
    const int x = k % scene.image.width;
    const int y = k / scene.image.width;
    const double truth = channel_of(march, x, y, 1);
    const double error = std::abs(channel_of(found, x, y, 1) / truth - 1.0);
    off.mean += error / pixels;
    off.shade += (channel_of(open, x, y, 1) / truth - 1.0) / pixels;
    off.worst = is_even(march, x, y) ? std::max(off.worst, error) : off.worst;
  }
  std::printf("%s: mean %.5f, worst %.4f off the march; shadows take %.4f\n", way.c_str(), off.mean, off.worst,
              off.shade);
  return off;
}

// Mountains before a low sun throw shadows into haze; balls stand on the shore, one of them a mirror.
TEST(Things, TablesAreTheMarch) {
  for (const char* shells : {"never", "always"}) {
    Scene scene = shore(kAll, shells);
    scene.sun.elevation = 6.0 * kDegree;
    scene.sun.azimuth = 95.0 * kDegree;
    scene.image = {96, 56};
    for (const std::string way : {"froxels", "exact"}) {
      const OffTheMarch off = off_the_march(scene, way);
      EXPECT_LT(off.mean, way == "exact" ? 0.0025 : 0.01) << way;
      EXPECT_LT(off.worst, way == "exact" ? 0.05 : 0.7) << way;  // froxels here are two degrees wide
      EXPECT_GT(off.shade, 0.1) << "too little to tell by";
    }
  }
}

// From above rays end at the ground before shadows do.
TEST(Things, FroxelsFromAPeakAreTheMarch) {
  Scene scene = shore(kTerrain);
  scene.camera.altitude = 1.5;
  scene.camera.pitch = -5.0 * kDegree;
  scene.sun.elevation = 6.0 * kDegree;
  scene.sun.azimuth = 95.0 * kDegree;
  scene.image = {96, 56};
  const OffTheMarch off = off_the_march(scene, "froxels");
  EXPECT_LT(off.mean, 0.01);
  EXPECT_GT(off.shade, 0.02) << "too little to tell by";
}

// The light of fog comes from a short part of each ray, where terrain's share of it changes fast.
TEST(Things, FogInAValleyIsTheMarch) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/valley-fog.json"), method_infos());
  scene.image = {96, 56};
  const OffTheMarch off = off_the_march(scene, "exact");
  EXPECT_LT(off.mean, 0.005);
}

// More would lose light silently on the software device: 2048 past terrain and 512 past mirrors do.
TEST(Things, MarchesOfTooManyStepsAreRefused) {
  for (const auto& [things, steps] : {std::pair{kTerrain, 1025}, std::pair{kAll, 257}}) {
    Scene scene = with_shadows(shore(things), "march");
    scene.image = {8, 4};
    scene.render.parameters.find("steps")->second = steps;
    EXPECT_THROW(render_now(scene), InputError) << steps;
  }
}

TEST(Things, LayersSumUpToThePicture) {
  for (const char* way : kShadowWays) {
    Scene scene = with_shadows(shore(kAll, way == kShadowWays[0] ? "never" : "always"), way);
    scene.image = {24, 14};
    RenderRequest request;
    request.layers = LayerSet::light;
    const Rendering rendering = render_now(scene, request);
    EXPECT_EQ(rendering.fault(), "");
    EXPECT_EQ(rendering.radiance.rgba, render_now(scene).radiance.rgba);
    Physics p = formulas_with_things(scene);
    const std::size_t plane = 24 * 14;
    for (std::size_t i = 0; i < plane; ++i) {
      const int x = static_cast<int>(i) % 24;
      const int y = static_cast<int>(i) / 24;
      double sum = 0.0;
      const Layer* depth = nullptr;
      for (const Layer& layer : rendering.layers) {
        sum += layer.is_light ? static_cast<double>(layer.planes[plane + i]) : 0.0;
        depth = layer.name == "depth" ? &layer : depth;
      }
      const double beauty = channel_of(rendering.radiance, x, y, 1);
      EXPECT_NEAR(sum, beauty, (stands_on_a_ray(x, y) ? 5e-4 : 2e-3) * beauty) << x << ", " << y;
      const auto ray = p.view_ray(p.scene.camera, physics::kProjectionPerspective, x + 0.5, y + 0.5);
      const auto hit = p.nearest_thing(p.scene.planet, p.sight_of(ray.direction), physics::kNoBody);
      ASSERT_NE(depth, nullptr);
      if (hit.what != p.kMeetsSky) {
        EXPECT_NEAR(static_cast<double>(depth->planes[i]), hit.distance_, 1e-5 * hit.distance_) << x << ", " << y;
      }
    }
  }
}

// With curves that are the same at all wavelengths the picture is that of three channels.
TEST(Things, FlatCurvesAreThreeChannels) {
  const auto made = [](const std::string& number, const std::string& sun, const std::string& render) {
    Scene scene = scene_of(R"({"airlight": 1, "planet": {"ground_albedo": )" + number + R"(,
      "ocean": {}, "albedo_map": "sea", "terrain": {"ridge": {"seed": 7, "height_km": 1.6}, "width_km": 20,
      "bearing_deg": 90, "distance_km": 8, "turn_deg": 90, "albedo": 0.4}},
      "scene": {"spheres": [{"azimuth_deg": 80, "elevation_deg": 8, "distance_m": 4000, "radius_m": 600, "material":
      "matte", "albedo": 0.6}, {"azimuth_deg": 98, "elevation_deg": -8, "distance_m": 20, "radius_m": 2,
      "material": "chrome"}]}, "media": [{"name": "air", "scattering_per_km": 0.02, "density":
      {"profile": "exponential", "scale_height_km": 8}, "phase": {"function": "rayleigh"}}], "sun": )" +
                           sun +
                           R"(, "camera": {"altitude_km": 0.02, "azimuth_deg": 90, "vertical_fov_deg": 50},
      "image": {"width": 20, "height": 12}, "bloom": {"enabled": false}, "render": )" +
                           render + "}");
    const std::string map = scene.ground->albedo_map;
    put_sea(scene);
    scene.ground->albedo_map = map;
    return render_now(scene).radiance;
  };
  const std::string sun = R"({"elevation_deg": 30, "azimuth_deg": 200, "disc": {"visible": false})";
  const RadianceImage three = made(std::to_string(kSeaAlbedo), sun + "}", R"({"method": "orders"})");
  const RadianceImage curves = made(R"({"wavelengths_nm": [400, 700], "values": [)" + std::to_string(kSeaAlbedo) +
                                        ", " + std::to_string(kSeaAlbedo) + "]}",
                                    sun + "}", R"({"method": "orders", "wavelengths": 6})");
  for (int k = 0; k < 20 * 12; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double truth = channel_of(three, k % 20, k / 20, c);
      EXPECT_NEAR(channel_of(curves, k % 20, k / 20, c), truth, 1e-4 * truth) << k % 20 << ", " << k / 20;
    }
  }
}

// Mean error of orders against paths over directions that meet each thing, a mirror among them. path-trace's shadows
// have no penumbra, and mountains and balls light one another there.
TEST(Things, AgreeWithPathTrace) {
  Scene scene = shore(kAll);
  scene.ground->ocean.reset();
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters.find("samples")->second = 1024;
  Physics p = formulas_with_things(scene);
  std::vector<Direction> directions;
  std::array<int, 4> met{};
  for (const Direction& direction : lattice(scene)) {
    const vec3 view = p.direction_from_angles(direction.elevation, direction.azimuth);
    const auto hit = p.nearest_thing(p.scene.planet, p.sight_of(view), physics::kNoBody);
    if (++met[hit.what] <= 8) {
      directions.push_back(direction);
    }
  }
  ASSERT_EQ(directions.size(), 32u);
  const HostPicture truth = airlight::traced(traced, View{directions});
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  double sum = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[1]);
    sum += std::abs(found[i].radiance[1] / want - 1.0) / static_cast<double>(directions.size());
  }
  EXPECT_LT(sum, 0.065);
  std::printf("orders among things: %.4f from path-trace\n", sum);
}

}  // namespace
}  // namespace airlight::test
