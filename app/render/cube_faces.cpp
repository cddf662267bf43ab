#include "app/render/cube_faces.h"

#include <array>
#include <filesystem>
#include <numbers>

#include "core/base/error.h"
#include "core/scene/rules.h"

namespace airlight::cli {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

// From a cube's axis (shaders/physics/environment.glsl) to the camera that looks along it. +X lies to the left of the
// cube's azimuth. The upper edges of the faces above and below are those of a camera that looks back.
struct Face {
  const char* name;
  double turn;  // added to the azimuth
  double pitch;
};
constexpr std::array<Face, 6> kFaces = {{{"posx", -kQuarter, 0.0},
                                         {"negx", kQuarter, 0.0},
                                         {"posy", 2.0 * kQuarter, kQuarter},
                                         {"negy", 2.0 * kQuarter, -kQuarter},
                                         {"posz", 0.0, 0.0},
                                         {"negz", 2.0 * kQuarter, 0.0}}};

std::string file_of(const std::string& file, const Face& face) {
  const std::filesystem::path path(file);
  return file.empty()
             ? file
             : (path.parent_path() / (path.stem().string() + "." + face.name + path.extension().string())).string();
}

}  // namespace

void require_cube_stack(const Scene& scene) {
  if (scene.camera.projection == Projection::cube && scene.camera.cube_layout == CubeLayout::stack) {
    return;
  }
  const std::string found =
      scene.camera.projection == Projection::cube
          ? "/camera/cube_layout is " +
                std::string(kCubeLayoutNames.at(static_cast<std::size_t>(scene.camera.cube_layout)))
          : "/camera/projection is " +
                std::string(kProjectionNames.at(static_cast<std::size_t>(scene.camera.projection)));
  throw InputError("render: --cube-faces: " + found +
                   "; it needs --set /camera/projection=cube in the layout stack, and a size such as --size 512x3072");
}

std::vector<PicturePart> face_parts(const Scene& scene, const Targets& files) {
  std::vector<PicturePart> parts;
  for (const Face& face : kFaces) {
    PicturePart part{scene,
                     static_cast<int>(parts.size()) * scene.image.width,
                     {file_of(files.exr, face), file_of(files.png, face), {}, file_of(files.other, face)}};
    Camera& camera = part.scene.camera;
    camera.projection = Projection::perspective;
    camera.azimuth += face.turn;
    camera.pitch = face.pitch;
    camera.vertical_fov = kQuarter;
    part.scene.image.height = scene.image.width;
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace airlight::cli
