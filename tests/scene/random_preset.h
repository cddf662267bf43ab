#pragma once
// Valid presets by a seed, as JSON text, the same on every machine: for tests of scenes that nobody thought of.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

namespace airlight::test {

struct RandomPresetOptions {
  int largest_side = 48;    // pixels
  bool method_keys = true;  // some `render.*` keys of `method`; false: the defaults alone
  std::string_view method = "march";
  bool bends_light = false;  // half of the presets have refraction; all else is as without
};

class RandomPreset {
 public:
  explicit RandomPreset(std::uint64_t seed, const RandomPresetOptions& options = {})
      : random_(seed), bending_(seed + 1'000'000), options_(options) {}

  std::string text() {
    std::ostringstream out;
    out.precision(17);
    out << R"({"airlight": 1, "name": "random", "planet": )" << planet() << R"(, "media": )" << media()
        << R"(, "sun": )" << sun() << R"(, "camera": )" << camera() << R"(, "image": )" << image();
    if (options_.method_keys && chance(0.5)) {
      out << R"(, "render": )" << render();
    }
    if (chance(0.5)) {
      out << R"(, "bloom": {"enabled": )" << (chance(0.5) ? "true" : "false") << R"(, "levels": )" << integer(1, 8)
          << "}";
    }
    if (chance(0.5)) {
      out << R"(, "display": {"exposure": )" << exposure() << R"(, "compensation_ev": )" << integer(-3, 3) << "}";
    }
    out << "}";
    return out.str();
  }

