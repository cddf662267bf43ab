// Values kept on disk: read back bit for bit, made anew where they are not as they were written.

#include "core/gpu/kept_values.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/clouds/cloud_grid.h"
#include "core/spectra/drops.h"
#include "core/things/terrain.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::uint32_t>;

// Runs of all lengths beside one another, and words that differ.
Words uneven_words(std::size_t count) {
  Words words;
  for (std::uint32_t i = 0; words.size() < count; ++i) {
    const std::uint32_t mixed = (i * 2654435761U) >> 7U;
    words.insert(words.end(), 1 + mixed % 6, mixed % 5);
  }
  return words;
}

class KeptValues : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "airlight-values-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
    keep_values_in(root_);
  }
  void TearDown() override {
    keep_values_in({});
    fs::remove_all(root_);
  }

  // What is kept under the key, and whether it had to be made.
  std::pair<Words, bool> asked(const std::string& key, const Words& value) {
    bool made = false;
    Words words = kept_words(key, [&] {
      made = true;
      return value;
    });
    return {std::move(words), made};
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> files;
    if (!fs::exists(root_ / "values")) return files;
    for (const auto& entry : fs::directory_iterator(root_ / "values")) files.push_back(entry.path());
    return files;
  }

  fs::path root_;
};

TEST_F(KeptValues, PackedWordsComeBack) {
  for (std::size_t count = 0; count < 300; ++count) {
    const Words words = uneven_words(count);
    EXPECT_EQ(unpacked(packed(words)), words) << count << " words";
  }
  const Words even(100000, 7);
  EXPECT_EQ(packed(even).size(), 2U);
  EXPECT_EQ(unpacked(packed(even)), even);
  Words rising(1000);
  for (std::uint32_t i = 0; i < rising.size(); ++i) rising[i] = i;
  EXPECT_EQ(packed(rising).size(), 1001U) << "words that all differ cost one more";
}

// No list of words reads outside itself or asks for endless memory.
TEST_F(KeptValues, WordsThatAreNotPackedGiveNone) {
  EXPECT_TRUE(unpacked(Words{5, 1, 2}).empty()) << "cut short";
  EXPECT_TRUE(unpacked(Words{0x80000004U}).empty()) << "a run of nothing";
  EXPECT_TRUE(unpacked(Words{0}).empty()) << "no words";
  EXPECT_TRUE(unpacked(Words{0xffffffffU, 1, 0xffffffffU, 1}).empty()) << "16 GiB";
  EXPECT_TRUE(unpacked(Words{2, 1, 2, 0}).empty()) << "an empty part at the end";
}

TEST_F(KeptValues, AreMadeOnceForEachKey) {
  const Words words = uneven_words(5000);
  EXPECT_EQ(asked("a", words), std::pair(words, true));
  EXPECT_EQ(asked("a", {}), std::pair(words, false));
  EXPECT_EQ(asked("b", {1, 2, 3}), std::pair(Words({1, 2, 3}), true));
  EXPECT_EQ(files().size(), 2U);
  const std::vector<float> floats{0.0F, -0.0F, 1e-40F, std::numeric_limits<float>::infinity()};
  kept_floats("floats", [&] { return floats; });
  const std::vector<float> again = kept_floats("floats", [] { return std::vector<float>(); });
  ASSERT_EQ(again, floats);
  EXPECT_TRUE(std::signbit(again[1]));
}

TEST_F(KeptValues, NothingIsKeptWithoutAFolder) {
  keep_values_in({});
  EXPECT_TRUE(asked("a", {1, 2, 3}).second);
  EXPECT_TRUE(asked("a", {1, 2, 3}).second);
  EXPECT_TRUE(files().empty());
}

TEST_F(KeptValues, AFileThatWasChangedIsMadeAnew) {
  const Words words = uneven_words(500);
  asked("a", words);
  ASSERT_EQ(files().size(), 1U);
  std::fstream file(files()[0], std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(200);
  file.put('x');
  file.close();
  EXPECT_EQ(asked("a", words), std::pair(words, true));
  EXPECT_EQ(asked("a", words), std::pair(words, false));
  fs::resize_file(files()[0], 90);
  EXPECT_EQ(asked("a", words), std::pair(words, true));
}

// All of a field and of its drops, of each kind: made now, as it is written and as it is read back.
TEST_F(KeptValues, RidgesAreKeptBySeedAndHeight) {
  const auto one = ridge_heights_of({.seed = 7, .height = 1.6});
  EXPECT_EQ(*ridge_heights_of({.seed = 7, .height = 1.6}), *one);
  EXPECT_EQ(files().size(), 1U);
  EXPECT_FLOAT_EQ(*std::ranges::max_element(*one), 1.6F);
  EXPECT_NE(*ridge_heights_of({.seed = 8, .height = 1.6}), *one);
  EXPECT_FLOAT_EQ(*std::ranges::max_element(*ridge_heights_of({.seed = 7, .height = 0.8})), 0.8F);
  EXPECT_EQ(files().size(), 3U);
}

TEST_F(KeptValues, FieldsOfCloudsReadBackAreTheSame) {
  using Make = CloudGrid (*)(const Cloud&);
  for (const auto& [kind, make] : {std::pair<CloudKind, Make>(CloudKind::cumulus, cumulus_grid),
                                   std::pair<CloudKind, Make>(CloudKind::stratocumulus, stratocumulus_grid),
                                   std::pair<CloudKind, Make>(CloudKind::cirrus, cirrus_grid)}) {
    Cloud cloud;
    cloud.kind = kind;
    cloud.cover = 0.4;
    cloud.base = 1.0;
    cloud.top = 2.0;
    cloud.cell = 1.5;
    cloud.detail = 0.1;
    cloud.period = 4.0;
    cloud.water = 0.3;
    cloud.effective_radius = 8.0;
    const std::string name = "kind " + std::to_string(static_cast<int>(kind));
    const CloudGrid made = make(cloud);
    EXPECT_GT(*std::ranges::max_element(made.extinction), 0.0F) << name;
    for (int start = 0; start < 2; ++start) {
      const CloudGrid read = cloud_grid(cloud);
      EXPECT_EQ(read.extinction, made.extinction) << name;
      EXPECT_EQ(read.inside, made.inside) << name;
      EXPECT_EQ(read.noise != nullptr, made.noise != nullptr) << name;
      EXPECT_EQ(std::tuple(read.nx, read.ny, read.nz, read.cell_x, read.cell_y, read.base, read.top, read.repeats),
                std::tuple(made.nx, made.ny, made.nz, made.cell_x, made.cell_y, made.base, made.top, made.repeats));
      EXPECT_EQ(read.smooth, made.smooth);
      for (const double h : {1.05, 1.5, 1.9}) {
        for (const double part : {0.1, 0.4, 0.6, 0.9}) {
          EXPECT_EQ(read.at(read.west + 4.0 * part, read.south + 1.3, h),
                    made.at(made.west + 4.0 * part, made.south + 1.3, h))
              << name;
        }
      }
      EXPECT_TRUE(cloud_medium(cloud, {}).phase_table == drops_phase(cloud.effective_radius)) << name;
    }
  }
  EXPECT_EQ(files().size(), 5U) << "three fields, the noise of edges, drops";
}

}  // namespace
}  // namespace airlight
