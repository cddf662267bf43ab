#include "core/output/picture_rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

namespace airlight {
namespace {

constexpr std::array<std::string_view, 5> kRowFormats{".hdr", ".npy", ".json", ".ktx2", ".dds"};

std::string ending_of(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

using Rgbe = std::array<std::uint8_t, 4>;

// Ward's shared exponent [Ward, Real Pixels, Graphics Gems II]. Mantissas are rounded to nearest: OpenImageIO and
// engines take them as they stand (Radiance itself reads half a step more). Negative values become 0; those below
// 2^-136 too.
Rgbe rgbe_of(const float* rgb) {
  const float most = std::max({rgb[0], rgb[1], rgb[2]});
  int exponent = 0;
  const float fraction = std::frexp(most, &exponent);
  exponent += fraction * 256.0F >= 255.5F ? 1 : 0;  // would round to 256
  if (!(most > 0.0F) || exponent < -127) {
    return {};
  }
  Rgbe out{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::lround(std::ldexp(std::max(rgb[c], 0.0F), 8 - exponent)));
  }
  return out;
}

// A row's bytes of one kind: runs of 3 to 127 equal ones as 128 + length and the byte, others as length and the bytes.
void add_runs(std::vector<std::byte>& out, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kShortest = 4;
  constexpr std::size_t kLongestRun = 127;
  constexpr std::size_t kLongestDump = 128;
  const auto run_at = [&](std::size_t i) {
    std::size_t n = 1;
    while (i + n < bytes.size() && n < kLongestRun && bytes[i + n] == bytes[i]) {
      ++n;
    }
    return n;
  };
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t run = run_at(i);
    if (run >= kShortest) {
      out.push_back(static_cast<std::byte>(128 + run));
      out.push_back(static_cast<std::byte>(bytes[i]));
      i += run;
      continue;
    }
    std::size_t end = i;
    while (end < bytes.size() && end - i < kLongestDump && run_at(end) < kShortest) {
      ++end;
    }
    out.push_back(static_cast<std::byte>(end - i));
    for (; i < end; ++i) {
      out.push_back(static_cast<std::byte>(bytes[i]));
    }
  }
}

std::vector<std::byte> bytes_of_text(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

class HdrRows : public PictureRows {
 public:
  HdrRows(Sink sink, int width, int height) : sink_(std::move(sink)), width_(static_cast<std::size_t>(width)) {
    sink_(bytes_of_text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                        std::to_string(width) + "\n"));
  }

  void add(const RadianceImage& rows) override {
    std::vector<std::byte> out;
    for (int y = 0; y < rows.height; ++y) {
      add_row(out, rows.at(0, y));
    }
    sink_(out);
  }

  std::vector<std::string> finish() override {
    if (negative_ == 0) {
      return {};
    }
    return {std::to_string(negative_) + " samples are negative, colours outside Rec.709; .hdr holds them as 0"};
  }

 private:
  void add_row(std::vector<std::byte>& out, const float* rgba) {
    std::array<std::vector<std::uint8_t>, 4> planes;
    for (std::size_t x = 0; x < width_; ++x) {
      const float* const pixel = rgba + 4 * x;
      negative_ += static_cast<std::size_t>(std::count_if(pixel, pixel + 3, [](float v) { return v < 0.0F; }));
      const Rgbe rgbe = rgbe_of(pixel);
      for (std::size_t c = 0; c < 4; ++c) {
        planes[c].push_back(rgbe[c]);
      }
    }
    if (width_ < 8 || width_ > 0x7fff) {  // such rows are stored flat
      for (std::size_t x = 0; x < width_; ++x) {
        for (const auto& plane : planes) {
          out.push_back(static_cast<std::byte>(plane[x]));
        }
      }
      return;
    }
    for (const std::size_t byte : {std::size_t{2}, std::size_t{2}, width_ >> 8U, width_ & 0xffU}) {
      out.push_back(static_cast<std::byte>(byte));
    }
    for (const auto& plane : planes) {
      add_runs(out, plane);
    }
  }

  Sink sink_;
  std::size_t width_;
  std::size_t negative_ = 0;
};

class NpyRows : public PictureRows {
 public:
  NpyRows(Sink sink, int width, int height) : sink_(std::move(sink)) {
    static_assert(std::endian::native == std::endian::little);
    std::string text = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(height) + ", " +
                       std::to_string(width) + ", 3), }";
    constexpr std::size_t kBefore = 10;  // magic, version and length
    text.append(63 - (kBefore + text.size()) % 64, ' ');
    text += '\n';
    std::string head = "\x93NUMPY\x01";
    head += '\0';
    head += static_cast<char>(text.size() & 0xffU);
    head += static_cast<char>(text.size() >> 8U);
    sink_(bytes_of_text(head + text));
  }

  void add(const RadianceImage& rows) override {
    const std::vector<float> rgb = rgb_of(rows.rgba);
    sink_(std::as_bytes(std::span(rgb)));
  }

  std::vector<std::string> finish() override { return {}; }

 private:
  Sink sink_;
};

class JsonRows : public PictureRows {
 public:
  JsonRows(Sink sink, int width, int height) : sink_(std::move(sink)) {
    sink_(bytes_of_text("{\"width\": " + std::to_string(width) + ", \"height\": " + std::to_string(height) +
                        ", \"channels\": [\"R\", \"G\", \"B\"],\n \"pixels\": ["));
  }

  void add(const RadianceImage& rows) override {
    std::string text;
    for (int y = 0; y < rows.height; ++y) {
      text += begun_ ? ",\n  [" : "\n  [";
      begun_ = true;
      for (int x = 0; x < rows.width; ++x) {
        const float* const rgb = rows.at(x, y);
        text += (x == 0 ? "[" : ", [") + digits(rgb[0]) + ", " + digits(rgb[1]) + ", " + digits(rgb[2]) + "]";
      }
      text += "]";
    }
    sink_(bytes_of_text(text));
  }

  std::vector<std::string> finish() override {
    sink_(bytes_of_text("\n ]}\n"));
    return {};
  }

 private:
  // The fewest that are read as the same float.
  static std::string digits(float value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  }

  Sink sink_;
  bool begun_ = false;
};

}  // namespace

std::span<const std::string_view> row_formats() {
  return kRowFormats;
}

bool has_row_format(const std::string& file) {
  return std::ranges::find(kRowFormats, ending_of(file)) != kRowFormats.end();
}

bool is_cube_format(const std::string& file) {
  return ending_of(file) == ".ktx2" || ending_of(file) == ".dds";
}

std::unique_ptr<PictureRows> picture_rows(const std::string& file, PictureRows::Sink sink, int width, int height,
                                          bool prefilter) {
  if (is_cube_format(file)) {
    return cube_texture_rows(ending_of(file) == ".dds", prefilter, std::move(sink), width);
  }
  if (ending_of(file) == ".hdr") {
    return std::make_unique<HdrRows>(std::move(sink), width, height);
  }
  if (ending_of(file) == ".json") {
    return std::make_unique<JsonRows>(std::move(sink), width, height);
  }
  return std::make_unique<NpyRows>(std::move(sink), width, height);
}

}  // namespace airlight
