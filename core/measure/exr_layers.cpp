#include "core/measure/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>

#include "core/error.h"
#include "core/huge_pages.h"
#include "core/output/exr.h"
#include "core/output/exr_header.h"
#include "core/output/first_bytes.h"
#include "core/output/long_text.h"
#include "core/output/provenance_keys.h"
#include "core/text.h"

namespace airlight::measure {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

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

std::unique_ptr<imf::MultiPartInputFile> open(const std::string& file) {
  start_exr_threads();
  try {
    require_room_for_exr(file);
    return std::make_unique<imf::MultiPartInputFile>(file.c_str());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    throw damaged(file, reason.what());
  }
}

PixelFrame frame_of(const imf::Header& header) {
  const Imath::Box2i& display = header.displayWindow();
  const Imath::Box2i& data = header.dataWindow();
  return {.width = display.max.x - display.min.x + 1,
          .height = display.max.y - display.min.y + 1,
          .left = data.min.x - display.min.x,
          .top = data.min.y - display.min.y,
          .columns = data.max.x - data.min.x + 1,
          .rows = data.max.y - data.min.y + 1};
}

// Place of a channel among those of its layer.
std::pair<std::size_t, std::string> rank(const std::string& channel) {
  constexpr std::array<std::string_view, 5> kFirst = {"R", "G", "B", "A", "Z"};
  const auto found = std::ranges::find(kFirst, std::string_view(channel));
  return {static_cast<std::size_t>(found - kFirst.begin()), channel};
}

void add_channels(LayeredExr& exr, const imf::Header& header, int part) {
  std::string part_name = header.hasName() ? header.name() : "";
  if (part_name.empty() && part > 0) part_name = std::to_string(part);
  struct Found {
    std::string layer;
    std::string channel;
    std::string full_name;
    bool whole_numbers = false;
  };
  std::vector<Found> all;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    const std::string full = channel.name();
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
      throw InputError(exr.file + ": channel '" + full +
                       "' has fewer samples than the picture has pixels; write it with one for each pixel");
    }
    const std::size_t dot = full.rfind('.');
    const std::string layer = dot != std::string::npos ? full.substr(0, dot) : part > 0 ? part_name : "";
    all.push_back(
        {layer, dot == std::string::npos ? full : full.substr(dot + 1), full, channel.channel().type == imf::UINT});
  }
  std::ranges::sort(all, [](const Found& a, const Found& b) {
    return std::pair(a.layer, rank(a.channel)) < std::pair(b.layer, rank(b.channel));
  });
  for (const Found& found : all) {
    if (exr.layers.empty() || exr.layers.back().part != part || exr.layers.back().name != found.layer) {
      ExrLayer& added = exr.layers.emplace_back();
      added.name = found.layer;
      added.part_name = part_name;
      added.part = part;
      added.frame = frame_of(header);
    }
    ExrLayer& layer = exr.layers.back();
    layer.channels.push_back(found.channel);
    layer.full_names.push_back(found.full_name);
    layer.whole_numbers.push_back(found.whole_numbers);
  }
}

void read_attributes(LayeredExr& exr, const imf::Header& header) {
  if (imf::hasChromaticities(header)) {
    const imf::Chromaticities& c = imf::chromaticities(header);
    exr.chromaticities = {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
  }
  const std::optional<std::string> preset = text_in(kPresetKey, [&](const std::string& key) {
    const auto* found = header.findTypedAttribute<imf::StringAttribute>(key);
    return found == nullptr ? std::nullopt : std::optional(found->value());
  });
  if (preset && !preset->empty()) {
    exr.preset = *preset;
  }
}

std::string layer_list(const LayeredExr& exr) {
  return joined_of(exr.layers, [](const ExrLayer& layer) {
    return layer.name.empty() ? "the main picture" : "'" + layer.name + "'";
  });
}

}  // namespace

LayeredExr read_exr_layers(const std::string& file) {
  require_exr(file);
  const std::unique_ptr<imf::MultiPartInputFile> input = open(file);
  LayeredExr exr;
  exr.file = file;
  for (int part = 0; part < input->parts(); ++part) {
    const imf::Header& header = input->header(part);
    if (header.hasType() && imf::isDeepData(header.type())) {
      throw InputError(file + ": holds deep data; flatten it first");
    }
    if (part == 0) read_attributes(exr, header);
    add_channels(exr, header, part);
  }
  if (exr.layers.empty()) throw InputError(file + ": holds no channels");
  return exr;
}

const ExrLayer& find_layer(const LayeredExr& exr, const std::string& name) {
  for (const ExrLayer& layer : exr.layers) {
    const bool is_main_by_its_part = layer.name.empty() && !name.empty() && layer.part_name == name;
    if (layer.name == name || is_main_by_its_part) return layer;
  }
  if (name.empty()) {
    if (exr.layers.size() == 1) return exr.layers.front();
    throw InputError(exr.file + ": has no main picture, only the layers " + layer_list(exr) +
                     "; name one with --layer");
  }
  throw InputError(exr.file + ": has no layer '" + name + "'; it has " + layer_list(exr));
}

std::vector<std::vector<float>> read_exr_channels(const LayeredExr& exr, const ExrLayer& layer,
                                                  const std::vector<std::size_t>& places) {
  const std::unique_ptr<imf::MultiPartInputFile> input = open(exr.file);
  const PixelFrame& stored = layer.frame;
  const std::size_t pixels = static_cast<std::size_t>(stored.columns) * static_cast<std::size_t>(stored.rows);
  std::vector<std::vector<float>> channels(places.size());
  std::vector<std::vector<std::uint32_t>> numbers(places.size());
  try {
    imf::InputPart part(*input, layer.part);
    const Imath::Box2i& window = part.header().dataWindow();
    imf::FrameBuffer frame;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::string& name = layer.full_names[places[k]];
      channels[k] = large_vector<float>(pixels);
      if (layer.whole_numbers[places[k]]) {
        numbers[k].resize(pixels);
        frame.insert(name, imf::Slice::Make(imf::UINT, numbers[k].data(), window));
      } else {
        frame.insert(name, imf::Slice::Make(imf::FLOAT, channels[k].data(), window));
      }
    }
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    throw damaged(exr.file, reason.what());
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::ranges::transform(numbers[k], channels[k].begin(), [](std::uint32_t n) { return static_cast<float>(n); });
  }
  return channels;
}

}  // namespace airlight::measure
