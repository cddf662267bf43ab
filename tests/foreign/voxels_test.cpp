// Grids of OpenVDB's files: what is read, and what is refused before and after the library sees the file.

#include "core/foreign/voxels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/foreign/foreign_picture.h"
#include "core/foreign/vdb_head.h"
#include "tests/output/files.h"
#include "tests/vdb_file.h"

namespace airlight::foreign {
namespace {

constexpr std::size_t kMost = 1U << 20U;

class VoxelFiles : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    test::put(folder_ / name, bytes);
    return (folder_ / name).string();
  }
  std::string put(const test::VdbLeaf& leaf) const { return put("leaf.vdb", vdb_file(leaf)); }
  static std::string refusal(const std::string& file, const std::string& grid = "density", std::size_t most = kMost) {
    return test::message_of<InputError>([&] { read_voxels(file, grid, most); });
  }
  test::Folder folder_;
};

TEST_F(VoxelFiles, AreReadWithTheirTransform) {
  const test::VdbLeaf leaf = test::vdb_leaf();
  const Voxels voxels = read_voxels(put(leaf), "density", kMost);
  EXPECT_EQ(voxels.count, (std::array<std::int32_t, 3>{4, 3, 5}));
  EXPECT_EQ(voxels.size, (std::array<double, 3>{25.0, 25.0, 25.0}));
  EXPECT_EQ(voxels.corner, (std::array<double, 3>{-12.5, 987.5, -12.5}));
  EXPECT_EQ(voxels.values, leaf.values);
}

// OpenImageIO starts threads of its own for large pictures; the process that reads voxels has none of them.
TEST_F(VoxelFiles, AreReadAfterAPicture) {
  std::string picture = "P6 2048 2048 255\n";
  picture.append(std::size_t{2048} * 2048 * 3, 'x');
  EXPECT_EQ(read_picture(put("large.ppm", picture)).width, 2048);
  EXPECT_EQ(read_voxels(put(test::vdb_leaf()), "density", kMost).values.size(), 60U);
}

TEST_F(VoxelFiles, OfOtherKindsAreRefused) {
  test::VdbLeaf leaf = test::vdb_leaf();
  leaf.kind = "";
  EXPECT_EQ(read_voxels(put(leaf), "density", kMost).values, leaf.values);
  leaf.kind = "level set";
  std::string file = put(leaf);
  EXPECT_EQ(refusal(file), file + ": the grid is a level set, no fog volume; choose another or convert it");
  leaf.type = "Tree_vec3s_5_4_3";
  file = put(leaf);
  EXPECT_EQ(refusal(file),
            file + ": the grid \"density\" holds no floating-point numbers, so it is no fog volume; choose another");
  EXPECT_EQ(refusal(file, "dens"), file + ": has no grid \"dens\"; it has \"density\"");
  file = put("text.vdb", "3 2 2\n0.02 0.02\n0.4 0.5\n");
  EXPECT_EQ(refusal(file),
            file + ": is no OpenVDB file; expected one, or for a grid as plain text a name that does not end in .vdb");
  EXPECT_EQ(
      refusal((folder_ / "none.vdb").string()),
      (folder_ / "none.vdb").string() + ": cannot be read: No such file or directory; expected a file of OpenVDB");
}

TEST_F(VoxelFiles, AreBoundedBeforeTheyAreRead) {
  const std::string file = put(test::vdb_leaf());
  EXPECT_EQ(read_voxels(file, "density", 60).values.size(), 60U);
  EXPECT_EQ(refusal(file, "density", 59), file +
                                              ": the grid has 4 x 3 x 5 voxels in its box; expected at most 59: "
                                              "resample it with larger voxels");
}

// The library would give zeros for what is missing.
TEST_F(VoxelFiles, ThatAreCutShortAreRefused) {
  const std::string whole = vdb_file(test::vdb_leaf());
  for (std::size_t length = 0; length < whole.size(); length += length < 300 ? 7 : 211) {
    const std::string file = put("cut.vdb", whole.substr(0, length));
    const std::string message = refusal(file);
    EXPECT_TRUE(
        message == file + ": damaged or cut short: its grids go on beyond its end" ||
        message ==
            file + ": is no OpenVDB file; expected one, or for a grid as plain text a name that does not end in .vdb")
        << length << ": " << message;
  }
}

// Whatever the bytes are, the library's process alone may end by them.
TEST_F(VoxelFiles, DamagedAreVoxelsOrOneLine) {
  const std::string whole = vdb_file(test::vdb_leaf());
  const std::size_t head = 200;  // names, places, counts
  int refused = 0;
  for (std::size_t at = 8; at < whole.size(); at += at < head + 200 ? 5 : 701) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (at % 2 == 0 ? 0xff : 0x41));
    const std::string file = put("damaged.vdb", bytes);
    try {
      const Voxels voxels = read_voxels(file, "density", kMost);
      const auto [nx, ny, nz] = voxels.count;
      EXPECT_EQ(voxels.values.size(), static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny * nz)) << at;
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << at;
      EXPECT_TRUE(std::string(error.what()).starts_with(file + ": ")) << error.what();
    }
  }
  EXPECT_GT(refused, 20);
}

TEST_F(VoxelFiles, HeadsNameTheirGrids) {
  test::VdbLeaf leaf = test::vdb_leaf();
  leaf.name =
      "smoke\x1e"
      "1";
  const std::vector<VdbGrid> grids = vdb_grids(put(leaf));
  ASSERT_EQ(grids.size(), 1U);
  EXPECT_EQ(grids[0].name, "smoke");
  EXPECT_TRUE(grids[0].real);
}

}  // namespace
}  // namespace airlight::foreign
