#include "core/measure/analyse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "core/base/in_parallel.h"
#include "core/base/member.h"

namespace airlight::measure {
namespace {

// A plane without a standard error (alpha, which no sample touches) is judged as exact: errors up to idiff's threshold
// are 0, larger ones infinite.
constexpr float kExactTolerance = 1e-6F;

constexpr std::size_t kFewestForThreads = 100'000;  // pixels

struct PlaneErrors {
  std::string name;
  const std::vector<float>* a = nullptr;
  const std::vector<float>* b = nullptr;
  const std::vector<float>* sigma = nullptr;  // null: none
  std::vector<float> absolute;
  std::vector<float> relative;
  std::vector<float> sigmas;  // empty: none
};

// Planes laid end to end: an index gives the plane and the pixel.
struct Group {
  std::string name;
  std::vector<const PlaneErrors*> members;
};

PlaneErrors errors_of(const std::string& name, const std::vector<float>& a, const std::vector<float>& b,
                      const std::vector<float>& sigma, NonfiniteRule rule) {
  PlaneErrors errors;
  errors.name = name;
  errors.a = &a;
  errors.b = &b;
  errors.sigma = sigma.empty() ? nullptr : &sigma;
  errors.absolute = absolute_errors(a, b, rule);
  errors.relative = relative_errors(a, b, mean_magnitude(b), rule);
  if (!sigma.empty()) errors.sigmas = sigma_errors(a, b, sigma, rule);
  return errors;
}

PixelReport place(const PicturePair& pair, const Group& group, std::size_t index) {
  const std::size_t pixels = group.members.front()->absolute.size();
  const PlaneErrors& plane = *group.members[index / pixels];
  const std::size_t pixel = index % pixels;
  const int column = static_cast<int>(pixel % static_cast<std::size_t>(pair.frame.columns));
  const int row = static_cast<int>(pixel / static_cast<std::size_t>(pair.frame.columns));
  PixelReport report;
  report.x = pair.frame.left + column;
  report.y = pair.frame.top + row;
  report.a = static_cast<double>((*plane.a)[pixel]);
  report.b = static_cast<double>((*plane.b)[pixel]);
  report.channel = plane.name;
  if (!pair.viewpoint) return report;
  if (const auto look = look_direction(*pair.viewpoint, pair.frame, column, row)) {
    report.elevation_deg = look->elevation / kDegree;
    report.azimuth_deg = look->azimuth / kDegree;
  }
  return report;
}

ErrorSummary summarize_group(const Group& group, MemberOf<PlaneErrors, std::vector<float>> errors, const Area& area,
                             std::vector<float>& scratch) {
  std::vector<std::span<const float>> channels;
  for (const PlaneErrors* plane : group.members) channels.emplace_back(plane->*errors);
  return summarize(channels, area, scratch);
}

using Scratch = std::array<std::vector<float>, 3>;

ChannelReport report_group(const PicturePair& pair, const Group& group, const Area& area, const Limits& limits,
                           Scratch& scratch) {
  ChannelReport report;
  report.name = group.name;
  const bool has_sigma =
      std::ranges::all_of(group.members, [](const PlaneErrors* plane) { return plane->sigma != nullptr; });
  if (has_sigma) {
    report.sigma.emplace();
    report.chi_square.emplace();
  }
  const auto add_sums = [&] {
    for (const PlaneErrors* plane : group.members) {
      report.deviation += deviation(*plane->a, *plane->b, area, pair.nonfinite);
      if (has_sigma) *report.chi_square += chi_square(*plane->a, *plane->b, *plane->sigma, area, pair.nonfinite);
      const std::vector<float>& judged = has_sigma ? plane->sigmas : plane->absolute;
      if (pair.in_sigmas && !has_sigma) continue;
      if (limits.fail) report.over_fail += count_over(judged, *limits.fail, area);
      if (limits.warn) report.over_warn += count_over(judged, *limits.warn, area);
    }
  };
  const std::array<std::function<void()>, 4> parts = {
      [&] { report.absolute = summarize_group(group, &PlaneErrors::absolute, area, scratch[0]); },
      [&] { report.relative = summarize_group(group, &PlaneErrors::relative, area, scratch[1]); }, add_sums,
      [&] {
        if (has_sigma) report.sigma = summarize_group(group, &PlaneErrors::sigmas, area, scratch[2]);
      }};
  if (group.members.front()->absolute.size() < kFewestForThreads) {
    for (const std::function<void()>& part : parts) part();
  } else {
    in_parallel(parts.size(), [&](std::size_t i) { parts[i](); });
  }
  if (report.absolute.count > 0) {
    report.worst_absolute = place(pair, group, report.absolute.worst);
    report.worst_relative = place(pair, group, report.relative.worst);
  }
  return report;
}

// The value that judges each pixel: the largest over the planes.
std::vector<float> judged_pixels(const PicturePair& pair, const std::vector<PlaneErrors>& planes) {
  std::vector<float> largest(planes.front().absolute.size(), 0.0F);
  for (const PlaneErrors& plane : planes) {
    const bool exact = pair.in_sigmas && plane.sigma == nullptr;
    const std::vector<float>& errors = plane.sigma != nullptr ? plane.sigmas : plane.absolute;
    for (std::size_t i = 0; i < largest.size(); ++i) {
      const float error = !exact                         ? errors[i]
                          : errors[i] <= kExactTolerance ? 0.0F
                                                         : std::numeric_limits<float>::infinity();
      largest[i] = std::max(largest[i], error);
    }
  }
  return largest;
}

std::vector<float> largest_relative(const std::vector<PlaneErrors>& planes) {
  std::vector<float> largest = planes.front().relative;
  for (const PlaneErrors& plane : planes) {
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], plane.relative[i]);
  }
  return largest;
}

