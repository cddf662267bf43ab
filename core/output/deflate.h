#pragma once
// Bytes compressed at once in zlib's format (RFC 1950), by libdeflate. Throws std::bad_alloc.

#include <libdeflate.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

namespace airlight {

class Deflate {
 public:
  // `level`: 1 (fastest) to 12.
  explicit Deflate(int level) : compressor_(libdeflate_alloc_compressor(level)) {
    if (!compressor_) {
      throw std::bad_alloc();
    }
  }

  // Number of bytes written to `out`; 0 where they are too many for it.
  std::size_t compress(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> out) {
    return libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(), out.data(), out.size());
  }

  std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> out(libdeflate_zlib_compress_bound(compressor_.get(), bytes.size()));
    out.resize(compress(bytes, out));
    return out;
  }

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

}  // namespace airlight
