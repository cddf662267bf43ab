#include "app/render/usd_file.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/text.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

std::string vector_text(const Vector3& v) {
  return "(" + rounded(v[0], 9) + ", " + rounded(v[1], 9) + ", " + rounded(v[2], 9) + ")";
}

// A distant light whose colour's greatest channel is 1. A colour outside Rec.709 is cut to it: no renderer takes a
// negative one. Degrees turn +z toward where the light comes from.
std::string distant_light(const std::string& name, const SunLight& light, WorkingSpace space) {
  const Vector3 irradiance = in_space(light.irradiance, space);
  const double most = *std::ranges::max_element(irradiance);
  Vector3 colour{1.0, 1.0, 1.0};
  for (std::size_t c = 0; most > 0.0 && c < 3; ++c) {
    colour[c] = std::max(0.0, irradiance[c] / most);
  }
  return "    def DistantLight \"" + name + "\"\n    {\n" +
         "        float inputs:angle = " + rounded(2.0 * degrees_from_radians(light.angular_radius), 9) + "\n" +
         "        color3f inputs:color = " + vector_text(colour) + "\n" +
         "        float inputs:intensity = " + rounded(std::max(0.0, most), 9) + "\n" +
         "        bool inputs:normalize = 1\n" + "        float3 xformOp:rotateXYZ = (" +
         rounded(-degrees_from_radians(light.elevation), 9) + ", " +
         rounded(180.0 - degrees_from_radians(light.azimuth), 9) + ", 0)\n" +
         "        uniform token[] xformOpOrder = [\"xformOp:rotateXYZ\"]\n    }\n";
}

}  // namespace

void require_dome(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  if (targets.exr.empty() || given.cube_faces || targets.exr.starts_with("/dev/")) {
    throw InputError(
        "render: --usd: the stage names the EXR of the whole sky, and none is written to a file; give "
        "-o FILE.exr, without --cube-faces");
  }
  if (!is_latlong(scene)) {
    throw InputError(
        "render: --usd: a dome light takes a picture of the whole sky, twice as wide as high, and this one "
        "is none; give --projection latlong");
  }
  if (working_space_of(given.picture) != WorkingSpace::linear_rec709) {
    throw InputError("render: --usd: USD takes a light's colours as linear Rec.709; leave out --colorspace");
  }
}

std::string usd_text(const std::string& exr, const std::string& up, const Lighting& lighting,
                     const PictureContext& context) {
  const Camera& camera = context.scene.camera;
  std::string text = "#usda 1.0\n(\n    defaultPrim = \"sky\"\n    doc = " +
                     json_string("airlight " + context.provenance.version + ", " + context.scene.name) +
                     "\n    metersPerUnit = 1\n    upAxis = \"" + (up == "z" ? "Z" : "Y") + "\"\n)\n\n" +
                     "def Xform \"sky\"\n{\n";
  if (up == "z") {
    text += "    float xformOp:rotateX = 90\n    uniform token[] xformOpOrder = [\"xformOp:rotateX\"]\n\n";
  }
  text +=
      "    def DomeLight \"dome\"\n    {\n        float inputs:intensity = 1\n        asset inputs:texture:file = @" +
      exr + "@\n        token inputs:texture:format = \"latlong\"\n        float xformOp:rotateY = " +
      rounded(180.0 - degrees_from_radians(camera.azimuth), 9) +
      "\n        uniform token[] xformOpOrder = [\"xformOp:rotateY\"]\n    }\n\n" +
      distant_light("sun", lighting.sun, context.space);
  if (lighting.moon) {
    text += "\n" + distant_light("moon", *lighting.moon, context.space);
  }
  return text + "}\n";
}

std::string write_usd(const RenderOrder& given, const Lighting& lighting, const PictureContext& context) {
  const fs::path stage = fs::absolute(*given.usd).lexically_normal();
  const std::string exr = fs::absolute(*given.exr).lexically_normal().lexically_relative(stage.parent_path()).string();
  write_file(*given.usd, usd_text(exr.starts_with("..") ? exr : "./" + exr, given.up, lighting, context));
  return *given.usd;
}

}  // namespace airlight::cli
