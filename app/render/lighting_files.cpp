#include "app/render/lighting_files.h"

#include <cmath>
#include <filesystem>

#include "app/cli/json_writer.h"
#include "core/output/atomic_file.h"
#include "core/scene/angle.h"
#include "core/scene/photometry.h"

namespace airlight::cli {
namespace {

constexpr const char* kBasis =
    "real, orthonormal, no Condon-Shortley sign, up to degree 2, in the order Y00 Y1-1 Y10 Y11 Y2-2 Y2-1 Y20 Y21 Y22: "
    "0.282095; 0.488603 y, z, x; 1.092548 xy, yz; 0.315392 (3zz - 1); 1.092548 xz; 0.546274 (xx - yy)";
constexpr const char* kFrame = "x east, y up, z south, whatever the camera's azimuth";
constexpr const char* kCubeFrame =
    "the cube map's: x to the right of the camera's azimuth, y up, z back; x is east and z south where the camera "
    "looks north";
constexpr const char* kFormula =
    "E(n) = 3.141593 L00 Y00 + 2.094395 (L1-1 Y1-1 + L10 Y10 + L11 Y11) + 0.785398 (L2-2 Y2-2 + L2-1 Y2-1 + L20 Y20 + "
    "L21 Y21 + L22 Y22), each Y at the unit normal n (Ramamoorthi and Hanrahan 2001)";

std::string unit_of(const Scene& scene) {
  const std::string_view unit = irradiance_unit(scene.sun.unit);
  return unit.empty() ? "relative" : std::string(unit);
}

void write_light(JsonWriter& json, const std::string& name, const SunLight& sun, WorkingSpace space) {
  json.key(name).begin_object();
  json.key("direction").values(sun.direction);
  json.key("elevation_deg").value(degrees_from_radians(sun.elevation));
  json.key("azimuth_deg").value(degrees_from_radians(sun.azimuth));
  json.key("angular_radius_deg").value(degrees_from_radians(sun.angular_radius));
  json.key("irradiance").values(in_space(sun.irradiance, space));
  json.key("irradiance_above_air").values(in_space(sun.irradiance_above_air, space));
  json.key("visible_share").value(sun.visible_share);
  json.key("meaning").value(
      "irradiance on a plane that faces the " + name +
      ", of the disc through the air, as far as the planet leaves it; not in the map and not in the harmonics");
  json.end_object();
}

std::vector<std::byte> map_exr(const Lighting& lighting, const PictureContext& context) {
  const RadianceImage map = converted(lighting.irradiance, WorkingSpace::linear_rec709, context.space);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", map);
  ExrOptions options;
  options.half = false;
  options.latlong = true;
  options.space = context.space;
  options.provenance = context.provenance;
  options.strings = {{"airlight:quantity", "irradiance [" + unit_of(context.scene) +
                                               "] of a surface with this normal, without the sun's disc"}};
  return encode_exr(map.width, map.height, channels, options).bytes;
}

}  // namespace

std::string lighting_json_file(const std::string& exr) {
  return std::filesystem::path(exr).replace_extension(".json").string();
}

namespace {

// `frame`: the axes that the lighting's directions and harmonics are in. They are already.
std::string json_in(const Lighting& lighting, const PictureContext& context, const char* frame) {
  JsonWriter json;
  json.begin_object();
  json.key("name").value(context.scene.name);
  json.key("irradiance_unit").value(unit_of(context.scene));
  json.key("colorspace").value(working_space_names()[static_cast<std::size_t>(context.space)]);
  json.key("frame").value(frame);
  json.key("spherical_harmonics").begin_object();
  json.key("of").value("radiance of sky and ground around the camera's place, without the sun's disc");
  json.key("basis").value(kBasis);
  json.key("irradiance").value(kFormula);
  json.key("coefficients").begin_array();
  for (const Vector3& rgb : lighting.sh) {
    json.values(in_space(rgb, context.space));
  }
  json.end_array().end_object();
  write_light(json, "sun", lighting.sun, context.space);
  if (lighting.moon) {
    write_light(json, "moon", *lighting.moon, context.space);
  }
  return json.end_object().take();
}

// A light in the axes of a cube map whose picture's middle is at `azimuth`.
SunLight light_in_cube(SunLight light, double azimuth) {
  const auto [x, y, z] = light.direction;
  light.direction = {std::cos(azimuth) * x + std::sin(azimuth) * z, y, std::cos(azimuth) * z - std::sin(azimuth) * x};
  return light;
}

}  // namespace

std::string lighting_json(const Lighting& lighting, const PictureContext& context) {
  return json_in(lighting, context, kFrame);
}

std::string cube_light_file(const std::string& cube) {
  return std::filesystem::path(cube).replace_extension(".light.json").string();
}

std::string write_cube_light(const std::string& cube, const Lighting& lighting, const PictureContext& context) {
  const double azimuth = context.scene.camera.azimuth;
  Lighting seen = lighting;
  seen.sh = turned(lighting.sh, azimuth);
  seen.sun = light_in_cube(lighting.sun, azimuth);
  if (lighting.moon) {
    seen.moon = light_in_cube(*lighting.moon, azimuth);
  }
  const std::string file = cube_light_file(cube);
  write_file(file, json_in(seen, context, kCubeFrame));
  return file;
}

std::vector<std::string> write_lighting(const std::string& exr, const Lighting& lighting,
                                        const PictureContext& context) {
  const std::vector<std::byte> map = map_exr(lighting, context);
  const std::string json = lighting_json(lighting, context);
  const std::string json_file = lighting_json_file(exr);
  write_file(exr, map);
  write_file(json_file, json);
  return {exr, json_file};
}

}  // namespace airlight::cli
