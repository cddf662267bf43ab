#include "core/measure/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/huge_pages.h"
#include "core/base/text.h"
#include "core/output/exr.h"
#include "core/output/exr_header.h"
#include "core/output/exr_parts.h"
#include "core/output/first_bytes.h"
#include "core/output/provenance_keys.h"
#include "core/scene/named_file.h"

namespace airlight::measure {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

void require_exr(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError(file + ": is a directory; expected an EXR file");
  if (!std::filesystem::exists(file, ignored)) throw InputError(file + ": no such file; expected an EXR file");
  if (const std::string problem = named_file_problem(file); !problem.empty())
    throw InputError(file + ": " + problem + "; expected an EXR file");
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

void add_channels(LayeredExr& exr, const imf::Header& header, int part) {
  std::string part_name = header.hasName() ? header.name() : "";
  if (part_name.empty() && part > 0) part_name = std::to_string(part);
  for (const std::string& full_name : channel_names(header, exr.file)) {
    const std::string layer_name = layer_of(full_name).empty() && part > 0 ? part_name : layer_of(full_name);
    if (exr.layers.empty() || exr.layers.back().part != part || exr.layers.back().name != layer_name) {
      ExrLayer& added = exr.layers.emplace_back();
      added.name = layer_name;
      added.part_name = part_name;
      added.part = part;
      added.frame = frame_of(header);
    }
    exr.layers.back().channels.push_back(name_in_layer(full_name));
    exr.layers.back().full_names.push_back(full_name);
  }
}

void read_attributes(LayeredExr& exr, const imf::Header& header) {
  exr.chromaticities = chromaticities_of<double>(header).value_or(kBt709);
  const std::optional<std::string> preset = text_of(header, kPresetKey);
  if (preset && !preset->empty()) {
    exr.preset = *preset;
    exr.version = text_of(header, kVersionKey).value_or("");
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
  try {
    imf::InputPart part(*input, layer.part);
    const Imath::Box2i& window = part.header().dataWindow();
    imf::FrameBuffer frame;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::string& name = layer.full_names[places[k]];
      channels[k] = large_vector<float>(pixels);
      frame.insert(name, imf::Slice::Make(imf::FLOAT, channels[k].data(), window));
    }
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    throw damaged(exr.file, reason.what());
  }
  return channels;
}

}  // namespace airlight::measure
