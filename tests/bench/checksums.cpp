#include "tests/bench/checksums.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "core/base/error.h"

namespace airlight::bench {
namespace {

constexpr double kFloor = 1e-9;

std::string text_of(const Moments& m) {
  std::ostringstream out;
  out << std::setprecision(7);
  for (const double value : m.mean) out << ' ' << value;
  for (const double value : m.log) out << ' ' << value;
  return out.str();
}

std::string name_of(const Checksums::key_type& picture) {
  return picture.first + ' ' + picture.second;
}

}  // namespace

Moments moments_of(std::span<const float> rgba) {
  Moments m;
  const std::size_t pixels = rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = static_cast<double>(rgba[4 * i + c]);
      m.mean[c] += value;
      m.log[c] += std::log(std::max(value, kFloor));
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    m.mean[c] /= static_cast<double>(pixels);
    m.log[c] /= static_cast<double>(pixels);
  }
  return m;
}

bool agree(const Moments& expected, const Moments& found) {
  for (std::size_t c = 0; c < 3; ++c) {
    // Written so that a NaN counts as a difference.
    const bool mean_agrees = std::abs(found.mean[c] - expected.mean[c]) <= kMeanTolerance * std::abs(expected.mean[c]);
    const bool log_agrees = std::abs(found.log[c] - expected.log[c]) <= kLogTolerance;
    if (!mean_agrees || !log_agrees) return false;
  }
  return true;
}

Checksums read_checksums(const std::string& file) {
  std::ifstream in(file);
  if (!in) {
    throw InputError(file +
                     ": cannot be read; expected the checksums of the pictures; name them with --checksums FILE");
  }
  Checksums checksums;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    Checksums::key_type picture;
    Moments m;
    words >> picture.first >> picture.second;
    for (double& value : m.mean) words >> value;
    for (double& value : m.log) words >> value;
    std::string rest;
    if (!words || words >> rest || !checksums.emplace(picture, m).second) {
      throw InputError(file + ':' + std::to_string(number) +
                       ": expected \"method picture mean_r mean_g mean_b log_r log_g log_b\", each picture once; "
                       "write the file anew with --update-checksums FILE");
    }
  }
  return checksums;
}

void write_checksums(const std::string& file, const Checksums& checksums, const std::string& device) {
  std::ofstream out(file);
  out << "# Moments of the pictures that airlight_bench renders, made by `airlight_bench --update-checksums FILE` on\n"
      << "# " << device << "\n"
      << "# method picture mean_r mean_g mean_b log_r log_g log_b\n";
  for (const auto& [picture, m] : checksums) out << name_of(picture) << text_of(m) << '\n';
  out.close();
  if (!out) throw RunError(file + ": cannot be written; name another file or make room");
}

std::vector<std::string> differences(const Checksums& expected, const Checksums& found) {
  std::vector<std::string> lines;
  for (const auto& [picture, m] : found) {
    const auto known = expected.find(picture);
    if (known == expected.end()) {
      lines.push_back(name_of(picture) + ": no checksum in the file; found" + text_of(m));
    } else if (!agree(known->second, m)) {
      lines.push_back(name_of(picture) + ": expected" + text_of(known->second) + "; found" + text_of(m));
    }
  }
  for (const auto& [picture, m] : expected) {
    if (!found.contains(picture)) lines.push_back(name_of(picture) + ": in the file, but not among the pictures");
  }
  return lines;
}

}  // namespace airlight::bench
