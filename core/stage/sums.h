#pragma once
// Groups of wavelengths rendered one after the other on the host, and the sum of their results.

#include <array>
#include <string>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/spectra/colour.h"
#include "core/stage/view.h"

namespace airlight {

// Each group has its own random numbers, checkpoint and share of the report.
class GroupRuns {
 public:
  // `options`: of the whole, must outlive the runs; `suffix`: precedes the group's number in the checkpoints' names.
  GroupRuns(const HostOptions& options, std::size_t count, std::string suffix);

  // The options of group g; sets the seed of its scene. Throws RunError where the report has stopped an earlier group:
  // a stopped group must not count as a picture.
  HostOptions start(Scene& group, std::size_t g);

 private:
  const HostOptions& options_;
  std::size_t count_;
  std::string suffix_;
  bool stopped_ = false;
};

// Channel c of the colour of a part's three channels, added to a sum.
inline double add_colour(double sum, const std::array<Rgb, 3>& colours, std::size_t c, double first, double second,
                         double third) {
  return sum + colours[0][c] * first + colours[1][c] * second + colours[2][c] * third;
}

// Adds a group's picture, its channels as colours, to the sum; alpha is the maximum.
void add_part(RadianceImage& sum, const RadianceImage& part, const std::array<Rgb, 3>& colours);

// Adds a group's standard errors to a variance. Groups are independent. The channels of one group share their paths, so
// their errors are taken as fully correlated, the worst case.
void add_error(RadianceImage& variance, const RadianceImage& part, const std::array<Rgb, 3>& colours);
void take_roots(RadianceImage& variance);

void add_new_lines(std::vector<std::string>& lines, const std::vector<std::string>& more);

}  // namespace airlight
