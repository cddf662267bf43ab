#pragma once
// The rules of preset format 1 as one table. resolve() reads by it; tests compare presets/README.md and the JSON Schema
// with it. A method's parameters under `render.*` are in its MethodInfo instead.

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "core/scene/member.h"
#include "core/scene/scene.h"

namespace airlight {

struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_excluded = false;
  bool maximum_excluded = false;

  bool contains(double value) const;
};

inline constexpr double kFarthest = 1e7;  // km

// For altitudes of layers and all others.
inline constexpr Range kLayerAltitude{.minimum = 0.0, .maximum = kFarthest};

enum class RuleType {
  version,       // the number 1
  extends,       // a file name; gone once a file is loaded
  text,          // any string
  name,          // a string with at least one character
  boolean,       // true or false
  integer,       // a number without fraction
  number,        // a finite number
  spectrum,      // a number or three
  pair,          // an array of two numbers; default_text is that of each
  curve,         // as spectrum, or a curve over the wavelength
  shape,         // a curve over the wavelength
  wavelengths,   // a whole number or "auto"
  choice,        // one of the listed strings; default_text without quotes
  method,        // the name of a method
  exposure,      // a number, or a way of metering
  media,         // an array of media
  spheres,       // an array of spheres
  clouds,        // an array of clouds
  angles,        // an array of numbers, ascending
  phase_values,  // an array of numbers, or of such arrays
  layers,        // an array of [altitude, density], altitudes ascending; the range is the density's
  key_frames,    // an array of objects: a frame's number and its values of keys
};

struct Rule {
  std::string_view key;  // "media[].phase.g"
  RuleType type = RuleType::number;
  Range range = {};
  std::string_view unit = {};
  std::string_view default_text = {};  // empty: none
  bool required = false;
  std::span<const std::string_view> choices = {};
  // Applies only where the neighbouring choice is one of these, e.g. where `density.profile` is "tent"; empty: always.
  std::span<const std::string_view> only_for = {};
  std::string_view meaning = {};
  std::string_view hint = {};  // ends the message about a number out of range
  Member member = {};
  bool quiet = false;  // the value is not written where it is what a new owner has
};

std::span<const Rule> rules();

// Whether the rule is for this choice of the object that it belongs to; "": for none in particular.
bool holds_for(const Rule& rule, std::string_view choice);

// What the rule's key is within the object `prefix` ("" is the preset): "phase.g" for "media[].phase.g" within
// "media[]"; empty where it belongs to another.
std::string_view path_within(const Rule& rule, std::string_view prefix);

// The same where the value of a key of `prefix`, for `choice`, is kept in a member of the owner `id`; else empty.
std::string_view held_key(const Rule& rule, std::string_view prefix, const void* id, std::string_view choice);

// "-90 to 90 degrees", "at least 0 per km", "above 0 and below 180 degrees".
std::string range_text(const Range& range, std::string_view unit);

// The expected form of a value: "a whole number, 1 to 65536 pixels".
std::string expectation(const Rule& rule);

// Wavelengths of a curve in a preset.
inline constexpr Range kWavelength{.minimum = 200.0, .maximum = 4000.0};

// The names of the enums in scene.h, in their order.
inline constexpr std::array<std::string_view, 1> kInterpolationNames = {"linear"};
inline constexpr std::array<std::string_view, 2> kUpNames = {"y", "z"};
// Behind the enum's: "layer", which becomes a medium.
inline constexpr std::array<std::string_view, 5> kCloudNames = {"cumulus", "stratocumulus", "cirrus", "volume",
                                                                "layer"};
inline constexpr std::size_t kCloudLayer = 4;
inline constexpr std::array<std::string_view, 2> kCloudPhaseNames = {"drops", "henyey-greenstein"};
inline constexpr std::array<std::string_view, 5> kProjectionNames = {"perspective", "equirectangular", "fisheye",
                                                                     "cube", "octahedral"};
inline constexpr std::array<std::string_view, 3> kCubeLayoutNames = {"stack", "strip", "cross"};
inline constexpr std::array<std::string_view, 5> kMaterialNames = {"matte", "mirror", "translucent", "grey-18",
                                                                   "chrome"};
inline constexpr std::array<std::string_view, 2> kLampNames = {"led", "sodium"};
inline constexpr std::array<std::string_view, 2> kBloomModelNames = {"glare", "chain"};
inline constexpr std::array<std::string_view, 3> kSunUnitNames = {"relative", "W/m2", "lux"};
inline constexpr std::array<std::string_view, 3> kWhiteNames = {"sun", "D65", "E"};
inline constexpr std::array<std::string_view, 6> kToneCurveNames = {"aces",        "reinhard", "reinhard-luminance",
                                                                    "exponential", "clamp",    "none"};

}  // namespace airlight
