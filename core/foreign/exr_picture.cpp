#include "core/foreign/exr_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepTiledInputPart.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include "core/base/error.h"
#include "core/base/huge_pages.h"
#include "core/base/srgb.h"
#include "core/base/text.h"
#include "core/foreign/header_check.h"
#include "core/output/exr.h"
#include "core/output/exr_header.h"
#include "core/output/exr_parts.h"
#include "core/output/provenance_keys.h"

namespace airlight::foreign {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

std::size_t size_of(int count) {
  return static_cast<std::size_t>(count);
}

std::optional<std::array<double, 16>> matrix_of(const imf::Header& header, const std::string& name) {
  const auto* found = header.findTypedAttribute<imf::M44fAttribute>(name);
  if (found == nullptr) {
    return std::nullopt;
  }
  std::array<double, 16> matrix{};
  std::copy_n(found->value().getValue(), matrix.size(), matrix.begin());
  return matrix;
}

bool is_deep(const imf::Header& header) {
  return header.hasType() && imf::isDeepData(header.type());
}

void read_attributes(Picture& picture, const imf::Header& header) {
  const Imath::Box2i& window = header.displayWindow();
  const auto side = [](std::int64_t low, std::int64_t high) {
    return static_cast<int>(std::clamp<std::int64_t>(high - low + 1, 0, std::numeric_limits<int>::max()));
  };
  picture.width = side(window.min.x, window.max.x);
  picture.height = side(window.min.y, window.max.y);
  picture.deep = is_deep(header);
  picture.world_to_camera = matrix_of(header, "worldToCamera");
  picture.world_to_ndc = matrix_of(header, "worldToNDC");
  picture.chromaticities = chromaticities_of<float>(header);
  picture.srgb = text_of(header, "oiio:ColorSpace") == "sRGB";
  picture.is_airlight = text_of(header, kPresetKey).has_value();
}

// Index in the display window of the first stored pixel of a row; the picture has it and those after it for the
// columns [first, end).
struct Row {
  std::size_t at = 0;
  int first = 0;
  int end = 0;
};

// The stored row where it lies in the display window, as far as it does.
Row placed(const imf::Header& header, int row) {
  const Imath::Box2i& display = header.displayWindow();
  const Imath::Box2i& data = header.dataWindow();
  const int y = data.min.y + row;
  const int left = std::max(data.min.x, display.min.x);
  const int right = std::min(data.max.x, display.max.x);
  if (y < display.min.y || y > display.max.y || left > right) {
    return {};
  }
  const std::size_t width = size_of(display.size().x + 1);
  return {size_of(y - display.min.y) * width + size_of(left - display.min.x), left - data.min.x,
          right + 1 - data.min.x};
}

void read_flat(Picture& picture, imf::MultiPartInputFile& file, int part, const std::string& prefix) {
  imf::InputPart input(file, part);
  const imf::Header& header = input.header();
  const Imath::Box2i& data = header.dataWindow();
  const std::vector<std::string> names = channel_names(header, picture.file);
  const std::size_t columns = size_of(data.size().x + 1);
  const int rows = data.size().y + 1;
  std::vector<std::vector<float>> stored;
  imf::FrameBuffer frame;
  for (const std::string& name : names) {
    stored.push_back(large_vector<float>(columns * size_of(rows)));
    frame.insert(name, imf::Slice::Make(imf::FLOAT, stored.back().data(), data));
  }
  input.setFrameBuffer(frame);
  input.readPixels(data.min.y, data.max.y);
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (picture.srgb && names[c] != "A" && names[c] != "Alpha") {
      std::ranges::transform(stored[c], stored[c].begin(), [](float x) { return srgb_decoded(x); });
    }
    Channel channel{prefix + names[c], header.channels()[names[c]].type == imf::HALF, {}};
    if (data == header.displayWindow()) {
      channel.values = std::move(stored[c]);
    } else {
      channel.values = large_vector<float>(size_of(picture.width) * size_of(picture.height));
      for (int row = 0; row < rows; ++row) {
        const Row place = placed(header, row);
        const float* const from = stored[c].data() + size_of(row) * columns;
        std::copy(from + place.first, from + place.end, channel.values.begin() + static_cast<std::ptrdiff_t>(place.at));
      }
    }
    picture.channels.push_back(std::move(channel));
  }
}

// The part's samples: how many each stored pixel has, and the values of each channel, pixel by pixel.
struct DeepSamples {
  std::vector<unsigned> counts;
  std::vector<std::vector<float>> values;
};

// The counts of a damaged file may ask for any memory.
void require_room_for_samples(std::size_t values, std::uintmax_t file_bytes) {
  constexpr std::uintmax_t kMostBytesFromOne = 1032;  // by deflate; two bytes a value
  if (values > file_bytes * kMostBytesFromOne / 2) {
    throw std::runtime_error("it has fewer bytes than its samples ask for");
  }
}

