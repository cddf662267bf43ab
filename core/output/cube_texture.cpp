// Cube maps as engines load them: KTX 2.0 and DDS with the DX10 header, RGBA in half floats, alpha 1, all mips.
//
// Both look a direction (x, y, z) up alike (OpenGL 4.6 table 8.19, Direct3D): face +X has x > 0, its columns run toward
// -z and its rows toward -y, and so on. Here x is east, y up and z south where the camera looks north; another azimuth
// turns the map with it. A picture's stack of faces has the same cube by OpenEXR's axes, +Z to the camera's azimuth
// and +X to the left (shaders/physics/environment.glsl), so faces are exchanged and turned, and no pixel is resampled.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/output/cube_faces.h"
#include "core/output/half_block.h"
#include "core/output/picture_rows.h"
#include "core/output/prefilter.h"

namespace airlight {
namespace {

// The direction of a point of OpenEXR's face, in x to the right of the camera's azimuth, y up, z back. u from the left,
// v from the top, -1 to 1.
CubeDirection direction_in_stack(std::size_t face, double u, double v) {
  switch (face) {
    case 0:
      return {-1.0, -v, -u};
    case 1:
      return {1.0, -v, u};
    case 2:
      return {-u, 1.0, v};
    case 3:
      return {-u, -1.0, -v};
    case 4:
      return {u, -v, -1.0};
    default:
      return {-u, -v, 1.0};
  }
}

CubeFaces texture_faces(const std::vector<float>& stack, std::size_t side) {
  CubeFaces faces;
  faces.fill(std::vector<float>(4 * side * side, 1.0F));
  const auto centre = [&](std::size_t i) {
    return 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(side) - 1.0;
  };
  for (std::size_t i = 0; i < kCubeFaces * side * side; ++i) {
    const std::size_t row = i / side;
    const CubePoint at = cube_point(direction_in_stack(row / side, centre(i % side), centre(row % side)));
    float* const to = &faces[at.face][4 * (cube_index(at.v, side) * side + cube_index(at.u, side))];
    std::copy_n(&stack[4 * i], 3, to);
  }
  return faces;
}

struct Bytes {
  std::vector<std::byte> bytes;

