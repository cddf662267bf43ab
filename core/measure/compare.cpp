#include "core/measure/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "core/base/error.h"
#include "core/base/member.h"
#include "core/base/text.h"
#include "core/measure/analyse.h"
#include "core/measure/error_picture.h"
#include "core/measure/exr_layers.h"
#include "core/measure/judge.h"
#include "core/measure/reduce_pictures.h"
#include "core/measure/words.h"
#include "core/output/png.h"
#include "core/output/provenance.h"

namespace airlight::measure {
namespace {

std::vector<std::byte> png_of(const Raster& raster) {
  return encode_png({.width = raster.width(), .height = raster.height(), .bytes = raster.rgb(), .words = {}}, {});
}

std::string size_words(const PixelFrame& frame) {
  return std::to_string(frame.width) + "x" + std::to_string(frame.height);
}

std::string window_words(const PixelFrame& frame) {
  return std::to_string(frame.columns) + "x" + std::to_string(frame.rows) + " pixels stored from (" +
         std::to_string(frame.left) + ", " + std::to_string(frame.top) + ")";
}

void require_same_frame(const std::string& file_a, const PixelFrame& a, const std::string& file_b,
                        const PixelFrame& b) {
  if (a.width != b.width || a.height != b.height) {
    throw InputError("sizes differ: " + file_a + " is " + size_words(a) + ", " + file_b + " is " + size_words(b));
  }
  if (a.left != b.left || a.top != b.top || a.columns != b.columns || a.rows != b.rows) {
    throw InputError("data windows differ: " + file_a + " has " + window_words(a) + ", " + file_b + " has " +
                     window_words(b));
  }
}

std::optional<std::size_t> place_of(const ExrLayer& layer, const std::string& channel) {
  const auto found = std::ranges::find(layer.channels, channel);
  if (found == layer.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - layer.channels.begin());
}

std::vector<std::size_t> places_of(const LayeredExr& header, const ExrLayer& layer,
                                   const std::vector<std::string>& channels) {
  std::vector<std::size_t> places;
  for (const std::string& channel : channels) {
    const auto place = place_of(layer, channel);
    if (!place) {
      throw InputError(header.file + ": has no channel '" + channel + "'; it has " + joined(layer.channels, ", "));
    }
    places.push_back(*place);
  }
  return places;
}

// The channels to compare: the requested ones, else all. Alpha that only one picture has is left out, with a note,
// since the picture is in the colours. All other channels must be in both.
std::vector<std::string> choose_channels(const ComparisonRequest& request, const ExrLayer& a, const ExrLayer& b,
                                         std::vector<std::string>& notes) {
  if (!request.channels.empty()) return request.channels;
  std::vector<std::string> common;
  for (const std::string& channel : a.channels) {
    if (place_of(b, channel)) common.push_back(channel);
  }
  const auto all_but_alpha = [&](const ExrLayer& layer) {
    return std::ranges::all_of(layer.channels, [&](const std::string& channel) {
      return channel == "A" || std::ranges::find(common, channel) != common.end();
    });
  };
  if (common.empty() || !all_but_alpha(a) || !all_but_alpha(b)) {
    std::string message = "channels differ: " + request.a + " has " + joined(a.channels, " ") + ", " + request.b +
                          " has " + joined(b.channels, " ");
    if (!common.empty()) message += "; compare what both have with --channels " + joined(common, ",");
    throw InputError(message);
  }
  if (a.channels.size() != b.channels.size()) {
    notes.push_back((place_of(a, "A") ? request.a : request.b) + ": not compared: A, which " +
                    (place_of(a, "A") ? request.b : request.a) + " has not");
  }
  return common;
}

// The layer of a standard-error file: by name, else the one called standard error, else the main picture.
const ExrLayer& find_sigma_layer(const LayeredExr& header, const std::string& name) {
  if (!name.empty()) return find_layer(header, name);
  for (const char* usual : {"standard_error", "standard-error", "stderr"}) {
    for (const ExrLayer& layer : header.layers) {
      if (layer.name == usual) return layer;
    }
  }
  return find_layer(header, "");
}

// Adds one file's standard errors in quadrature; alpha may be absent from it.
void add_standard_error(const ComparisonRequest& request, const std::string& file, PicturePair& pair) {
  const LayeredExr header = read_exr_layers(file);
  const ExrLayer& layer = find_sigma_layer(header, request.standard_error_layer);
  require_same_frame(request.a, pair.frame, file, layer.frame);
  std::vector<std::string> channels;
  std::vector<Plane*> planes;
  for (Plane& plane : pair.planes) {
    if (plane.name == "A" && !place_of(layer, "A")) continue;
    channels.push_back(plane.name);
    planes.push_back(&plane);
  }
  if (channels.empty()) throw InputError(file + ": holds no standard error of the channels compared");
  const std::vector<std::vector<float>> values = read_exr_channels(header, layer, places_of(header, layer, channels));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    planes[k]->sigma.resize(values[k].size(), 0.0F);
    for (std::size_t i = 0; i < values[k].size(); ++i) {
      if (!(values[k][i] >= 0.0F) || !std::isfinite(values[k][i])) {
        throw InputError(file + ": channel " + channels[k] + " holds " + number(static_cast<double>(values[k][i])) +
                         ", which is no standard error; expected numbers from 0");
      }
      planes[k]->sigma[i] = std::hypot(planes[k]->sigma[i], values[k][i]);
    }
  }
}

std::string words(const Chromaticities& c) {
  return "red " + number(c[0]) + " " + number(c[1]) + ", green " + number(c[2]) + " " + number(c[3]) + ", blue " +
         number(c[4]) + " " + number(c[5]) + ", white " + number(c[6]) + " " + number(c[7]);
}

// Refuses pictures in different colour spaces. Chromaticities are printed with four or five digits.
void require_same_colours(const LayeredExr& a, const LayeredExr& b, const std::vector<std::string>& channels) {
  constexpr double kPrinted = 6e-5;
  const bool colours =
      std::ranges::any_of(channels, [](const std::string& name) { return name == "R" || name == "G" || name == "B"; });
  for (std::size_t i = 0; colours && i < a.chromaticities.size(); ++i) {
    if (std::abs(a.chromaticities[i] - b.chromaticities[i]) > kPrinted) {
      throw InputError("colour spaces differ: " + a.file + " has " + words(a.chromaticities) + "; " + b.file + " has " +
                       words(b.chromaticities) +
                       ": render one of them again with the other's --colorspace, or convert it");
    }
  }
}

PicturePair read_pair(const ComparisonRequest& request, const LayeredExr& a, const LayeredExr& b,
                      std::vector<std::string>& notes) {
  const ExrLayer& layer_a = find_layer(a, request.layer);
  const ExrLayer& layer_b = find_layer(b, request.layer);
  require_same_frame(a.file, layer_a.frame, b.file, layer_b.frame);
  const std::vector<std::string> channels = choose_channels(request, layer_a, layer_b, notes);
  require_same_colours(a, b, channels);
  PicturePair pair;
  pair.frame = layer_a.frame;
  pair.luminance_weights = luminance_weights(b.chromaticities);
  pair.nonfinite = request.allow_nonfinite ? NonfiniteRule::equal_to_same : NonfiniteRule::never_equal;
  pair.in_sigmas = !request.standard_errors.empty();
  std::vector<std::vector<float>> values_a = read_exr_channels(a, layer_a, places_of(a, layer_a, channels));
  std::vector<std::vector<float>> values_b = read_exr_channels(b, layer_b, places_of(b, layer_b, channels));
  for (std::size_t i = 0; i < channels.size(); ++i) {
    pair.planes.push_back({channels[i], std::move(values_a[i]), std::move(values_b[i]), {}});
  }
  for (const std::string& file : request.standard_errors) add_standard_error(request, file, pair);
  return pair;
}

// The viewpoint of the pictures: the request's, else that of the reference's preset, else that of A's.
void find_viewpoint(const ComparisonRequest& request, const LayeredExr& a, const LayeredExr& b, PicturePair& pair,
                    ComparisonReport& report) {
  if (!request.view_preset.empty()) {
    pair.viewpoint = viewpoint_from_preset(request.view_preset);
    return;
  }
  const LayeredExr& teller = b.preset ? b : a;
  if (!teller.preset) return;
  try {
    pair.viewpoint = viewpoint_from_preset(*teller.preset);
  } catch (const InputError& problem) {
    report.notes.push_back(teller.file + ": " + problem.what() + "; no regions");
  }
}

void compare_presets(const LayeredExr& a, const LayeredExr& b, ComparisonReport& report) {
  if (!a.preset || !b.preset) return;
  try {
    report.preset_keys = preset_difference(*a.preset, *b.preset);
    report.presets_known = true;
  } catch (const InputError& problem) {
    report.notes.push_back(std::string("presets not compared: ") + problem.what());
  }
}

void note_version(const std::string& ours, const LayeredExr& exr, ComparisonReport& report) {
  if (const std::string note = version_note(exr.version, ours); !note.empty()) {
    report.notes.push_back(exr.file + ": " + note);
  }
}

void note_other_layers(const ComparisonRequest& request, const LayeredExr& header, ComparisonReport& report) {
  std::vector<std::string> others;
  const std::string& compared = find_layer(header, request.layer).name;
  for (const ExrLayer& layer : header.layers) {
    if (layer.name != compared) others.push_back(layer.name.empty() ? "the main picture" : layer.name);
  }
  if (!others.empty()) report.notes.push_back(header.file + ": not compared: " + joined(others, ", "));
}

std::optional<NonfinitePlace> first_nonfinite(const PicturePair& pair, MemberOf<Plane, std::vector<float>> side) {
  std::optional<NonfinitePlace> place;
  std::size_t first = std::numeric_limits<std::size_t>::max();
  for (const Plane& plane : pair.planes) {
    const std::vector<float>& values = plane.*side;
    const auto found = std::ranges::find_if(values, [](float x) { return !std::isfinite(x); });
    const auto index = static_cast<std::size_t>(found - values.begin());
    if (found != values.end() && index < first) {
      first = index;
      const auto columns = static_cast<std::size_t>(pair.frame.columns);
      place = NonfinitePlace{pair.frame.left + static_cast<int>(index % columns),
                             pair.frame.top + static_cast<int>(index / columns), plane.name};
    }
  }
  return place;
}

void count_nonfinite(const PicturePair& pair, ComparisonReport& report) {
  report.first_nonfinite_a = first_nonfinite(pair, &Plane::a);
  report.first_nonfinite_b = first_nonfinite(pair, &Plane::b);
  const auto count = [](const std::vector<float>& values, std::size_t& nan, std::size_t& infinite) {
    nan = static_cast<std::size_t>(std::ranges::count_if(values, [](float x) { return std::isnan(x); }));
    infinite = static_cast<std::size_t>(std::ranges::count_if(values, [](float x) { return std::isinf(x); }));
  };
  for (const Plane& plane : pair.planes) {
    NonfiniteCount entry;
    entry.channel = plane.name;
    count(plane.a, entry.nan_a, entry.infinite_a);
    count(plane.b, entry.nan_b, entry.infinite_b);
    if (entry.nan_a + entry.infinite_a + entry.nan_b + entry.infinite_b > 0) report.nonfinite.push_back(entry);
  }
}

void draw(const ComparisonRequest& request, const PicturePair& pair, const std::vector<float>& errors,
          ComparisonReport& report) {
  const ErrorScale scale = scale_for(errors, pair.in_sigmas, request.heatmap_max);
  const PictureSize size{pair.frame.columns, pair.frame.rows};
  if (request.heatmap) report.heatmap_png = png_of(draw_heatmap(errors, size, scale));
  if (request.side_by_side) {
    report.side_by_side_png = png_of(draw_side_by_side(shown_planes(pair.planes, &Plane::a),
                                                       shown_planes(pair.planes, &Plane::b), errors, size, scale));
  }
  if (request.shown_pixels > 0) report.shown = reduce_pictures(pair, errors, scale, request.shown_pixels);
}

void compare_into(const ComparisonRequest& request, ComparisonReport& report) {
  const LayeredExr a = read_exr_layers(request.a);
  const LayeredExr b = read_exr_layers(request.b);
  compare_presets(a, b, report);
  PicturePair pair = read_pair(request, a, b, report.notes);
  find_viewpoint(request, a, b, pair, report);
  note_version(request.version, a, report);
  note_version(request.version, b, report);
  note_other_layers(request, a, report);
  note_other_layers(request, b, report);
  count_nonfinite(pair, report);
  const Limits limits = limits_in_force(request.limits, pair.in_sigmas);
  const std::vector<float> errors = analyse(pair, limits, report);
  judge(limits, pair.in_sigmas, report);
  draw(request, pair, errors, report);
}

}  // namespace

ComparisonReport compare(const ComparisonRequest& request) {
  ComparisonReport report;
  try {
    compare_into(request, report);
    return report;
  } catch (const std::bad_alloc&) {
    report.problem = request.a + ", " + request.b + ": not enough memory to compare them";
  } catch (const std::exception& problem) {
    report.problem = one_line(problem.what());
  }
  report.verdict = Verdict::cannot_compare;
  return report;
}

}  // namespace airlight::measure
