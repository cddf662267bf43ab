// Voxels as clouds: axes, sizes, places, and what is refused.

#include "core/library/cloud_voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/scene/resolve.h"

namespace airlight {
namespace {

Scene scene_with_cloud(const std::string& keys = "") {
  const Preset preset =
      parse_preset(R"({"airlight": 1, "media": [{"name": "air", "scattering_per_km": 0.01, "density": {"profile":
          "constant", "below_km": 9}}], "clouds": [{"type": "volume", "file": "/none/heap.vdb")" +
                       keys + "}]}",
                   "test", "/");
  return resolve(preset, method_infos());
}

// 2 x 3 x 4 voxels of 10, 20 and 30 m from (-5, 100, 7) on; the value of (x, y, z) is x + 10 y + 100 z.
foreign::Voxels voxels_of_file() {
  foreign::Voxels voxels{.count = {2, 3, 4}, .size = {10.0, 20.0, 30.0}, .corner = {-5.0, 100.0, 7.0}, .values = {}};
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 2; ++x) {
        voxels.values.push_back(static_cast<float>(x + 10 * y + 100 * z));
      }
    }
  }
  return voxels;
}

Cloud filled(const std::string& keys, const foreign::Voxels& voxels = voxels_of_file()) {
  Scene scene = scene_with_cloud(keys);
  fill_voxels([&](const std::string&, const std::string&, std::size_t) { return voxels; }, scene, nullptr);
  return scene.clouds.front();
}

std::string refusal(const std::string& keys, const foreign::Voxels& voxels = voxels_of_file()) {
  try {
    filled(keys, voxels);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(CloudVoxelsTest, WithYUpTheFilesZPointsSouth) {
  const Cloud cloud = filled(R"(, "extinction_per_km": 2)");
  const CloudFile& file = *cloud.contents;
  EXPECT_EQ(file.nx, 2);
  EXPECT_EQ(file.ny, 4);
  EXPECT_EQ(file.nz, 3);
  EXPECT_DOUBLE_EQ(file.dx, 0.01);
  EXPECT_DOUBLE_EQ(file.dy, 0.03);
  EXPECT_DOUBLE_EQ(file.dz, 0.02);
  EXPECT_DOUBLE_EQ(cloud.base, 0.1);
  EXPECT_DOUBLE_EQ(cloud.top, 0.16);
  // One step east, none north (the file's highest z), two up.
  EXPECT_EQ(file.extinction.at(1 + 2 * (0 + 4 * 2)), 2.0F * (1 + 20 + 300));
  EXPECT_EQ(file.extinction.at(0 + 2 * (3 + 4 * 0)), 0.0F);
}

TEST(CloudVoxelsTest, WithZUpTheFilesYPointsNorth) {
  const Cloud cloud = filled(R"(, "up": "z", "base_km": 2, "metres_per_unit": 10)");
  const CloudFile& file = *cloud.contents;
  EXPECT_EQ(file.ny, 3);
  EXPECT_EQ(file.nz, 4);
  EXPECT_DOUBLE_EQ(file.dz, 0.3);
  EXPECT_DOUBLE_EQ(cloud.base, 2.0);
  EXPECT_DOUBLE_EQ(cloud.top, 3.2);
  EXPECT_EQ(file.extinction.at(1 + 2 * (2 + 3 * 3)), 50.0F * (1 + 20 + 300));
}

TEST(CloudVoxelsTest, BadValuesAreRefusedWithTheirPlace) {
  const std::string start = "/clouds/0/file: /none/heap.vdb: ";
  foreign::Voxels bad = voxels_of_file();
  bad.values[1 + 2 * (2 + 3 * 3)] = -1.0F;
  EXPECT_EQ(refusal("", bad),
            start + "holds the value -1 at voxel 1, 2, 3 of its box; expected finite densities of at least 0");
  bad.values[1 + 2 * (2 + 3 * 3)] = NAN;
  EXPECT_NE(refusal("", bad).find("holds the value nan at voxel 1, 2, 3"), std::string::npos) << refusal("", bad);
  bad.values.assign(bad.values.size(), 0.0F);
  EXPECT_EQ(refusal("", bad), start + "holds no value above 0; expected a density");
  EXPECT_EQ(refusal(R"(, "extinction_per_km": 1000)"),
            start +
                "its highest value, 321, times extinction_per_km, 1000, is above 100000 per km; make "
                "extinction_per_km smaller");
}

TEST(CloudVoxelsTest, CloudsOutsideTheAirAreRefused) {
  foreign::Voxels low = voxels_of_file();
  low.corner[1] = -10.0;
  const std::string start = "/clouds/0/file: /none/heap.vdb: ";
  EXPECT_EQ(refusal("", low),
            start +
                "the cloud reaches from -0.01 to 0.05 km; expected within the air, 0 to planet.atmosphere_height_km, "
                "100: set base_km, or metres_per_unit");
  EXPECT_EQ(refusal(R"(, "base_km": 0)", low), "");
  EXPECT_EQ(refusal(R"(, "metres_per_unit": 1e-3)"),
            start + "its voxels are 1e-05 km a side; expected 0.0001 to 100 km: set metres_per_unit");
}

TEST(CloudVoxelsTest, ContentsAreTakenOverWhereNothingChanged) {
  Scene first = scene_with_cloud();
  int reads = 0;
  const VoxelsReader read = [&](const std::string&, const std::string&, std::size_t) {
    ++reads;
    return voxels_of_file();
  };
  fill_voxels(read, first, nullptr);
  Scene moved = scene_with_cloud(R"(, "base_km": 3, "east_km": 1)");
  fill_voxels(read, moved, &first);
  EXPECT_EQ(reads, 1);
  EXPECT_EQ(moved.clouds.front().contents, first.clouds.front().contents);
  EXPECT_DOUBLE_EQ(moved.clouds.front().base, 3.0);
  Scene thicker = scene_with_cloud(R"(, "extinction_per_km": 3)");
  fill_voxels(read, thicker, &first);
  EXPECT_EQ(reads, 2);
}

}  // namespace
}  // namespace airlight
