#include "app/render/usd_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/output/atomic_file.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

std::string vector_text(const Vector3& v) {
  return "(" + rounded(v[0], 9) + ", " + rounded(v[1], 9) + ", " + rounded(v[2], 9) + ")";
}

using Skies = std::span<const UsdSample>;

// An attribute with one value, or with a sample for each sky.
std::string attribute(const std::string& name, Skies skies,
                      const std::function<std::string(const UsdSample&)>& value_of) {
  const std::string start = "        " + name;
  if (skies.size() == 1) {
    return start + " = " + value_of(skies.front()) + "\n";
  }
  std::string text = start + ".timeSamples = {\n";
  for (const UsdSample& sky : skies) {
    text += "            " + std::to_string(sky.frame) + ": " + value_of(sky) + ",\n";
  }
  return text + "        }\n";
}

double greatest(const SunLight& light) {
  return std::max(0.0, *std::ranges::max_element(light.irradiance));
}

// The irradiance over its greatest channel. A colour outside Rec.709 is cut to it: no renderer takes a negative one.
Vector3 colour_of(const SunLight& light) {
  const double most = greatest(light);
  Vector3 colour{1.0, 1.0, 1.0};
  for (std::size_t c = 0; most > 0.0 && c < 3; ++c) {
    colour[c] = std::max(0.0, light.irradiance[c] / most);
  }
  return colour;
}

// The angles without jumps of a whole turn, so that what lies between two samples is between their directions.
std::vector<double> unwound(std::vector<double> degrees) {
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    degrees[i] = degrees[i - 1] + std::remainder(degrees[i] - degrees[i - 1], 360.0);
  }
  return degrees;
}

// Degrees turn +z toward where the light comes from.
std::string distant_light(const std::string& name, Skies skies,
                          const std::function<const SunLight&(const UsdSample&)>& light_of) {
  std::vector<double> turns;
  for (const UsdSample& sky : skies) {
    turns.push_back(180.0 - degrees_from_radians(light_of(sky).azimuth));
  }
  turns = unwound(turns);
  const auto rotation = [&](const UsdSample& sky) {
    const double up = degrees_from_radians(light_of(sky).elevation);
    return vector_text({-up, turns[static_cast<std::size_t>(&sky - skies.data())], 0.0});
  };
  const auto of = [&](const auto& text_of) {
    return [&light_of, text_of](const UsdSample& sky) { return text_of(light_of(sky)); };
  };
  return "    def DistantLight \"" + name + "\"\n    {\n" +
         attribute("float inputs:angle", skies,
                   of([](const SunLight& l) { return rounded(2.0 * degrees_from_radians(l.angular_radius), 9); })) +
         attribute("color3f inputs:color", skies, of([](const SunLight& l) { return vector_text(colour_of(l)); })) +
         attribute("float inputs:intensity", skies, of([](const SunLight& l) { return rounded(greatest(l), 9); })) +
         "        bool inputs:normalize = 1\n" + attribute("float3 xformOp:rotateXYZ", skies, rotation) +
         "        uniform token[] xformOpOrder = [\"xformOp:rotateXYZ\"]\n    }\n";
}

std::string dome_light(Skies skies) {
  std::vector<double> turns;
  for (const UsdSample& sky : skies) {
    turns.push_back(180.0 - degrees_from_radians(sky.azimuth));
  }
  turns = unwound(turns);
  const bool still = std::ranges::all_of(turns, [&](double turn) { return turn == turns.front(); });
  return "    def DomeLight \"dome\"\n    {\n        float inputs:intensity = 1\n" +
         attribute("asset inputs:texture:file", skies, [](const UsdSample& sky) { return "@" + sky.exr + "@"; }) +
         "        token inputs:texture:format = \"latlong\"\n" +
         attribute(
             "float xformOp:rotateY", still ? skies.first(1) : skies,
             [&](const UsdSample& sky) { return rounded(turns[static_cast<std::size_t>(&sky - skies.data())], 9); }) +
         "        uniform token[] xformOpOrder = [\"xformOp:rotateY\"]\n    }\n\n";
}

}  // namespace

void require_latlong_dome(const Scene& scene, const PictureOptions& options, const std::string& command) {
  if (!is_latlong(scene)) {
    throw InputError(command +
                     ": --usd: a dome light takes a picture of the whole sky, twice as wide as high, and this one "
                     "is none; give --projection latlong");
  }
  if (working_space_of(options) != WorkingSpace::linear_rec709) {
    throw InputError(command + ": --usd: USD takes a light's colours as linear Rec.709; leave out --colorspace");
  }
}

void require_dome(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  if (targets.exr.empty() || given.cube_faces || targets.exr.starts_with("/dev/")) {
    throw InputError(
        "render: --usd: the stage names the EXR of the whole sky, and none is written to a file; give "
        "-o FILE.exr, without --cube-faces");
  }
  require_latlong_dome(scene, given.picture, "render");
}

std::string exr_from_stage(const std::string& stage, const std::string& exr) {
  const fs::path folder = fs::absolute(stage).lexically_normal().parent_path();
  const std::string path = fs::absolute(exr).lexically_normal().lexically_relative(folder).string();
  return path.starts_with("..") ? path : "./" + path;
}

std::string usd_text(std::span<const UsdSample> skies, const std::string& up, const std::string& doc,
                     int frames_a_second) {
  std::string text = "#usda 1.0\n(\n    defaultPrim = \"sky\"\n    doc = " + json_string(doc) + "\n";
  if (skies.size() > 1) {
    const std::string rate = std::to_string(frames_a_second);
    text += "    endTimeCode = " + std::to_string(skies.back().frame) + "\n    framesPerSecond = " + rate + "\n";
    text += "    metersPerUnit = 1\n    startTimeCode = " + std::to_string(skies.front().frame) +
            "\n    timeCodesPerSecond = " + rate + "\n";
  } else {
    text += "    metersPerUnit = 1\n";
  }
  text += std::string("    upAxis = \"") + (up == "z" ? "Z" : "Y") + "\"\n)\n\ndef Xform \"sky\"\n{\n";
  if (up == "z") {
    text += "    float xformOp:rotateX = 90\n    uniform token[] xformOpOrder = [\"xformOp:rotateX\"]\n\n";
  }
  const auto sun_of = [](const UsdSample& sky) -> const SunLight& { return sky.sun; };
  text += dome_light(skies) + distant_light("sun", skies, sun_of);
  const auto lit = std::ranges::find_if(skies, [](const UsdSample& sky) { return sky.moon.has_value(); });
  if (lit == skies.end()) {
    return text + "}\n";
  }
  // A frame may leave out a moon far below the horizon.
  SunLight dark = *lit->moon;
  dark.irradiance = {};
  const auto moon_of = [&](const UsdSample& sky) -> const SunLight& { return sky.moon ? *sky.moon : dark; };
  return text + "\n" + distant_light("moon", skies, moon_of) + "}\n";
}

std::string write_usd(const RenderOrder& given, const Lighting& lighting, const PictureContext& context) {
  const UsdSample sky{0, exr_from_stage(*given.usd, *given.exr), context.scene.camera.azimuth, lighting.sun,
                      lighting.moon};
  const std::string doc = "airlight " + context.provenance.version + ", " + context.scene.name;
  write_file(*given.usd, usd_text({&sky, 1}, given.up, doc));
  return *given.usd;
}

}  // namespace airlight::cli
