#include "core/output/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <csetjmp>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/deflate.h"

namespace airlight {
namespace {

// Measured on a dithered 1080p sky, CPU-ms and MB: zlib's level 1 with SUB 38 and 0.86, with UP 50 and 1.1, with all
// filters at level 6 177 and 0.43; a sky's rows are smoother along than across. The 1280x720 of lookdev-spheres, SUB:
// zlib's level 1 takes 17 and 0.54, libdeflate's 1, 2, 3 and 4 take 7.5, 12.2, 14.1 and 16.0, and 0.45, 0.44, 0.40,
// 0.38.
constexpr int kLevel = 1;
constexpr int kSmallestZlibLevel = 9;
constexpr int kFilter = PNG_FILTER_SUB;
constexpr std::size_t kIdatBytes = 1U << 18;

// libdeflate wants all rows at once. Those of larger pictures are compressed by zlib as they come.
constexpr std::size_t kMostAtOnce = std::size_t{32} << 20;

// Everything that libpng's callbacks reach. No frame that longjmp leaves may hold an object with a destructor.
struct Buffer {
  std::vector<std::byte> bytes;
  std::string error;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  Buffer& buffer = *static_cast<Buffer*>(png_get_io_ptr(png));
  const std::byte* const first = reinterpret_cast<const std::byte*>(data);
  buffer.bytes.insert(buffer.bytes.end(), first, first + size);
}

[[noreturn]] void leave(png_structp png, png_const_charp message) {
  static_cast<Buffer*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

class Writer {
 public:
  explicit Writer(Buffer& buffer)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &buffer, leave, ignore_warning)) {
    if (png_ != nullptr) {
      info_ = png_create_info_struct(png_);
    }
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw RunError("PNG: cannot start the encoder: out of memory");
    }
    png_set_write_fn(png_, &buffer, append, nullptr);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  png_structp png() { return png_; }
  png_infop info() { return info_; }

 private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

// libpng 1.6 does not know cICP: primaries, transfer, matrix (none: RGB), full range.
void add_code_points(Writer& writer, const ColourCode& colours) {
  std::array<png_byte, 4> data{static_cast<png_byte>(colours.primaries), static_cast<png_byte>(colours.transfer), 0, 1};
  constexpr std::array<png_byte, 5> kName{'c', 'I', 'C', 'P', 0};
  png_unknown_chunk chunk{};
  std::ranges::copy(kName, chunk.name);
  chunk.data = data.data();
  chunk.size = data.size();
  chunk.location = PNG_HAVE_IHDR;
  png_set_keep_unknown_chunks(writer.png(), PNG_HANDLE_CHUNK_ALWAYS, kName.data(), 1);
  png_set_unknown_chunks(writer.png(), writer.info(), &chunk, 1);
}

void add_colours(Writer& writer, const ColourCode& colours) {
  if (colours == kSrgbCode) {
    png_set_sRGB_gAMA_and_cHRM(writer.png(), writer.info(), PNG_sRGB_INTENT_RELATIVE);
    return;
  }
  add_code_points(writer, colours);
  const std::array<double, 8> xy = primaries_of(colours);
  if (const std::optional<double> exponent = encoding_exponent(colours)) {
    png_set_gAMA(writer.png(), writer.info(), *exponent);
    png_set_cHRM(writer.png(), writer.info(), xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6], xy[7]);
  }
}

void add_texts(Writer& writer, const std::map<std::string, std::string>& texts) {
  for (const auto& [key, value] : texts) {
    const bool ascii = std::ranges::all_of(value, [](char c) { return static_cast<signed char>(c) >= 0; });
    png_text text{};
    text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(key.c_str());  // libpng copies both
    text.text = const_cast<char*>(value.c_str());
    text.text_length = ascii ? value.size() : 0;
    text.itxt_length = ascii ? 0 : value.size();
    png_set_text(writer.png(), writer.info(), &text, 1);
  }
}

void write_rows(Writer& writer, const PixelImage& image) {
  const std::size_t samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    if (image.bits == 8) {
      png_write_row(writer.png(), image.bytes.data() + y * samples);
    } else {
      png_write_row(writer.png(), reinterpret_cast<png_const_bytep>(image.words.data() + y * samples));
    }
  }
}

// The functions below return false when libpng gave up; Buffer::error has the reason.

