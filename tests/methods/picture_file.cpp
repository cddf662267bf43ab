#include "tests/methods/picture_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "core/measure/metrics.h"
#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

void collect(const PresetValue& value, const std::string& path, std::map<std::string, double>& numbers) {
  if (const auto* object = std::get_if<PresetObject>(&value.data)) {
    for (const auto& [key, member] : *object) {
      collect(member, path.empty() ? key : path + "/" + key, numbers);
    }
  } else if (const auto* number = std::get_if<double>(&value.data)) {
    numbers[path] = *number;
  }
}

std::vector<float> pooled(const RadianceImage& image) {
  std::vector<float> values;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = c; i < image.rgba.size(); i += 4) {
      values.push_back(image.rgba[i]);
    }
  }
  return values;
}

}  // namespace

std::optional<RadianceImage> read_layer(const std::filesystem::path& path, std::string_view layer) {
  Imf::InputFile file(path.c_str());
  const auto& box = file.header().dataWindow();
  RadianceImage image{box.max.x - box.min.x + 1, box.max.y - box.min.y + 1, {}};
  image.rgba.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 1.0f);
  constexpr std::size_t kPixel = 4 * sizeof(float);
  const std::size_t row = kPixel * static_cast<std::size_t>(image.width);
  Imf::FrameBuffer buffer;
  constexpr std::array<const char*, 3> kNames{"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string name = (layer.empty() ? "" : std::string(layer) + ".") + kNames[c];
    if (file.header().channels().findChannel(name) == nullptr) {
      return std::nullopt;
    }
    // OpenEXR counts from the data window's origin, which airlight leaves at 0, 0.
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(image.rgba.data() + c), kPixel, row));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(box.min.y, box.max.y);
  return image;
}

Scene scene_from_file(const std::filesystem::path& file) {
  return resolve(load_preset(file), method_infos());
}

std::map<std::string, double> numbers_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  std::map<std::string, double> numbers;
  collect(parse_preset(text.str(), file.string(), {}).root, "", numbers);
  return numbers;
}

RadianceImage without_edge(const Scene& scene, RadianceImage picture, const RadianceImage& reference) {
  physics::Physics p = make_physics(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto view = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
      const auto rays = p.pixel_rays(p.scene.planet, p.scene.camera, projection, x + 0.5, y + 0.5, view.direction);
      if (rays.count > 1) {
        const auto at =
            4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
        std::copy_n(reference.rgba.begin() + static_cast<std::ptrdiff_t>(at), 4,
                    picture.rgba.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
  }
  return picture;
}

std::vector<RegionError> region_errors(const Scene& scene, const RadianceImage& a, const RadianceImage& b) {
  const measure::Viewpoint view{scene.camera, scene.sun.elevation, scene.sun.azimuth, scene.planet.ground_radius};
  const std::vector<measure::RegionBits> pixels = measure::classify(view, {a.width, a.height, 0, 0, a.width, a.height});
  std::vector<measure::RegionBits> bits;
  std::vector<float> errors;
  const std::vector<float> all_a = pooled(a);
  const std::vector<float> all_b = pooled(b);
  for (std::size_t c = 0; c < 3; ++c) {
    bits.insert(bits.end(), pixels.begin(), pixels.end());
    // The floor is a share of the channel's own mean.
    const auto from = static_cast<std::ptrdiff_t>(c * pixels.size());
    const auto to = static_cast<std::ptrdiff_t>((c + 1) * pixels.size());
    const std::vector<float> channel_a(all_a.begin() + from, all_a.begin() + to);
    const std::vector<float> channel_b(all_b.begin() + from, all_b.begin() + to);
    const std::vector<float> relative = measure::relative_errors(channel_a, channel_b);
    errors.insert(errors.end(), relative.begin(), relative.end());
  }
  std::vector<RegionError> list;
  for (const measure::RegionName& region : measure::kRegions) {
    const measure::ErrorSummary s = measure::summarize(errors, {bits, region.region});
    if (s.count > 0) {
      list.push_back({std::string(region.name), s.count, s.mean, s.p50, s.p95, s.max});
    }
  }
  return list;
}

}  // namespace airlight::test
