#include "core/measure/module_exr.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "core/error.h"
#include "core/measure/module_text.h"
#include "core/measure/words.h"
#include "core/output/exr_header.h"
#include "core/output/first_bytes.h"
#include "core/output/provenance_keys.h"
#include "core/text.h"

namespace airlight::measure {
namespace {

void require_exr(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError(file + ": is a directory; expected an EXR file");
  if (!std::filesystem::exists(file, ignored)) throw InputError(file + ": no such file; expected an EXR file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be opened for reading; check its permissions");
  if (!starts_with(stream, kExrMagic)) {
    throw InputError(file + ": is not an EXR file (its first bytes are not those of OpenEXR)");
  }
}

InputError damaged(const std::string& file, const std::string& reason) {
  return InputError(file + ": damaged or cut short: " + one_line(reason) + "; write or copy it again");
}

std::unique_ptr<OIIO::ImageInput> open(const std::string& file) {
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
  try {
    require_room_for_exr(file);
  } catch (const std::runtime_error& reason) {
    throw damaged(file, reason.what());
  }
  if (!input) throw RunError("OpenImageIO has no OpenEXR reader: " + one_line(OIIO::geterror()));
  OIIO::ImageSpec spec;
  if (!input->open(file, spec)) throw damaged(file, input->geterror());
  return input;
}

PixelFrame frame_of(const OIIO::ImageSpec& spec) {
  return {.width = spec.full_width,
          .height = spec.full_height,
          .left = spec.x - spec.full_x,
          .top = spec.y - spec.full_y,
          .columns = spec.width,
          .rows = spec.height};
}

void add_channels(std::vector<ExrLayer>& layers, const OIIO::ImageSpec& spec, int part) {
  std::string part_name = spec.get_string_attribute("oiio:subimagename");
  if (part_name.empty() && part > 0) part_name = std::to_string(part);
  for (int i = 0; i < spec.nchannels; ++i) {
    const std::string& full = spec.channelnames[static_cast<std::size_t>(i)];
    const std::size_t dot = full.rfind('.');
    const std::string layer_name = dot != std::string::npos ? full.substr(0, dot) : part > 0 ? part_name : "";
    auto layer = std::ranges::find_if(
        layers, [&](const ExrLayer& candidate) { return candidate.name == layer_name && candidate.part == part; });
    if (layer == layers.end()) {
      ExrLayer& added = layers.emplace_back();
      added.name = layer_name;
      added.part_name = part_name;
      added.part = part;
      added.frame = frame_of(spec);
      layer = layers.end() - 1;
    }
    layer->channels.push_back(dot == std::string::npos ? full : full.substr(dot + 1));
    layer->indexes.push_back(i);
    // OpenImageIO reads integers as fractions of their range; identifiers must be compared as numbers.
    layer->units.push_back(spec.channelformat(i) == OIIO::TypeUInt32 ? 4294967295.0F : 1.0F);
  }
}

void read_attributes(ExrHeader& header, const OIIO::ImageSpec& spec) {
  std::array<float, 8> values{};
  if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data())) {
    std::ranges::copy(values, header.chromaticities.begin());
  }
  if (const std::optional<std::string> preset = text_of(spec, kPresetKey); preset && !preset->empty()) {
    header.preset = *preset;
  }
}

std::string layer_list(const ExrHeader& header) {
  return joined_of(header.layers, [](const ExrLayer& layer) {
    return layer.name.empty() ? "the main picture" : "'" + layer.name + "'";
  });
}

}  // namespace

ExrHeader read_exr_header(const std::string& file) {
  require_exr(file);
  const std::unique_ptr<OIIO::ImageInput> input = open(file);
  ExrHeader header;
  header.file = file;
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.deep) throw InputError(file + ": holds deep data; flatten it first");
    if (part == 0) read_attributes(header, spec);
    add_channels(header.layers, spec, part);
  }
  if (header.layers.empty()) throw InputError(file + ": holds no channels");
  return header;
}

const ExrLayer& find_layer(const ExrHeader& header, const std::string& name) {
  for (const ExrLayer& layer : header.layers) {
    const bool is_main_by_its_part = layer.name.empty() && !name.empty() && layer.part_name == name;
    if (layer.name == name || is_main_by_its_part) return layer;
  }
  if (name.empty()) {
    if (header.layers.size() == 1) return header.layers.front();
    throw InputError(header.file + ": has no main picture, only the layers " + layer_list(header) +
                     "; name one with --layer");
  }
  throw InputError(header.file + ": has no layer '" + name + "'; it has " + layer_list(header));
}

std::vector<std::vector<float>> read_exr_channels(const ExrHeader& header, const ExrLayer& layer,
                                                  const std::vector<std::size_t>& places) {
  const std::unique_ptr<OIIO::ImageInput> input = open(header.file);
  int first = layer.indexes[places.front()];
  int last = first;
  for (const std::size_t place : places) {
    first = std::min(first, layer.indexes[place]);
    last = std::max(last, layer.indexes[place]);
  }
  const std::size_t stride = static_cast<std::size_t>(last - first + 1);
  const std::size_t pixels = static_cast<std::size_t>(layer.frame.columns) * static_cast<std::size_t>(layer.frame.rows);
  std::vector<float> all(stride * pixels);
  if (!input->read_image(layer.part, 0, first, last + 1, OIIO::TypeFloat, all.data())) {
    throw damaged(header.file, input->geterror());
  }
  std::vector<std::vector<float>> channels;
  for (const std::size_t place : places) {
    const std::size_t offset = static_cast<std::size_t>(layer.indexes[place] - first);
    const float unit = layer.units[place];
    std::vector<float>& channel = channels.emplace_back(pixels);
    for (std::size_t i = 0; i < pixels; ++i) channel[i] = unit * all[i * stride + offset];
  }
  return channels;
}

}  // namespace airlight::measure
