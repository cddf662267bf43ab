#pragma once
// The sums of every pixel so far, and the file that keeps them.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/methods/method.h"

namespace airlight {

// Batch means of the higher orders, for a sun of irradiance 1.
struct PixelSums {
  std::uint64_t batches = 0;
  std::array<double, 3> sum{};
  std::array<double, 3> squares{};
};

// Everything that the sums depend on, one `POINTER value` a line. Sums may be added if and only if their texts are
// equal.
std::string checkpoint_identity(const Stage& stage, const View& view);

// Whether `file` exists. Throws InputError unless it holds the sums of this identity, whole.
bool read_checkpoint(const std::string& file, const std::string& identity, std::span<PixelSums> pixels);

// Replaces the file in one step: a crash leaves the old one or the new one. Throws RunError.
void write_checkpoint(const std::string& file, const std::string& identity, std::span<const PixelSums> pixels);

}  // namespace airlight
