#include "app/render/radiance_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/output/atomic_file.h"
#include "core/output/picture_rows.h"
#include "core/scene/angle.h"
#include "core/scene/photometry.h"
#include "core/scene/printable.h"

namespace airlight::cli {
namespace {

constexpr double kEfficacy = 179.0;  // lm/W, of all light in Radiance

// Rec.709 with D65 to primaries (0.640 0.330), (0.290 0.600), (0.150 0.060) with the white (1/3 1/3), by XYZ; no
// adaptation of the white.
constexpr std::array<Vector3, 3> kFromRec709 = {
    {{0.802091051, 0.0353266636, 0.0}, {0.0, 1.05454205, 0.0}, {0.0, -0.0131411150, 1.11427910}}};

constexpr std::size_t kFewestComponents = 4;
constexpr std::size_t kMostComponents = 24;
constexpr double kBlueEnd = 480.0;   // nm, where Radiance's blue ends by default
constexpr double kGreenEnd = 588.0;  // and its green

// nm from the first band's start to the last one's end; wavelengths are the middles of bands that touch.
struct Span {
  double from;
  double to;
};
Span span_of(const std::vector<double>& nm) {
  const double half = 0.5 * (nm[1] - nm[0]);
  return {nm.front() - half, nm.back() + half};
}

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += " " + rounded(number, 9);
  }
  return text;
}

// A source in Radiance's axes, of `material`.
std::string source_text(const std::string& material, const std::string& name, const SunLight& light) {
  const std::vector<double> place{light.direction[0], -light.direction[2], light.direction[1],
                                  2.0 * degrees_from_radians(light.angular_radius)};
  return material + " source " + name + "\n0\n0\n4" + numbers_text(place) + "\n\n";
}

double solid_angle_of(const SunLight& light) {
  return 2.0 * std::numbers::pi * (1.0 - std::cos(light.angular_radius));
}

std::string coloured_light(const std::string& name, const SunLight& light, double luminance) {
  const Vector3 colour = radiance_colour(light.irradiance, luminance);
  if (!(*std::ranges::max_element(colour) > 0.0)) {
    return "# The " + name + " gives no light.\n";
  }
  std::vector<double> radiance;
  for (const double channel : colour) {
    radiance.push_back(channel / solid_angle_of(light));
  }
  return "void light " + name + "light\n0\n0\n3" + numbers_text(radiance) + "\n\n" +
         source_text(name + "light", name, light);
}

std::string spectral_light(const std::string& name, const SunLight& light, const SpectralImage& spectrum,
                           const std::vector<double>& irradiance) {
  if (!(*std::ranges::max_element(irradiance) > 0.0)) {
    return "# The " + name + " gives no light.\n";
  }
  const Span span = span_of(spectrum.nm);
  std::vector<double> numbers{span.from, span.to};
  for (const double value : irradiance) {
    numbers.push_back(value * (span.to - span.from) / solid_angle_of(light));
  }
  return "void spectrum " + name + "spectrum\n0\n0\n" + std::to_string(numbers.size()) + numbers_text(numbers) +
         "\n\n" + name + "spectrum light " + name + "light\n0\n0\n3 1 1 1\n\n" +
         source_text(name + "light", name, light);
}

// Ward's shared exponent for many components. Radiance reads the middle of a mantissa's step, so they are cut off.
void add_components(std::vector<std::byte>& out, const std::vector<double>& values) {
  int exponent = 0;
  const double most = *std::ranges::max_element(values);
  std::frexp(most, &exponent);
  const bool is_dark = !(most > 0.0) || exponent < -127;
  for (const double value : values) {
    const double mantissa = is_dark ? 0.0 : std::ldexp(std::max(0.0, value), 8 - exponent);
    out.push_back(static_cast<std::byte>(std::min(255.0, mantissa)));
  }
  out.push_back(static_cast<std::byte>(is_dark ? 0 : exponent + 128));
}

