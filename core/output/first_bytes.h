#pragma once
// Files told apart by their first bytes.

#include <array>
#include <istream>

namespace airlight {

constexpr std::array<char, 4> kExrMagic = {'\x76', '\x2f', '\x31', '\x01'};
constexpr std::array<char, 4> kPngMagic = {'\x89', 'P', 'N', 'G'};

// Leaves the stream at its start.
inline bool starts_with(std::istream& in, const std::array<char, 4>& magic) {
  std::array<char, 4> found{};
  const bool same = in.read(found.data(), found.size()) && found == magic;
  in.clear();
  in.seekg(0);
  return same;
}

}  // namespace airlight
