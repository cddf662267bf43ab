#include "app/composite/foreground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/angle.h"

namespace airlight::cli {
namespace {

using foreign::Channel;
using foreign::Picture;

std::string layer_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::string last_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? channel : channel.substr(dot + 1);
}

std::string in_layer(const std::string& layer, const std::string& channel) {
  return layer.empty() ? channel : layer + "." + channel;
}

bool has_colours(const Picture& picture, const std::string& layer) {
  return picture.find(in_layer(layer, "R")) != nullptr && picture.find(in_layer(layer, "G")) != nullptr &&
         picture.find(in_layer(layer, "B")) != nullptr;
}

// The main picture, Blender's "Combined", or the only layer that has colours.
std::string beauty_layer(const Picture& picture, const std::string& wanted) {
  if (!wanted.empty()) {
    if (!has_colours(picture, wanted)) {
      throw InputError(picture.file + ": has no layer '" + wanted + "' of R, G and B; it has the channels " +
                       picture.channel_list());
    }
    return wanted;
  }
  if (has_colours(picture, "")) {
    return "";
  }
  std::vector<std::string> found;
  for (const Channel& channel : picture.channels) {
    const std::string layer = layer_of(channel.name);
    if (last_of(channel.name) == "R" && has_colours(picture, layer)) {
      if (lower(last_of(layer)) == "combined") {
        return layer;
      }
      found.push_back(layer);
    }
  }
  if (found.size() != 1) {
    throw InputError(picture.file +
                     (found.empty() ? ": has no channels R, G and B" : ": has several layers of colours") +
                     "; name one with --layer; it has " + picture.channel_list());
  }
  return found.front();
}

// Whether it is a depth channel: Z beside X and Y is a part of a vector.
bool is_depth(const Picture& picture, const std::string& name) {
  const std::string last = lower(last_of(name));
  const bool vector = picture.find(in_layer(layer_of(name), "X")) != nullptr;
  return (last == "z" && !vector) || last == "depth";
}

const Channel& depth_channel(const Picture& picture, const std::string& wanted) {
  std::vector<const Channel*> found;
  for (const Channel& channel : picture.channels) {
    if (wanted.empty() ? is_depth(picture, channel.name) : channel.name == wanted) {
      found.push_back(&channel);
    }
  }
  // A main Z has precedence over those of layers.
  for (const Channel* channel : found) {
    if (channel->name == "Z") {
      return *channel;
    }
  }
  if (found.size() != 1) {
    const std::string what = !wanted.empty() ? "has no channel '" + wanted + "'"
                             : found.empty() ? "has no depth channel"
                                             : "has several depth channels";
    const std::string remedy = !wanted.empty() || !found.empty() ? "name one with --depth FILE:CHANNEL"
                               : picture.is_airlight             ? "render it with --layers, which has depth.Z"
                                                                 : "render it with a depth pass (Z), or name the file "
                                                                   "and channel that have it with --depth FILE:CHANNEL";
    throw InputError(picture.file + ": " + what + "; " + remedy + "; it has " + picture.channel_list());
  }
  return *found.front();
}

WorkingSpace space_of(const CompositeOrder& order, const Picture& picture) {
  if (!order.beauty_colorspace.empty()) {
    return *working_space(order.beauty_colorspace);
  }
  if (!picture.chromaticities) {
    return WorkingSpace::linear_rec709;
  }
  const std::span<const std::string> names = working_space_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto space = static_cast<WorkingSpace>(i);
    const Chromaticities known = chromaticities_of(space);
    const bool same = std::equal(known.begin(), known.end(), picture.chromaticities->begin(),
                                 [](float a, float b) { return std::abs(a - b) < 1e-3F; });
    if (same) {
      return space;
    }
  }
  throw InputError(picture.file +
                   ": its primaries are none that airlight knows; say with --beauty-colorspace which of " +
                   joined(names) + " they are nearest to");
}