std::vector<std::byte> spectral_picture(const SpectralImage& spectrum, int width, int height) {
  const Span span = span_of(spectrum.nm);
  const std::string head = "#?RADIANCE\nNCOMP=" + std::to_string(spectrum.nm.size()) +
                           "\nWAVELENGTH_SPLITS=" + numbers_text({span.from, kBlueEnd, kGreenEnd, span.to}) +
                           "\nFORMAT=Radiance_spectra\n\n-Y " + std::to_string(height) + " +X " +
                           std::to_string(width) + "\n";
  const auto text = std::as_bytes(std::span(head));
  std::vector<std::byte> out(text.begin(), text.end());
  std::vector<double> values(spectrum.nm.size());
  for (std::size_t i = 0; i < spectrum.planes.front().size(); ++i) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = static_cast<double>(spectrum.planes[k][i]) * (span.to - span.from);
    }
    add_components(out, values);
  }
  return out;
}

std::vector<std::byte> coloured_picture(const RadianceImage& sky, double luminance) {
  RadianceImage colours = sky;
  for (std::size_t i = 0; i < colours.rgba.size(); i += 4) {
    const float* const rgb = &sky.rgba[i];
    const Vector3 colour = radiance_colour(
        {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])}, luminance);
    std::ranges::transform(colour, colours.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                           [](double channel) { return static_cast<float>(channel); });
  }
  std::vector<std::byte> bytes;
  const auto rows = picture_rows(
      "sky.hdr", [&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); },
      colours.width, colours.height);
  rows->add(colours);
  rows->finish();
  return bytes;
}

}  // namespace

Vector3 radiance_colour(const Vector3& rec709, double luminance_of_one) {
  Vector3 colour{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      colour[row] += kFromRec709[row][c] * rec709[c] * luminance_of_one / kEfficacy;
    }
    colour[row] = std::max(0.0, colour[row]);
  }
  return colour;
}

std::string radiance_picture_file(const std::string& rad, bool spectral) {
  return std::filesystem::path(rad).replace_extension(spectral ? ".hsr" : ".hdr").string();
}

void require_components(const Nodes& nodes) {
  const std::vector<double>& nm = nodes.nm;
  if (nm.size() < kFewestComponents || nm.size() > kMostComponents) {
    throw InputError("render: --radiance: " + std::to_string(nm.size()) +
                     " wavelengths; Radiance takes 4 to 24: write for example --spectral 390:770:20");
  }
  if (const Span span = span_of(nm); !(span.from < kBlueEnd && span.to > kGreenEnd)) {
    throw InputError("render: --radiance: bands from " + rounded(span.from, 4) + " to " + rounded(span.to, 4) +
                     " nm; Radiance's colours need some below 480 and some above 588: write for example --spectral "
                     "390:770:20");
  }
}

std::string radiance_text(const std::string& picture, const RadianceSky& sky, const Lighting& lighting,
                          const PictureContext& context) {
  const double luminance = luminance_of_one(context.scene);
  const bool spectral = sky.whole.spectrum.has_value();
  std::string text = "# airlight " + context.provenance.version + ", " + printable(context.scene.name) +
                     "\n# x east, y north, z up; W/(m2 sr). The picture is sky and ground, without discs.\n\n" +
                     (spectral ? "void specpict skylight\n5 noop " : "void colorpict skylight\n7 red green blue ") +
                     "\"" + picture + "\" . \"atan2(Dx,Dy)/PI+1\" \"1-Acos(Dz)/PI\"\n0\n0\n\n" +
                     "skylight glow skyglow\n0\n0\n4 1 1 1 0\n\nskyglow source sky\n0\n0\n4 0 0 1 360\n\n";
  if (spectral) {
    return text + spectral_light("sun", lighting.sun, *sky.whole.spectrum, sky.sun_spectrum) +
           (lighting.moon ? "# The moon's disc is left out of spectra.\n" : "");
  }
  text += coloured_light("sun", lighting.sun, luminance);
  return text + (lighting.moon ? coloured_light("moon", *lighting.moon, luminance) : "");
}

std::vector<std::string> write_radiance(const std::string& rad, const RadianceSky& sky, const Lighting& lighting,
                                        const PictureContext& context) {
  const RadianceImage& colours = sky.whole.radiance;
  const std::string picture = radiance_picture_file(rad, sky.whole.spectrum.has_value());
  write_file(picture, sky.whole.spectrum ? spectral_picture(*sky.whole.spectrum, colours.width, colours.height)
                                         : coloured_picture(colours, luminance_of_one(context.scene)));
  write_file(rad, radiance_text(std::filesystem::path(picture).filename().string(), sky, lighting, context));
  return {rad, picture};
}

}  // namespace airlight::cli
