#pragma once
// A curve over the wavelength, in one of the forms that a preset may write:
//   {"wavelengths_nm": [...], "values": [...]}            ascending, linear between, constant outside
//   {"file": "x.csv", "scale": 1}                          lines of nm,value; "#" begins a comment
//   {"at_nm": 550, "value": 0.01, "exponent": -1.3}        value x (nm / at_nm)^exponent
//   {"named": "air", "scale": 1}                           a published one, times a number
//   {"named": "ozone", "dobson_units": 300}                by the column of its medium
//   {"black_body_k": 5772}

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/scene/section.h"

namespace airlight {

// "air": Rayleigh scattering, 1/km at sea level; "solar": sunlight above the air.
inline constexpr std::array<std::string_view, 2> kPlainCurveNames = {"air", "solar"};
inline constexpr int kMaxCurveSamples = 4096;
inline constexpr Range kExponent{.minimum = -20.0, .maximum = 20.0};
inline constexpr Range kKelvin{.minimum = 100.0, .maximum = 100000.0};
inline constexpr Range kDobsonUnits{.minimum = 0.0, .maximum = 1e6};
inline constexpr Range kShapeValue{.minimum = 0.0, .maximum = 1e9};

// Path of a file that a preset names: relative to that preset; to the working directory where an option names it.
std::filesystem::path file_beside(const PresetValue& value, const std::string& name);

// Collects the curves of a preset. A scene without any keeps its three channels.
class CurveReader {
 public:
  // The value of `key`: its channels where it is one number or three, and the curve in either case. Ozone may be given
  // by its column: `column` is the medium's at density 1, km.
  SpectralValue read(const Section& section, std::string_view key, double column = 0.0);
  // Reads sun.spectrum; where it is absent, the curve is the sun's.
  Curve read_shape(const Section& section, std::string_view key);

  // Adds a curve that another reader has read.
  void add(const std::string& pointer);

  bool any() const { return any_; }
  // Reports each value of three channels in a scene with curves.
  void refuse_channels() const;

 private:
  struct Channels {
    Problems* problems;
    const PresetValue* value;
    std::string pointer;
  };

  bool any_ = false;
  std::string first_;  // the pointer of a curve
  std::vector<Channels> channels_;
};

// Lines for people: curves whose samples end inside what the eye sees.
std::vector<std::string> curve_warnings(const Scene& scene);

}  // namespace airlight