bool begin(Writer& writer, const PixelImage& image, int height, const PngOptions& options) {
  if (setjmp(png_jmpbuf(writer.png())) != 0) {
    return false;
  }
  png_set_user_limits(writer.png(), 0x7fffffff, 0x7fffffff);
  png_set_compression_level(writer.png(), options.smallest ? kSmallestZlibLevel : kLevel);
  png_set_compression_buffer_size(writer.png(), kIdatBytes);
  png_set_filter(writer.png(), PNG_FILTER_TYPE_BASE, options.smallest ? PNG_ALL_FILTERS : kFilter);
  png_set_IHDR(writer.png(), writer.info(), static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(height),
               image.bits, image.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (options.colours) {
    add_colours(writer, *options.colours);
  }
  add_texts(writer, options.texts);
  png_write_info(writer.png(), writer.info());
  if (image.bits == 16 && std::endian::native == std::endian::little) {
    png_set_swap(writer.png());
  }
  return true;
}

bool write(Writer& writer, const PixelImage& rows) {
  if (setjmp(png_jmpbuf(writer.png())) != 0) {
    return false;
  }
  write_rows(writer, rows);
  return true;
}

bool end(Writer& writer) {
  if (setjmp(png_jmpbuf(writer.png())) != 0) {
    return false;
  }
  png_write_end(writer.png(), writer.info());
  return true;
}

// In place of write() and end().
bool end_with(Writer& writer, std::span<const png_byte> compressed) {
  if (setjmp(png_jmpbuf(writer.png())) != 0) {
    return false;
  }
  constexpr std::array<png_byte, 5> kData{'I', 'D', 'A', 'T', 0};
  constexpr std::array<png_byte, 5> kEnd{'I', 'E', 'N', 'D', 0};
  png_write_chunk(writer.png(), kData.data(), compressed.data(), compressed.size());
  png_write_chunk(writer.png(), kEnd.data(), nullptr, 0);
  return true;
}

std::size_t row_bytes(const PixelImage& image) {
  return static_cast<std::size_t>(image.width * image.channels * (image.bits / 8));
}

// A row as PNG's filter SUB leaves it: the filter's number, and each byte less that of the pixel before.
void add_filtered(std::vector<png_byte>& rows, std::span<const png_byte> row, std::size_t pixel) {
  rows.push_back(PNG_FILTER_VALUE_SUB);
  rows.insert(rows.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(pixel));
  std::transform(row.begin() + static_cast<std::ptrdiff_t>(pixel), row.end(), row.begin(), std::back_inserter(rows),
                 [](png_byte here, png_byte before) { return static_cast<png_byte>(here - before); });
}

void add_filtered(std::vector<png_byte>& rows, const PixelImage& image) {
  const std::size_t samples = static_cast<std::size_t>(image.width * image.channels);
  const std::size_t pixel = static_cast<std::size_t>(image.channels * image.bits / 8);
  std::vector<png_byte> row(row_bytes(image));
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    if (image.bits == 8) {
      add_filtered(rows, std::span(image.bytes).subspan(y * samples, samples), pixel);
      continue;
    }
    for (std::size_t i = 0; i < samples; ++i) {  // most significant byte first
      row[2 * i] = static_cast<png_byte>(image.words[y * samples + i] >> 8);
      row[2 * i + 1] = static_cast<png_byte>(image.words[y * samples + i]);
    }
    add_filtered(rows, row, pixel);
  }
}

}  // namespace

struct PngRows::State {
  explicit State(Sink to) : sink(std::move(to)), writer(buffer) {}

  // No exception may pass through libpng, so its output is handed on between its calls.
  void hand_on(bool went_well) {
    if (!went_well) {
      throw RunError("PNG: cannot encode the picture: " + buffer.error);
    }
    sink(buffer.bytes);
    buffer.bytes.clear();
  }

  Sink sink;
  Buffer buffer;
  Writer writer;
  bool is_whole = false;       // all rows are compressed at the end
  std::vector<png_byte> rows;  // filtered
};

PngRows::PngRows(Sink sink, const PixelImage& format, int height, const PngOptions& options)
    : state_(std::make_unique<State>(std::move(sink))) {
  assert(format.width > 0 && height > 0 && (format.channels == 3 || format.channels == 4));
  assert(format.bits == 8 || format.bits == 16);
  const std::size_t bytes = (1 + row_bytes(format)) * static_cast<std::size_t>(height);
  state_->is_whole = bytes <= kMostAtOnce && !options.smallest;
  if (state_->is_whole) {
    state_->rows.reserve(bytes);
  }
  state_->hand_on(begin(state_->writer, format, height, options));
}

PngRows::~PngRows() = default;

void PngRows::add(const PixelImage& rows) {
  if (state_->is_whole) {
    add_filtered(state_->rows, rows);
    return;
  }
  state_->hand_on(write(state_->writer, rows));
}

void PngRows::finish() {
  if (state_->is_whole) {
    state_->hand_on(end_with(state_->writer, Deflate(kLevel).compressed(state_->rows)));
    return;
  }
  state_->hand_on(end(state_->writer));
}

std::vector<std::byte> encode_png(const PixelImage& image, const PngOptions& options) {
  std::vector<std::byte> bytes;
  PngRows rows([&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); }, image,
               image.height, options);
  rows.add(image);
  rows.finish();
  return bytes;
}

void write_png(const std::filesystem::path& file, const PixelImage& image, const PngOptions& options) {
  write_file(file, encode_png(image, options));
}

}  // namespace airlight