  template <class Number>
  void add(Number number) {
    const auto raw = std::bit_cast<std::array<std::byte, sizeof number>>(number);  // little endian
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }
  void add_words(std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) {
      add(word);
    }
  }
};

using Level = std::array<std::vector<std::uint16_t>, kCubeFaces>;

// In half floats. Counted are the samples of the first one that those do not hold.
std::vector<Level> levels_of(const CubeChain& chain, ExrCounts& counts) {
  std::vector<Level> levels;
  for (const CubeFaces& faces : chain) {
    Level& level = levels.emplace_back();
    for (std::size_t f = 0; f < kCubeFaces; ++f) {
      level[f].resize(faces[f].size());
      ExrCounts found;
      convert_to_half(faces[f].data(), 1, faces[f].size(), level[f].data(), found);
      if (levels.size() == 1) {
        add_counts(counts, found);
      }
    }
  }
  return levels;
}

// Khronos's basic data format descriptor of R, G, B and A as signed 16-bit floats, linear, BT.709.
void add_descriptor(Bytes& out) {
  constexpr std::uint32_t kBlock = 24 + 16 * 4;
  out.add_words({4 + kBlock, 0, 2U | kBlock << 16U, 1U | 1U << 8U | 1U << 16U, 0, 8, 0});
  for (std::uint32_t channel = 0; channel < 4; ++channel) {
    const std::uint32_t id = channel == 3 ? 15 : channel;
    out.add_words({16 * channel | 15U << 16U | (id | 0xC0U) << 24U, 0, 0xBF800000U, 0x3F800000U});
  }
}

std::vector<std::byte> ktx2_of(const std::vector<Level>& levels, std::size_t side) {
  constexpr std::array<std::uint8_t, 12> kMagic{0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
  constexpr std::uint32_t kRgba16Float = 97;  // VK_FORMAT_R16G16B16A16_SFLOAT
  const std::string orientation = std::string("KTXorientation") + '\0' + "rd" + '\0';
  const auto count = static_cast<std::uint32_t>(levels.size());
  Bytes descriptor;
  add_descriptor(descriptor);
  const std::uint32_t index = 80;
  const std::uint32_t described = index + 24 * count;
  const auto values = described + static_cast<std::uint32_t>(descriptor.bytes.size());
  const auto key_bytes = static_cast<std::uint32_t>(4 + (orientation.size() + 3) / 4 * 4);
  std::uint64_t place = (values + key_bytes + 7) / 8 * 8;

  Bytes out;
  for (const std::uint8_t byte : kMagic) {
    out.add(byte);
  }
  const auto pixels = static_cast<std::uint32_t>(side);
  out.add_words({kRgba16Float, 2, pixels, pixels, 0, 0, 6, count, 0});
  out.add_words({described, static_cast<std::uint32_t>(descriptor.bytes.size()), values, key_bytes, 0, 0, 0, 0});
  // The smallest level stands first in the file, and last in the index.
  std::vector<std::array<std::uint64_t, 2>> places(levels.size());
  for (std::size_t i = levels.size(); i-- > 0;) {
    places[i] = {place, kCubeFaces * 2 * levels[i][0].size()};
    place += places[i][1];
  }
  for (const auto& [offset, length] : places) {
    out.add(offset);
    out.add(length);
    out.add(length);
  }
  out.bytes.insert(out.bytes.end(), descriptor.bytes.begin(), descriptor.bytes.end());
  out.add(static_cast<std::uint32_t>(orientation.size()));
  for (const char c : orientation) {
    out.add(c);
  }
  out.bytes.resize(places.back()[0]);
  for (std::size_t i = levels.size(); i-- > 0;) {
    for (const std::vector<std::uint16_t>& face : levels[i]) {
      const auto raw = std::as_bytes(std::span(face));
      out.bytes.insert(out.bytes.end(), raw.begin(), raw.end());
    }
  }
  return std::move(out.bytes);
}

std::vector<std::byte> dds_of(const std::vector<Level>& levels, std::size_t side) {
  const auto pixels = static_cast<std::uint32_t>(side);
  Bytes out;
  // Caps, height, width, pitch, pixel format and the count of mips are valid.
  out.add_words({0x20534444, 124, 0x1 | 0x2 | 0x4 | 0x8 | 0x1000 | 0x20000, pixels, pixels, 8 * pixels, 0,
                 static_cast<std::uint32_t>(levels.size())});
  out.add_words({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  out.add_words({32, 0x4, 0x30315844, 0, 0, 0, 0, 0});                // the pixel format is in the header "DX10"
  out.add_words({0x8 | 0x1000 | 0x400000, 0x200 | 0xFC00, 0, 0, 0});  // texture, complex, mips; a cube, all faces
  out.add_words({10, 3, 0x4, 1, 0});  // R16G16B16A16_FLOAT, two dimensions, a cube, one of it
  for (std::size_t face = 0; face < kCubeFaces; ++face) {
    for (const Level& level : levels) {
      const auto raw = std::as_bytes(std::span(level[face]));
      out.bytes.insert(out.bytes.end(), raw.begin(), raw.end());
    }
  }
  return std::move(out.bytes);
}

class CubeTextureRows : public PictureRows {
 public:
  CubeTextureRows(bool is_dds, bool prefilter, Sink sink, int side)
      : is_dds_(is_dds), prefilter_(prefilter), sink_(std::move(sink)), side_(static_cast<std::size_t>(side)) {}

  void add(const RadianceImage& rows) override { stack_.insert(stack_.end(), rows.rgba.begin(), rows.rgba.end()); }

  std::vector<std::string> finish() override {
    ExrCounts counts;
    const CubeFaces sharp = texture_faces(stack_, side_);
    const std::vector<Level> levels = levels_of(prefilter_ ? prefiltered(sharp, side_) : mips_of(sharp, side_), counts);
    sink_(is_dds_ ? dds_of(levels, side_) : ktx2_of(levels, side_));
    if (counts.clamped == 0) {
      return {};
    }
    return {std::to_string(counts.clamped) +
            " samples above 65504, the most that a half float holds, are stored as 65504; leave the sun's disc to a "
            "light of its own by --set /sun/disc/visible=false"};
  }

 private:
  bool is_dds_;
  bool prefilter_;
  Sink sink_;
  std::size_t side_;
  std::vector<float> stack_;
};

}  // namespace

std::unique_ptr<PictureRows> cube_texture_rows(bool is_dds, bool prefilter, PictureRows::Sink sink, int side) {
  return std::make_unique<CubeTextureRows>(is_dds, prefilter, std::move(sink), side);
}

}  // namespace airlight