// Sets the file's camera if it is wanted and exists, else the preset's. Returns which one, for people.
std::string set_camera(const CompositeOrder& order, const Picture& picture, double unit, Scene& scene) {
  const bool there = picture.world_to_camera || picture.world_to_ndc;
  if (order.camera == "preset" || (order.camera == "auto" && !there)) {
    return "camera: the preset's";
  }
  const composite::UpAxis up = order.up == "z" ? composite::UpAxis::z : composite::UpAxis::y;
  const composite::FileCamera camera =
      composite::camera_of(picture.file, picture.world_to_camera, picture.world_to_ndc, up, unit);
  if (!(camera.altitude >= 0.0)) {
    throw InputError(picture.file + ": its camera stands " + std::to_string(-camera.altitude) +
                     " km below the ground; give --up z where z is up, or --camera preset");
  }
  scene.camera.altitude = camera.altitude;
  scene.camera.azimuth = camera.azimuth;
  scene.camera.pitch = is_map(scene.camera.projection) ? 0.0 : camera.pitch;
  scene.camera.roll = is_map(scene.camera.projection) ? 0.0 : camera.roll;
  if (camera.vertical_fov) {
    scene.camera.projection = Projection::perspective;
    scene.camera.vertical_fov = *camera.vertical_fov;
  }
  char text[160];
  std::snprintf(text, sizeof text, "camera: the file's, %.6g km high, azimuth %.4g", camera.altitude,
                camera.azimuth / kDegree + 0.0);
  std::string told = text;
  if (!is_map(scene.camera.projection)) {
    std::snprintf(text, sizeof text, ", pitch %.4g, roll %.4g, %s %.4g", camera.pitch / kDegree + 0.0,
                  camera.roll / kDegree + 0.0, camera.vertical_fov ? "field of view" : "the preset's field of view",
                  scene.camera.vertical_fov / kDegree);
    told += text;
  }
  return told;
}

composite::DepthKind kind_of(const CompositeOrder& order, const Picture& picture, const Scene& scene) {
  if (order.depth_kind != "auto") {
    return *composite::depth_kind(order.depth_kind);
  }
  const bool planar = scene.camera.projection == Projection::perspective && !picture.is_airlight;
  return planar ? composite::DepthKind::planar : composite::DepthKind::distance;
}

// Distance for an edge pixel that the depth's one sample missed: the mean of the covered pixels around it.
float distance_around(const std::vector<float>& distances, int width, int height, int x, int y) {
  double sum = 0.0;
  int count = 0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
      const float d =
          distances[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
      sum += d < composite::kSky ? static_cast<double>(d) : 0.0;
      count += d < composite::kSky ? 1 : 0;
    }
  }
  return count > 0 ? static_cast<float>(sum / count) : composite::kSky;
}

// For flat pictures: pixels without depth belong to the sky, and half-covered pixels get the edge's distance.
void settle_flat(Foreground& fore) {
  const std::vector<float> read = fore.distances;
  const int width = fore.picture.width;
  for (std::size_t i = 0; i < fore.things.size(); ++i) {
    composite::Thing& thing = fore.things[i];
    if (read[i] < composite::kSky) {
      continue;
    }
    if (fore.alpha.empty() || thing.alpha >= 1.0F) {
      fore.replaced += fore.alpha.empty() ? 0U : 1U;
      thing = {{}, 0.0F};
    } else if (thing.alpha > 0.0F) {
      fore.distances[i] =
          distance_around(read, width, fore.picture.height, static_cast<int>(i) % width, static_cast<int>(i) / width);
    }
  }
}

void index_samples(Foreground& fore) {
  for (std::size_t pixel = 0; pixel < fore.picture.samples.size(); ++pixel) {
    fore.pixel_of.insert(fore.pixel_of.end(), fore.picture.samples[pixel], static_cast<std::uint32_t>(pixel));
  }
}

