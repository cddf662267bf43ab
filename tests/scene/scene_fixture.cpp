#include "tests/scene/scene_fixture.h"

#include <unistd.h>

#include <fstream>
#include <limits>

#include "core/base/error.h"

namespace airlight::test {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr std::array<std::string_view, 2> kColors = {"warm", "cold"};

const std::array<ParameterInfo, 6> kMarchParameters{{
    {"steps", ParameterKind::integer, 1, 4096, 32, {}, "view steps"},
    {"transmittance_lut", ParameterKind::table_size, 2, 4096, TableSize{256, 64}, {}, "table"},
    {"multiple_scattering_lut", ParameterKind::table_size, 2, 4096, TableSize{32, 32}, {}, "table"},
    {"multiple_scattering_scale", ParameterKind::number, 0, kNoLimit, 1.0, {}, "1: physics"},
    {"sun_fade", ParameterKind::sun_fade, -kNoLimit, kNoLimit, std::monostate{}, {}, "fade"},
    {"color", ParameterKind::choice, 0, 0, std::string("cold"), kColors, "a choice"},
}};
const std::array<ParameterInfo, 2> kStillParameters{{
    {"steps", ParameterKind::integer, 1, 64, 16, {}, "view steps"},
    {"smooth", ParameterKind::boolean, 0, 0, false, {}, "a switch"},
}};
const std::array<MethodInfo, 2> kMethods{{{"orders", "sums", kMarchParameters}, {"still", "waits", kStillParameters}}};

void expect_same_media(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.media.size(), b.media.size());
  for (std::size_t i = 0; i < a.media.size(); ++i) {
    const Medium& m = a.media[i];
    const Medium& n = b.media[i];
    EXPECT_EQ(m.name, n.name);
    EXPECT_EQ(m.scattering, n.scattering);
    EXPECT_EQ(m.absorption, n.absorption);
    EXPECT_EQ(m.density.profile, n.density.profile);
    EXPECT_EQ(m.density.scale_height, n.density.scale_height);
    EXPECT_EQ(m.density.center, n.density.center);
    EXPECT_EQ(m.density.half_width, n.density.half_width);
    EXPECT_EQ(m.density.below, n.density.below);
    EXPECT_EQ(m.phase, n.phase);
    EXPECT_EQ(m.phase_g, n.phase_g);
    ASSERT_EQ(m.density.layers.size(), n.density.layers.size());
    for (std::size_t j = 0; j < m.density.layers.size(); ++j) {
      EXPECT_EQ(m.density.layers[j].altitude, n.density.layers[j].altitude);
      EXPECT_EQ(m.density.layers[j].density, n.density.layers[j].density);
    }
  }
}

}  // namespace

std::span<const MethodInfo> local_methods() {
  return kMethods;
}

std::string with_one_medium(std::string_view extra) {
  std::string text =
      R"({"airlight": 1, "media": [{"name": "air", "density": {"profile": "exponential", "scale_height_km": 8}}])";
  if (!extra.empty()) {
    text += ", ";
  }
  return text + std::string(extra) + "}";
}

Scene scene_from(std::string_view text) {
  return resolve(parse_preset(text, "test", {}), local_methods());
}

