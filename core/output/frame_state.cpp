#include "core/output/frame_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>

#include "core/output/exr_header.h"
#include "core/output/png_texts.h"
#include "core/output/provenance.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kPlainFlags = 0x400;  // at most long names: neither deep nor of several parts

// True if the last chunk ends where the file ends, and the table of offsets lacks none.
bool is_whole_exr(std::istream& in, const ExrHeader& header, std::uint64_t file_size) {
  const bool is_of_scan_lines = header.flags <= kPlainFlags && !is_tiled(header);
  const std::int64_t chunks = is_of_scan_lines ? chunk_count(header) : 0;
  if (chunks == 0 || header.end + 8 * static_cast<std::uint64_t>(chunks) > file_size) {
    return false;
  }
  std::uint64_t last = 0;
  for (std::int64_t i = 0; i < chunks; ++i) {
    const std::uint64_t place = read_little_endian(in, 8);
    if (place < header.end || place > file_size - 8) {
      return false;
    }
    last = std::max(last, place);
  }
  in.seekg(static_cast<std::streamoff>(last + 4));  // after the number of its first row
  return last + 8 + read_little_endian(in, 4) == file_size;
}

std::optional<FrameMark> exr_mark(std::istream& in, std::uint64_t file_size) {
  const ExrHeader header = read_exr_header(in, file_size);
  if (!is_whole_exr(in, header, file_size)) {
    return std::nullopt;
  }
  return FrameMark{text_of(header, kHashKey).value_or(""), text_of(header, kPresetKey).value_or("")};
}

std::optional<FrameMark> png_mark(std::istream& in, std::uint64_t file_size) {
  PngTexts png = read_png_texts(in, file_size);
  return png.is_whole ? std::optional(FrameMark{png.texts[kHashKey], png.texts[kPresetKey]}) : std::nullopt;
}

}  // namespace

std::optional<FrameMark> read_frame_mark(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    return std::nullopt;
  }
  const std::uint64_t size = fs::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) {
    return std::nullopt;
  }
  try {
    if (file.extension() == ".exr" && is_exr(in)) {
      return exr_mark(in, size);
    }
    return file.extension() == ".png" && is_png(in) ? png_mark(in, size) : std::nullopt;
  } catch (const std::runtime_error&) {  // of read_exr_header: damaged
    return std::nullopt;
  }
}

}  // namespace airlight