 private:
  std::string exposure() {
    constexpr std::array<std::string_view, 3> kMeters = {"\"auto\"", "\"day\"", "\"lock:7\""};
    return chance(0.5) ? std::string(pick(kMeters)) : text_of(log_uniform(0.01, 100));
  }
  // The standard's distributions differ from library to library; its engines do not.
  double uniform(double low, double high) {
    const double unit = static_cast<double>(random_() >> 11U) * 0x1p-53;
    return low + (high - low) * unit;
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  int integer(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  template <std::size_t N>
  std::string_view pick(const std::array<std::string_view, N>& names) {
    return names[random_() % N];
  }

  static std::string text_of(double value) {
    std::ostringstream out;
    out.precision(17);
    out << value;
    return out.str();
  }

  // One number or three, some of them 0.
  std::string spectrum(double low, double high) {
    if (chance(0.1)) {
      return "0";
    }
    if (chance(0.4)) {
      return text_of(log_uniform(low, high));
    }
    return "[" + text_of(log_uniform(low, high)) + ", " + text_of(log_uniform(low, high)) + ", " +
           (chance(0.1) ? "0" : text_of(log_uniform(low, high))) + "]";
  }

  std::string planet() {
    const double radius = chance(0.5) ? 6360 : log_uniform(100, 1e6);
    atmosphere_ = chance(0.5) ? 100 : radius * log_uniform(0.002, 0.1);
    return R"({"radius_km": )" + text_of(radius) + R"(, "atmosphere_height_km": )" + text_of(atmosphere_) +
           R"(, "ground_albedo": )" + (chance(0.2) ? "1" : spectrum(0.01, 1)) + refraction(radius) + "}";
  }

  // By numbers of its own. A level ray at the ground is bent by 2 to 50 % of the planet's curvature; Earth's by 21.
  std::string refraction(double radius) {
    const auto unit = [this] { return static_cast<double>(bending_() >> 11U) * 0x1p-53; };
    if (!options_.bends_light || unit() < 0.5) {
      return "";
    }
    const double height = atmosphere_ * (0.04 + 0.11 * unit());
    const double n_minus_1 = std::min(0.01, (0.02 + 0.48 * unit()) * height / radius);
    return R"(, "refraction": {"n_minus_1": )" + text_of(n_minus_1) + R"(, "scale_height_km": )" + text_of(height) +
           "}";
  }

  std::string density() {
    const std::string scale = text_of(atmosphere_ * log_uniform(0.005, 0.3));
    const std::string center = text_of(atmosphere_ * uniform(0, 0.9));
    const std::string width = text_of(atmosphere_ * log_uniform(0.01, 0.5));
    switch (integer(0, 4)) {
      case 0:
        return R"({"profile": "exponential", "scale_height_km": )" + scale + "}";
      case 1:
        return R"({"profile": "tent", "center_km": )" + center + R"(, "half_width_km": )" + width + "}";
      case 2:
        return R"({"profile": "lorentzian", "center_km": )" + center + R"(, "half_width_km": )" + width +
               R"(, "scale_height_km": )" + scale + "}";
      case 3:
        return R"({"profile": "constant", "below_km": )" + text_of(atmosphere_ * log_uniform(0.01, 1.5)) + "}";
      default:
        return R"({"profile": "layers", "layers": )" + layers() + "}";
    }
  }

  std::string layers() {
    std::string text;
    double altitude = chance(0.5) ? 0 : atmosphere_ * uniform(0, 0.1);
    for (int count = integer(1, 8); count > 0; --count) {
      text +=
          (text.empty() ? "[" : ", [") + text_of(altitude) + ", " + (chance(0.2) ? "0" : text_of(uniform(0, 1))) + "]";
      altitude += atmosphere_ * uniform(0.01, 0.2);
    }
    return "[" + text + "]";
  }

  std::string media() {
    static constexpr std::array<std::string_view, 5> kPhases = {"rayleigh", "henyey-greenstein", "cornette-shanks",
                                                                "schlick", "isotropic"};
    std::string text;
    const int count = integer(1, 8);
    for (int i = 0; i < count; ++i) {
      // The total vertical optical depth is about 1e-3 to 3.
      const double strength = 10.0 / (atmosphere_ * count);
      text += (text.empty() ? "" : ", ") + (R"({"name": "medium )" + std::to_string(i)) +
              R"(", "scattering_per_km": )" + spectrum(1e-3 * strength, strength) + R"(, "absorption_per_km": )" +
              spectrum(1e-4 * strength, 0.3 * strength) + R"(, "density": )" + density() +
              R"(, "phase": {"function": ")" + std::string(pick(kPhases)) + R"(", "g": )" +
              text_of(chance(0.1) ? 0.99 : uniform(-0.9, 0.95)) + "}}";
    }
    return "[" + text + "]";
  }

  std::string sun() {
    return R"({"elevation_deg": )" + text_of(chance(0.1) ? 0 : uniform(-90, 90)) + R"(, "azimuth_deg": )" +
           text_of(uniform(-360, 360)) + R"(, "irradiance": )" + spectrum(0.1, 2000) + R"(, "disc": {"visible": )" +
           (chance(0.7) ? "true" : "false") + R"(, "angular_radius_deg": )" + text_of(log_uniform(0.05, 10)) +
           R"(, "limb_darkening": )" + text_of(uniform(0, 1)) + "}}";
  }

  std::string camera() {
    const std::string place = R"({"altitude_km": )" + text_of(altitude()) + R"(, "azimuth_deg": )" +
                              text_of(uniform(-360, 360)) + R"(, "projection": )";
    const std::string tilt =
        R"(, "pitch_deg": )" + text_of(uniform(-90, 90)) + R"(, "roll_deg": )" + text_of(uniform(-180, 180)) + "}";
    switch (integer(0, 2)) {
      case 0:
        return place + R"("perspective", "vertical_fov_deg": )" + text_of(uniform(1, 170)) + tilt;
      case 1:
        return place + R"("fisheye", "vertical_fov_deg": )" + text_of(uniform(10, 360)) + tilt;
      default:
        return place + R"("equirectangular"})";
    }
  }

  // On the ground, in the air, at its top, in space.
  double altitude() {
    switch (integer(0, 4)) {
      case 0:
        return 0;
      case 1:
        return atmosphere_;
      case 2:
        return atmosphere_ * uniform(1, 20);
      default:
        return atmosphere_ * log_uniform(1e-6, 1);
    }
  }

  std::string image() {
    return R"({"width": )" + std::to_string(integer(1, options_.largest_side)) + R"(, "height": )" +
           std::to_string(integer(1, options_.largest_side)) + "}";
  }

  std::string render() {
    return R"({"method": ")" + std::string(options_.method) + R"(", "steps": )" + std::to_string(integer(1, 64)) +
           R"(, "multiple_scattering_scale": )" + (chance(0.3) ? "0" : text_of(uniform(0, 2))) + "}";
  }

  std::mt19937_64 random_;
  std::mt19937_64 bending_;
  RandomPresetOptions options_;
  double atmosphere_ = 100.0;
};

inline std::string random_preset(std::uint64_t seed, const RandomPresetOptions& options = {}) {
  return RandomPreset(seed, options).text();
}

}  // namespace airlight::test