std::string problems_of(std::string_view text) {
  try {
    scene_from(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string problems_of_file(const std::filesystem::path& file) {
  try {
    resolve(load_preset(file), local_methods());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

void expect_same_terrain(const std::optional<Terrain>& a, const std::optional<Terrain>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) {
    return;
  }
  ASSERT_EQ(a->ridge.has_value(), b->ridge.has_value());
  EXPECT_EQ(a->ridge.value_or(Ridge{}).seed, b->ridge.value_or(Ridge{}).seed);
  EXPECT_EQ(a->ridge.value_or(Ridge{}).height, b->ridge.value_or(Ridge{}).height);
  EXPECT_EQ(a->height_map, b->height_map);
  EXPECT_EQ(a->albedo_map, b->albedo_map);
  EXPECT_EQ(a->width, b->width);
  EXPECT_EQ(a->lowest, b->lowest);
  EXPECT_EQ(a->highest, b->highest);
  EXPECT_EQ(a->bearing, b->bearing);
  EXPECT_EQ(a->distance, b->distance);
  EXPECT_EQ(a->turn, b->turn);
  EXPECT_EQ(a->albedo, b->albedo);
}

void expect_same(const Scene& a, const Scene& b) {
  expect_same_terrain(a.terrain, b.terrain);
  EXPECT_EQ(a.spheres, b.spheres);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.planet.ground_radius, b.planet.ground_radius);
  EXPECT_EQ(a.planet.atmosphere_height, b.planet.atmosphere_height);
  EXPECT_EQ(a.planet.ground_albedo, b.planet.ground_albedo);
  expect_same_media(a, b);
  EXPECT_EQ(a.sun.elevation, b.sun.elevation);
  EXPECT_EQ(a.sun.azimuth, b.sun.azimuth);
  EXPECT_EQ(a.sun.irradiance, b.sun.irradiance);
  EXPECT_EQ(a.moon, b.moon);
  EXPECT_EQ(a.night_sky, b.night_sky);
  EXPECT_EQ(a.stars, b.stars);
  EXPECT_EQ(a.camera.julian_date, b.camera.julian_date);
  EXPECT_EQ(a.sun.unit, b.sun.unit);
  EXPECT_EQ(a.sun.disc.visible, b.sun.disc.visible);
  EXPECT_EQ(a.sun.disc.angular_radius, b.sun.disc.angular_radius);
  EXPECT_EQ(a.sun.disc.limb_darkening, b.sun.disc.limb_darkening);
  EXPECT_EQ(a.sun.disc.radiance_scale, b.sun.disc.radiance_scale);
  EXPECT_EQ(a.camera.altitude, b.camera.altitude);
  EXPECT_EQ(a.camera.azimuth, b.camera.azimuth);
  EXPECT_EQ(a.camera.pitch, b.camera.pitch);
  EXPECT_EQ(a.camera.roll, b.camera.roll);
  EXPECT_EQ(a.camera.projection, b.camera.projection);
  EXPECT_EQ(a.camera.cube_layout, b.camera.cube_layout);
  EXPECT_EQ(a.bloom.enabled, b.bloom.enabled);
  EXPECT_EQ(a.camera.vertical_fov, b.camera.vertical_fov);
  EXPECT_EQ(a.image.width, b.image.width);
  EXPECT_EQ(a.image.height, b.image.height);
  EXPECT_EQ(a.render.method, b.render.method);
  EXPECT_TRUE(a.render.parameters == b.render.parameters);
  EXPECT_EQ(a.bloom.enabled, b.bloom.enabled);
  EXPECT_EQ(a.bloom.in_exr, b.bloom.in_exr);
  EXPECT_EQ(a.bloom.model, b.bloom.model);
  EXPECT_EQ(a.bloom.threshold, b.bloom.threshold);
  EXPECT_EQ(a.bloom.intensity, b.bloom.intensity);
  EXPECT_EQ(a.bloom.levels, b.bloom.levels);
  EXPECT_EQ(a.display.exposure, b.display.exposure);
  EXPECT_EQ(a.display.metering, b.display.metering);
  EXPECT_EQ(a.display.metered_frame, b.display.metered_frame);
  EXPECT_EQ(a.display.compensation, b.display.compensation);
  EXPECT_EQ(a.display.display, b.display.display);
  EXPECT_EQ(a.display.view, b.display.view);
  EXPECT_EQ(a.display.tonemap, b.display.tonemap);
}

FolderTest::FolderTest() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = std::filesystem::temp_directory_path() /
            ("airlight-scene-" + std::string(info->name()) + "-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder_);
}

FolderTest::~FolderTest() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path FolderTest::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path file = folder_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace airlight::test