std::size_t unequal_nonfinite_pixels(const std::vector<PlaneErrors>& planes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < planes.front().absolute.size(); ++i) {
    const bool any = std::ranges::any_of(planes, [&](const PlaneErrors& plane) {
      return std::isinf(plane.absolute[i]) && (!std::isfinite((*plane.a)[i]) || !std::isfinite((*plane.b)[i]));
    });
    if (any) ++count;
  }
  return count;
}

std::vector<Group> groups_of(const std::vector<PlaneErrors>& planes, const std::vector<std::size_t>& colours,
                             const PlaneErrors* luminance_errors) {
  std::vector<Group> groups;
  for (const PlaneErrors& plane : planes) groups.push_back({plane.name, {&plane}});
  if (luminance_errors != nullptr) groups.push_back({luminance_errors->name, {luminance_errors}});
  Group pooled{"pooled", {}};
  for (const std::size_t index : colours) pooled.members.push_back(&planes[index]);
  groups.push_back(std::move(pooled));
  return groups;
}

void report_areas(const PicturePair& pair, const std::vector<Group>& groups, const Limits& limits,
                  ComparisonReport& report) {
  Scratch scratch;
  const auto add = [&](std::string_view name, const Area& area, std::size_t pixels) {
    AreaReport& entry = report.areas.emplace_back();
    entry.name = name;
    entry.pixels = pixels;
    for (const Group& group : groups) entry.channels.push_back(report_group(pair, group, area, limits, scratch));
  };
  add("picture", {}, report.pixels);
  if (!pair.viewpoint) return;
  const std::vector<RegionBits> bits = classify(*pair.viewpoint, pair.frame);
  for (const auto& [region, name] : kRegions) {
    const auto pixels = std::ranges::count_if(bits, [wanted = region](RegionBits b) { return (b & wanted) != 0; });
    if (pixels > 0) add(name, {.bits = bits, .wanted = region}, static_cast<std::size_t>(pixels));
  }
}

}  // namespace

std::vector<std::size_t> colour_planes(const std::vector<Plane>& planes) {
  std::vector<std::size_t> colours;
  for (const char* name : {"R", "G", "B"}) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (planes[i].name == name) colours.push_back(i);
    }
  }
  if (colours.size() == 3) return colours;
  colours.clear();
  for (std::size_t i = 0; i < planes.size(); ++i) colours.push_back(i);
  return colours;
}

std::vector<float> analyse(const PicturePair& pair, const Limits& limits, ComparisonReport& report) {
  report.width = pair.frame.width;
  report.height = pair.frame.height;
  std::vector<PlaneErrors> planes(pair.planes.size());
  for (const Plane& plane : pair.planes) report.channels.push_back(plane.name);
  in_parallel(planes.size(), [&](std::size_t i) {
    const Plane& plane = pair.planes[i];
    planes[i] = errors_of(plane.name, plane.a, plane.b, plane.sigma, pair.nonfinite);
  });
  report.pixels = planes.front().absolute.size();
  report.unequal_nonfinite = unequal_nonfinite_pixels(planes);

  const std::vector<std::size_t> colours = colour_planes(pair.planes);
  const bool has_colour = colours.size() == 3 && pair.planes[colours[0]].name == "R";
  Plane luminance_plane{.name = "luminance", .a = {}, .b = {}, .sigma = {}};
  PlaneErrors luminance_errors;
  if (has_colour) {
    const Plane& r = pair.planes[colours[0]];
    const Plane& g = pair.planes[colours[1]];
    const Plane& b = pair.planes[colours[2]];
    luminance_plane.a = luminance(r.a, g.a, b.a, pair.luminance_weights);
    luminance_plane.b = luminance(r.b, g.b, b.b, pair.luminance_weights);
    luminance_errors = errors_of(luminance_plane.name, luminance_plane.a, luminance_plane.b, {}, pair.nonfinite);
  }
  report_areas(pair, groups_of(planes, colours, has_colour ? &luminance_errors : nullptr), limits, report);

  const std::vector<float> judged = judged_pixels(pair, planes);
  report.largest = static_cast<double>(*std::ranges::max_element(judged));
  if (limits.fail) report.pixels_over_fail = count_over(judged, *limits.fail);
  if (limits.warn) report.pixels_over_warn = count_over(judged, *limits.warn);
  return pair.in_sigmas ? judged : largest_relative(planes);
}

}  // namespace airlight::measure