std::vector<composite::Thing> things_of(const Foreground& fore, double scale) {
  std::array<const std::vector<float>*, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = &fore.picture.find(fore.colours[c])->values;
  }
  const std::vector<float>* alpha = fore.alpha.empty() ? nullptr : &fore.picture.find(fore.alpha)->values;
  RadianceImage image{static_cast<int>(rgb[0]->size()), 1, std::vector<float>(4 * rgb[0]->size())};
  for (std::size_t i = 0; i < rgb[0]->size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      image.rgba[4 * i + c] = static_cast<float>(scale * static_cast<double>((*rgb[c])[i]));
    }
    image.rgba[4 * i + 3] = alpha == nullptr ? 1.0F : std::clamp((*alpha)[i], 0.0F, 1.0F);
  }
  image = converted(std::move(image), fore.space, WorkingSpace::linear_rec709);
  std::vector<composite::Thing> things(rgb[0]->size());
  for (std::size_t i = 0; i < things.size(); ++i) {
    const float* v = &image.rgba[4 * i];
    things[i] = {{v[0], v[1], v[2]}, v[3]};
  }
  return things;
}

}  // namespace

DepthPlace depth_place(const std::string& text, const std::string& beauty) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || text.find('/', colon) != std::string::npos) {
    return {text.empty() ? beauty : text, ""};
  }
  return {colon == 0 ? beauty : text.substr(0, colon), text.substr(colon + 1)};
}

Foreground read_foreground(const CompositeOrder& order, const std::string& beauty, const std::string& depth,
                           Scene& scene) {
  Foreground fore;
  fore.picture = foreign::read_picture(beauty);
  const std::string layer = beauty_layer(fore.picture, order.layer);
  fore.colours = {in_layer(layer, "R"), in_layer(layer, "G"), in_layer(layer, "B")};
  fore.alpha = fore.picture.find(in_layer(layer, "A")) != nullptr ? in_layer(layer, "A") : "";
  fore.space = space_of(order, fore.picture);
  scene.image = {fore.picture.width, fore.picture.height};
  const double unit = unit_km(order.unit).value_or(fore.picture.is_airlight ? 1.0 : 1e-3);
  fore.camera = set_camera(order, fore.picture, unit, scene);

  const DepthPlace place = depth_place(depth, beauty);
  Picture other;
  const Picture* with_depth = &fore.picture;
  if (place.file != beauty) {
    other = foreign::read_picture(place.file);
    with_depth = &other;
  }
  if (with_depth->width != fore.picture.width || with_depth->height != fore.picture.height ||
      with_depth->deep != fore.picture.deep) {
    throw InputError(place.file + ": is " + (with_depth->deep ? "deep, " : "flat, ") +
                     std::to_string(with_depth->width) + "x" + std::to_string(with_depth->height) + "; " + beauty +
                     " is " + (fore.picture.deep ? "deep, " : "flat, ") + std::to_string(fore.picture.width) + "x" +
                     std::to_string(fore.picture.height) + "; render both of one size");
  }
  const Channel& z = depth_channel(*with_depth, place.channel);
  const double depth_unit = unit_km(order.unit).value_or(with_depth->is_airlight ? 1.0 : 1e-3);
  const composite::DepthKind kind = kind_of(order, *with_depth, scene);
  const std::vector<float> cosines = composite::axis_cosines(scene);
  if (fore.picture.deep) {
    index_samples(fore);
  }
  fore.mended = mend_light(fore.picture, fore.colours, fore.alpha, fore.pixel_of);
  fore.things = things_of(fore, order.scale);
  if (z.values.size() != fore.things.size()) {
    throw InputError(place.file + ": its " + z.name + " has " + std::to_string(z.values.size()) + " samples where " +
                     beauty + " has " + std::to_string(fore.things.size()) + "; render both in one go");
  }
  fore.distances = composite::distances(z.values, kind, depth_unit, cosines, fore.pixel_of, fore.counts);
  if (!fore.picture.deep) {
    settle_flat(fore);
  } else if (const Channel* back = with_depth->find(in_layer(layer_of(z.name), "ZBack"))) {
    composite::DepthCounts ignored;
    fore.backs = composite::distances(back->values, kind, depth_unit, cosines, fore.pixel_of, ignored);
  }
  return fore;
}

}  // namespace airlight::cli
