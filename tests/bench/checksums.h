#pragma once
// Checksums of pictures that are valid across devices: moments within a tolerance, kept in a text file.

#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace airlight::bench {

// Moments of a picture, for each channel: the mean, then the mean natural logarithm of max(value, 1e-9), which depends
// on dark and bright parts alike.
struct Moments {
  std::array<double, 3> mean{};
  std::array<double, 3> log{};
};

// An NVIDIA H200 differs from the software device by 1.1e-4 and 4.6e-4 at most, the latter by twilight.
inline constexpr double kMeanTolerance = 1e-3;  // relative
inline constexpr double kLogTolerance = 1e-3;   // absolute: a thousandth of the value, everywhere

// Four floats a pixel; the fourth is ignored.
Moments moments_of(std::span<const float> rgba);

bool agree(const Moments& expected, const Moments& found);

using Checksums = std::map<std::pair<std::string, std::string>, Moments>;  // by method and picture

// Lines "method picture mean_r mean_g mean_b log_r log_g log_b"; "#" begins a comment. Throws InputError.
Checksums read_checksums(const std::string& file);
// Throws RunError.
void write_checksums(const std::string& file, const Checksums& checksums, const std::string& device);

// A line for each picture that differs, that the file lacks, or that was not rendered; empty: all agree.
std::vector<std::string> differences(const Checksums& expected, const Checksums& found);

}  // namespace airlight::bench