template <class Part, class ReadCounts, class ReadPixels>
DeepSamples deep_samples(Part& input, std::uintmax_t file_bytes, const std::vector<std::string>& names,
                         const ReadCounts& read_counts, const ReadPixels& read_pixels) {
  const Imath::Box2i& data = input.header().dataWindow();
  const std::size_t columns = size_of(data.size().x + 1);
  const std::size_t pixels = columns * size_of(data.size().y + 1);
  DeepSamples samples{std::vector<unsigned>(pixels), {}};
  std::vector<std::vector<float*>> pointers(names.size(), std::vector<float*>(pixels));
  // Where the pixel (0, 0) would be.
  const auto base = [&](auto* first) {
    const std::ptrdiff_t before = -static_cast<std::ptrdiff_t>(data.min.y) * static_cast<std::ptrdiff_t>(columns) -
                                  static_cast<std::ptrdiff_t>(data.min.x);
    return reinterpret_cast<char*>(first) + before * static_cast<std::ptrdiff_t>(sizeof *first);
  };
  imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(
      imf::Slice(imf::UINT, base(samples.counts.data()), sizeof(unsigned), sizeof(unsigned) * columns));
  for (std::size_t c = 0; c < names.size(); ++c) {
    frame.insert(names[c], imf::DeepSlice(imf::FLOAT, base(pointers[c].data()), sizeof(float*),
                                          sizeof(float*) * columns, sizeof(float)));
  }
  input.setFrameBuffer(frame);
  read_counts(data);
  std::size_t all = 0;
  for (const unsigned count : samples.counts) all += count;
  require_room_for_samples(all * names.size(), file_bytes);
  for (std::size_t c = 0; c < names.size(); ++c) {
    float* next = samples.values.emplace_back(all).data();
    for (std::size_t i = 0; i < pixels; ++i) {
      pointers[c][i] = next;
      next += samples.counts[i];
    }
  }
  read_pixels(data);
  return samples;
}

DeepSamples read_deep_samples(imf::MultiPartInputFile& file, const std::string& name,
                              const std::vector<std::string>& names) {
  const std::uintmax_t bytes = std::filesystem::file_size(name);
  if (file.header(0).type() == imf::DEEPTILE) {
    imf::DeepTiledInputPart input(file, 0);
    const int across = input.numXTiles(0) - 1;
    const int down = input.numYTiles(0) - 1;
    return deep_samples(
        input, bytes, names, [&](const Imath::Box2i&) { input.readPixelSampleCounts(0, across, 0, down, 0); },
        [&](const Imath::Box2i&) { input.readTiles(0, across, 0, down, 0); });
  }
  imf::DeepScanLineInputPart input(file, 0);
  return deep_samples(
      input, bytes, names, [&](const Imath::Box2i& data) { input.readPixelSampleCounts(data.min.y, data.max.y); },
      [&](const Imath::Box2i& data) { input.readPixels(data.min.y, data.max.y); });
}

void read_deep(Picture& picture, imf::MultiPartInputFile& file) {
  const imf::Header& header = file.header(0);
  const std::vector<std::string> names = channel_names(header, picture.file);
  const DeepSamples samples = read_deep_samples(file, picture.file, names);
  for (const std::string& name : names) {
    picture.channels.push_back({name, header.channels()[name].type == imf::HALF, {}});
  }
  picture.samples.resize(size_of(picture.width) * size_of(picture.height));
  const std::size_t columns = size_of(header.dataWindow().size().x + 1);
  std::size_t at = 0;  // of the row's first sample
  for (int row = 0; row <= header.dataWindow().size().y; ++row) {
    const Row place = placed(header, row);
    const unsigned* const counts = samples.counts.data() + size_of(row) * columns;
    std::copy(counts + place.first, counts + place.end,
              picture.samples.begin() + static_cast<std::ptrdiff_t>(place.at));
    std::size_t first = at;
    for (int i = 0; i < place.first; ++i) first += counts[i];
    std::size_t end = first;
    for (int i = place.first; i < place.end; ++i) end += counts[i];
    for (std::size_t c = 0; c < names.size(); ++c) {
      std::vector<float>& values = picture.channels[c].values;
      values.insert(values.end(), samples.values[c].begin() + static_cast<std::ptrdiff_t>(first),
                    samples.values[c].begin() + static_cast<std::ptrdiff_t>(end));
    }
    for (std::size_t i = 0; i < columns; ++i) at += counts[i];
  }
}

}  // namespace

Picture read_exr_picture(const std::string& file, const Accept& accept) {
  Picture picture;
  picture.file = file;
  std::unique_ptr<imf::MultiPartInputFile> input;
  try {
    require_room_for_exr(file);
    start_exr_threads();
    input = std::make_unique<imf::MultiPartInputFile>(file.c_str());
  } catch (const std::bad_alloc&) {
    throw InputError(file + ": not enough memory to read it");
  } catch (const std::exception& reason) {
    throw InputError(file + ": cannot be read: " + one_line(reason.what()));
  }
  try {
    read_attributes(picture, input->header(0));
    const Imath::Box2i& data = input->header(0).dataWindow();
    require_acceptable(picture, std::int64_t{data.max.x} - data.min.x + 1, std::int64_t{data.max.y} - data.min.y + 1,
                       accept);
    if (picture.deep) {
      read_deep(picture, *input);
      return picture;
    }
    for (int part = 0; part < input->parts(); ++part) {
      const imf::Header& header = input->header(part);
      if (header.displayWindow().size() != input->header(0).displayWindow().size() || is_deep(header)) {
        continue;  // a thumbnail or a part of another kind
      }
      const std::string name = header.hasName() ? header.name() : "";
      read_flat(picture, *input, part, part == 0 || name.empty() ? "" : name + ".");
    }
    return picture;
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(file + ": not enough memory to read it");
  } catch (const std::exception& reason) {
    throw InputError(file + ": damaged or cut short: " + one_line(reason.what()) + "; write or copy it again");
  }
}

}  // namespace airlight::foreign
