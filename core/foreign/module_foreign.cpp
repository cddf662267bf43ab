// Reads other programs' pictures through OpenImageIO. Compiled into the module alone.

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/base/srgb.h"
#include "core/base/text.h"
#include "core/foreign/foreign_picture.h"
#include "core/foreign/header_check.h"
#include "core/foreign/module_text.h"
#include "core/output/provenance_keys.h"

namespace airlight::foreign {
namespace {

// The file by the first of the formats whose own reader knows it.
std::unique_ptr<OIIO::ImageInput> open(const std::string& file) {
  for (const std::string_view format : kPictureFormats) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(std::string(format));
    if (!input || !input->valid_file(file)) {
      continue;
    }
    OIIO::ImageSpec spec;
    if (!input->open(file, spec)) throw InputError(file + ": cannot be read: " + one_line(input->geterror()));
    return input;
  }
  OIIO::geterror();
  throw InputError(file + ": is no picture that airlight reads; expected " + std::string(kPictureFormatWords));
}

std::optional<std::array<double, 16>> matrix_of(const OIIO::ImageSpec& spec, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    std::array<float, 16> m{};
    if (spec.getattribute(name, OIIO::TypeMatrix, m.data())) {
      return std::array<double, 16>{m[0], m[1], m[2],  m[3],  m[4],  m[5],  m[6],  m[7],
                                    m[8], m[9], m[10], m[11], m[12], m[13], m[14], m[15]};
    }
  }
  return std::nullopt;
}

void read_attributes(Picture& picture, const OIIO::ImageSpec& spec) {
  picture.width = spec.full_width;
  picture.height = spec.full_height;
  picture.deep = spec.deep;
  picture.world_to_camera = matrix_of(spec, {"worldtocamera", "worldToCamera"});
  picture.world_to_ndc = matrix_of(spec, {"worldtoscreen", "worldtoNDC", "worldToNDC"});
  std::array<float, 8> xy{};
  if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xy.data())) {
    picture.chromaticities = xy;
  }
  picture.srgb = spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
  picture.is_airlight = text_of(spec, kPresetKey).has_value();
}

// Index of a stored pixel in the display window, -1 outside of it.
std::ptrdiff_t place_of(const OIIO::ImageSpec& spec, int column, int row) {
  const int x = spec.x + column - spec.full_x;
  const int y = spec.y + row - spec.full_y;
  const bool inside = x >= 0 && y >= 0 && x < spec.full_width && y < spec.full_height;
  return inside ? static_cast<std::ptrdiff_t>(y) * spec.full_width + x : -1;
}

void read_flat(Picture& picture, OIIO::ImageInput& input, int part, const std::string& prefix) {
  const OIIO::ImageSpec spec = input.spec();
  const auto stored = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> all(stored * channels);
  if (!input.read_image(part, 0, 0, spec.nchannels, OIIO::TypeFloat, all.data())) {
    throw InputError(picture.file + ": damaged or cut short: " + one_line(input.geterror()) +
                     "; write or copy it again");
  }
  const std::size_t first = picture.channels.size();
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  for (std::size_t c = 0; c < channels; ++c) {
    picture.channels.push_back({prefix + std::string(spec.channel_name(static_cast<int>(c))),
                                spec.channelformat(static_cast<int>(c)) == OIIO::TypeHalf, std::vector<float>(pixels)});
  }
  for (std::size_t i = 0; picture.srgb && i < all.size(); ++i) {
    const bool is_alpha = static_cast<int>(i % channels) == spec.alpha_channel;
    all[i] = is_alpha ? all[i] : srgb_decoded(all[i]);
  }
  for (int row = 0; row < spec.height; ++row) {
    for (int column = 0; column < spec.width; ++column) {
      const std::ptrdiff_t place = place_of(spec, column, row);
      if (place < 0) continue;
      const auto at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(spec.width) + static_cast<std::size_t>(column);
      for (std::size_t c = 0; c < channels; ++c) {
        picture.channels[first + c].values[static_cast<std::size_t>(place)] = all[at * channels + c];
      }
    }
  }
}

void read_deep(Picture& picture, OIIO::ImageInput& input) {
  const OIIO::ImageSpec spec = input.spec();
  OIIO::DeepData data;
  if (!input.read_native_deep_image(0, 0, data)) {
    throw InputError(picture.file + ": damaged or cut short: " + one_line(input.geterror()) +
                     "; write or copy it again");
  }
  for (int c = 0; c < spec.nchannels; ++c) {
    picture.channels.push_back(
        {spec.channelnames[static_cast<std::size_t>(c)], spec.channelformat(c) == OIIO::TypeHalf, {}});
  }
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  std::vector<std::int64_t> stored(pixels, -1);
  for (int row = 0; row < spec.height; ++row) {
    for (int column = 0; column < spec.width; ++column) {
      const std::ptrdiff_t place = place_of(spec, column, row);
      if (place >= 0) stored[static_cast<std::size_t>(place)] = static_cast<std::int64_t>(row) * spec.width + column;
    }
  }
  for (const std::int64_t pixel : stored) {
    const int samples = pixel < 0 ? 0 : data.samples(pixel);
    picture.samples.push_back(static_cast<std::uint32_t>(samples));
    for (int c = 0; c < spec.nchannels; ++c) {
      for (int s = 0; s < samples; ++s) {
        picture.channels[static_cast<std::size_t>(c)].values.push_back(data.deep_value(pixel, c, s));
      }
    }
  }
}

void read(const std::string& file, const Accept& accept, Picture& picture) {
  const std::unique_ptr<OIIO::ImageInput> input = open(file);
  picture.file = file;
  read_attributes(picture, input->spec());
  require_acceptable(picture, input->spec().width, input->spec().height, accept);
  if (picture.deep) {
    read_deep(picture, *input);
    return;
  }
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.full_width != picture.width || spec.full_height != picture.height || spec.deep) {
      continue;  // a thumbnail or a part of another kind
    }
    const std::string name = spec.get_string_attribute("oiio:subimagename");
    read_flat(picture, *input, part, part == 0 || name.empty() ? "" : name + ".");
  }
}

}  // namespace
}  // namespace airlight::foreign

extern "C" __attribute__((visibility("default"))) void airlight_read_picture(const std::string& file,
                                                                             const airlight::foreign::Accept& accept,
                                                                             airlight::foreign::Picture& picture,
                                                                             std::string& problem) {
  try {
    airlight::foreign::read(file, accept, picture);
  } catch (const std::bad_alloc&) {
    problem = file + ": not enough memory to read it";
  } catch (const std::exception& error) {
    problem = airlight::one_line(error.what());
  }
}
