#pragma once
// Groups of wavelengths rendered one after the other on the host, and the sum of what they give.

#include <string>

#include "core/methods/method.h"
#include "core/methods/spectral_sky.h"
#include "core/radiance_image.h"

namespace airlight {

// Each group has random numbers, a checkpoint and a share of the report of its own.
class GroupRuns {
 public:
  // `options`: of the whole; `suffix`: of the checkpoints' names, before the group's number. Must outlive the runs.
  GroupRuns(const HostOptions& options, std::size_t count, std::string suffix);

  // The options of group g, whose scene gets its seed. Throws RunError where the report has stopped an earlier one:
  // what was stopped in one group must not count as a picture.
  HostOptions start(Scene& group, std::size_t g);

 private:
  const HostOptions& options_;
  std::size_t count_;
  std::string suffix_;
  bool stopped_ = false;
};

// Adds a group's picture, its channels as colours, to the sum; alpha is the greatest.
void add_part(RadianceImage& sum, const RadianceImage& part, const std::array<Rgb, 3>& colours);

// The same of standard errors into a variance. Groups are independent; the channels of one, which share their paths,
// err together at worst.
void add_error(RadianceImage& variance, const RadianceImage& part, const std::array<Rgb, 3>& colours);
void take_roots(RadianceImage& variance);

void add_new_lines(std::vector<std::string>& lines, const std::vector<std::string>& more);

}  // namespace airlight
