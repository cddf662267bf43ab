#pragma once
// Writes an OpenVDB file without OpenVDB, by its file format (openvdb/io/Archive.cc, GridDescriptor.cc, tree/*.h): one
// grid of floats of one leaf, 8 x 8 x 8 voxels, not compressed.

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace airlight::test {

struct VdbLeaf {
  std::string name = "density";
  std::string kind = "fog volume";  // the grid's class; empty: none
  std::string type = "Tree_float_5_4_3";
  double voxel = 25.0;                  // side, in the unit of the transform
  std::array<int, 3> count{4, 3, 5};    // of active voxels from the leaf's corner on, at most 8
  std::array<int, 3> origin{0, 40, 0};  // of the leaf, multiples of 8
  std::vector<float> values;            // of the active voxels: x fastest, then y, then z
};

class VdbBytes {
 public:
  explicit VdbBytes(const VdbLeaf& leaf) : leaf_(leaf) {}

  std::string write() {
    number(0x56444220, 8);
    number(224, 4);  // of the format
    number(10, 4);   // of the library
    number(0, 4);
    number(1, 1);                                      // with places of the grids
    bytes_ += "a0000000-0000-4000-8000-000000000000";  // that of zeros would be taken for no file
    number(0, 4);                                      // entries about the file
    number(1, 4);                                      // grids
    text(leaf_.name);
    text(leaf_.type);
    text("");
    const std::size_t places = bytes_.size();
    bytes_ += std::string(24, '\0');
    const std::size_t grid = bytes_.size();
    head();
    topology();
    const std::size_t blocks = bytes_.size();
    mask(512, active());
    values();
    put(places, grid);
    put(places + 8, blocks);
    put(places + 16, bytes_.size());
    return bytes_;
  }

 private:
  void number(std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) {
      bytes_ += static_cast<char>(value >> (8 * k) & 0xffU);
    }
  }
  void put(std::size_t at, std::uint64_t value) {
    for (std::size_t k = 0; k < 8; ++k) {
      bytes_[at + k] = static_cast<char>(value >> (8 * k) & 0xffU);
    }
  }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value), 8); }
  void small_real(float value) { number(std::bit_cast<std::uint32_t>(value), 4); }
  void text(std::string_view value) {
    number(value.size(), 4);
    bytes_ += value;
  }
  void mask(int bits, const std::vector<int>& on) {
    std::string all(static_cast<std::size_t>(bits / 8), '\0');
    for (const int bit : on) {
      all[static_cast<std::size_t>(bit / 8)] = static_cast<char>(all[static_cast<std::size_t>(bit / 8)] | 1 << bit % 8);
    }
    bytes_ += all;
  }

  void head() {
    number(2, 4);  // values of active voxels alone
    number(leaf_.kind.empty() ? 0 : 1, 4);
    if (!leaf_.kind.empty()) {
      text("class");
      text("string");
      text(leaf_.kind);
    }
    text("UniformScaleMap");
    const double s = leaf_.voxel;
    for (const double value : {s, s, 1.0 / s, 1.0 / (s * s), 0.5 / s}) {
      real(value);
      real(value);
      real(value);
    }
  }

  // A root, a node of 32 x 32 x 32 children, one of 16 x 16 x 16, a leaf.
  void topology() {
    number(1, 4);
    small_real(0.0F);
    number(0, 4);  // tiles
    number(1, 4);  // children
    const auto at = [&](std::size_t i) { return leaf_.origin.at(i); };
    const auto from = [](int x) { return x & ~4095; };
    for (std::size_t i = 0; i < 3; ++i) {
      number(static_cast<std::uint32_t>(from(at(i))), 4);
    }
    const auto child = [&](int shift, int bits) {
      const auto part = [&](std::size_t i) { return at(i) >> shift & ((1 << bits) - 1); };
      return part(0) << 2 * bits | part(1) << bits | part(2);
    };
    mask(32768, {child(7, 5)});
    mask(32768, {});
    number(0, 1);  // no value but the background's
    mask(4096, {child(3, 4)});
    mask(4096, {});
    number(0, 1);
    mask(512, active());
  }

  // Places in the leaf: z fastest.
  std::vector<int> active() const {
    std::vector<int> list;
    for (int x = 0; x < leaf_.count[0]; ++x) {
      for (int y = 0; y < leaf_.count[1]; ++y) {
        for (int z = 0; z < leaf_.count[2]; ++z) {
          list.push_back(x << 6 | y << 3 | z);
        }
      }
    }
    return list;
  }

  void values() {
    number(0, 1);
    for (const int place : active()) {
      const int x = place >> 6;
      const int y = place >> 3 & 7;
      const int z = place & 7;
      small_real(leaf_.values.at(static_cast<std::size_t>(x + leaf_.count[0] * (y + leaf_.count[1] * z))));
    }
  }

  VdbLeaf leaf_;
  std::string bytes_;
};

inline std::string vdb_file(const VdbLeaf& leaf) {
  return VdbBytes(leaf).write();
}

// The same with values between 0.1 and 0.9, no two alike.
inline VdbLeaf vdb_leaf() {
  VdbLeaf leaf;
  for (int i = 0; i < leaf.count[0] * leaf.count[1] * leaf.count[2]; ++i) {
    leaf.values.push_back(0.1F + 0.8F * static_cast<float>(i * 37 % 60) / 60.0F);
  }
  return leaf;
}

}  // namespace airlight::test
