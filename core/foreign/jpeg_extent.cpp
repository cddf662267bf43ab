#include "core/foreign/jpeg_extent.h"

#include <fstream>
#include <stdexcept>

namespace airlight::foreign {
namespace {

// Second bytes of markers, which begin with 0xff (ITU T.81, table B.1).
constexpr int kStart = 0xd8;
constexpr int kEnd = 0xd9;
constexpr int kScan = 0xda;

// The next marker's second byte, after any fill bytes; -1 at the end of the file.
int marker(std::istream& in) {
  int byte = in.get();
  while (byte == 0xff) {
    byte = in.get();
    if (byte != 0xff) {
      return byte;
    }
  }
  return -1;
}

// Skips a segment by its length. Those before the pixels may hold a thumbnail with an end of its own.
void skip_segment(std::istream& in) {
  const int high = in.get();
  const int low = in.get();
  in.seekg(256 * high + low - 2, std::ios::cur);
}

// Whether the marker of the end follows. Within pixels 0xff stands before 0 alone.
bool ends(std::istream& in) {
  for (int before = 0, byte = in.get(); in; before = byte, byte = in.get()) {
    if (before == 0xff && byte == kEnd) {
      return true;
    }
  }
  return false;
}

}  // namespace

void require_whole_jpeg(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (marker(in) != kStart) {
    return;
  }
  int found = marker(in);
  while (in && found > 0 && found != kScan) {
    skip_segment(in);
    found = marker(in);
  }
  if (!in || found != kScan || !ends(in)) {
    throw std::runtime_error("it has no end");
  }
}

}  // namespace airlight::foreign
