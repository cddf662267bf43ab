#include "app/render/cube_faces.h"

#include <array>
#include <filesystem>
#include <numbers>

#include "core/error.h"
#include "core/scene/rules.h"

namespace airlight::cli {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

// From a cube's axes (shaders/physics/environment.glsl) to the camera that looks along one: +X lies to the left of the
// cube's azimuth; above and below, the upper edge is that of a camera that looks back.
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

// The index-th of six equal parts, from above.
template <class T>
std::vector<T> part_of(const std::vector<T>& whole, std::size_t index) {
  const auto length = static_cast<std::ptrdiff_t>(whole.size() / kFaces.size());
  const auto first = whole.begin() + length * static_cast<std::ptrdiff_t>(index);
  return {first, first + length};
}

RadianceImage face_of(const RadianceImage& stack, std::size_t index) {
  return {stack.width, stack.width, part_of(stack.rgba, index)};
}

// Plane by plane.
Layer face_of(const Layer& stack, std::size_t index) {
  Layer face = stack.like();
  const std::size_t plane = stack.planes.size() / stack.channels.size();
  for (std::size_t c = 0; c < stack.channels.size(); ++c) {
    const auto first = stack.planes.begin() + static_cast<std::ptrdiff_t>(c * plane);
    const std::vector<float> part =
        part_of(std::vector<float>(first, first + static_cast<std::ptrdiff_t>(plane)), index);
    face.planes.insert(face.planes.end(), part.begin(), part.end());
  }
  return face;
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

std::vector<CubeFace> cube_faces(const Scene& scene, const Rendering& rendering) {
  std::vector<CubeFace> faces;
  for (std::size_t i = 0; i < kFaces.size(); ++i) {
    CubeFace face{kFaces[i].name, scene, {}};
    face.scene.camera.projection = Projection::perspective;
    face.scene.camera.azimuth += kFaces[i].turn;
    face.scene.camera.pitch = kFaces[i].pitch;
    face.scene.camera.vertical_fov = kQuarter;
    face.scene.image.height = scene.image.width;
    face.rendering.radiance = face_of(rendering.radiance, i);
    if (rendering.standard_error) {
      face.rendering.standard_error = face_of(*rendering.standard_error, i);
    }
    for (const Layer& layer : rendering.layers) {
      face.rendering.layers.push_back(face_of(layer, i));
    }
    face.rendering.encoded = part_of(rendering.encoded, i);
    face.rendering.exposure = rendering.exposure;
    face.rendering.picture = rendering.picture;
    face.rendering.tables_statistics = rendering.tables_statistics;
    face.rendering.left_out = rendering.left_out;
    faces.push_back(std::move(face));
  }
  return faces;
}

std::string face_file(const std::string& file, const std::string& face) {
  if (file.empty()) {
    return file;
  }
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "." + face + path.extension().string())).string();
}

}  // namespace airlight::cli
