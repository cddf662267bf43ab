#pragma once
// Converts floats to IEEE halves for the EXR and counts values that a half cannot hold.

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/output/exr.h"

namespace airlight {

// Converts `count` samples, `stride` floats apart, rounding to nearest even; above 65504 becomes 65504 (NaN stays).
void convert_to_half(const float* samples, std::size_t stride, std::size_t count, std::uint16_t* halves,
                     ExrCounts& counts);

// Copies them, two words each, with the counts that do not depend on the format: samples, negative, nan.
void copy_floats(const float* samples, std::size_t stride, std::size_t count, std::uint16_t* words, ExrCounts& counts);

// The visible loss of a picture in halves; empty: none. It is a loss if a sample exceeds 65504, or if more than a
// hundredth of the samples that matter, those no darker than 1/256 of `typical` (the picture's metered luminance), are
// below 2^-16, where a half has fewer than 8 bits.
std::string half_loss(const RadianceImage& image, double typical);

void add_counts(ExrCounts& total, const ExrCounts& part);

}  // namespace airlight
