#include "core/output/exr.h"

#include <ImathMatrix.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <thread>

#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/output/half_block.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

// Rows converted to half at a time: whole ZIP blocks (16) and PIZ blocks (32), enough of them for every thread.
constexpr int kRowsAtOnce = 128;
// OpenEXR's own default since 3.1.3; at 1080p half 59 CPU-ms and 0.44 MB, where 1 takes 40 and 0.70, 6 takes 158 and
// 0.42.
constexpr int kZipLevel = 4;

const std::array<std::string, 5> kCompressionNames = {"none", "zips", "zip", "piz", "pxr24"};

class MemoryStream : public imf::OStream {
 public:
  explicit MemoryStream(std::vector<std::byte>& bytes) : OStream("memory"), bytes_(bytes) {}
  void write(const char data[], int size) override {
    const std::size_t count = static_cast<std::size_t>(size);
    if (position_ + count > bytes_.size()) {
      bytes_.resize(position_ + count);
    }
    std::memcpy(bytes_.data() + position_, data, count);
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<std::byte>& bytes_;
  std::size_t position_ = 0;
};

imf::Compression imf_compression(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::none:
      return imf::NO_COMPRESSION;
    case ExrCompression::zips:
      return imf::ZIPS_COMPRESSION;
    case ExrCompression::zip:
      return imf::ZIP_COMPRESSION;
    case ExrCompression::piz:
      return imf::PIZ_COMPRESSION;
    case ExrCompression::pxr24:
      return imf::PXR24_COMPRESSION;
  }
  assert(false);
  return imf::ZIP_COMPRESSION;
}

void start_threads() {
  static std::once_flag once;
  std::call_once(once, [] {
    const unsigned cores = std::min(std::thread::hardware_concurrency(), 16U);
    imf::setGlobalThreadCount(cores > 1 ? static_cast<int>(cores) : 0);
  });
}

void add_provenance(imf::Header& header, const Provenance& provenance) {
  header.insert(kPresetKey, imf::StringAttribute(provenance.preset_json));
  header.insert(kMethodKey, imf::StringAttribute(provenance.method));
  header.insert(kVersionKey, imf::StringAttribute(provenance.version));
  header.insert(kDeviceKey, imf::StringAttribute(provenance.device));
}

// OpenEXR's latlong map has longitude +pi at the left edge, falling to the right, with +z at longitude 0 and +x at
// pi/2: seen from inside with y up, +x lies left of +z. Ours has azimuth a0 + 180 (2 x/W - 1) degrees, so that
// longitude = a0 - a. Looking at our centre, east of north lies right, and our frame is right-handed too: the two
// pictures differ by a rotation about y (by a0 - 180 degrees, none when the camera looks south), never by a mirror
// image, and the tag is right. OpenEXR puts the outer pixels' centres on the poles and on +-180 degrees, we their
// edges.
imf::Header make_header(int width, int height, const ExrOptions& options) {
  imf::Header header(width, height);
  header.compression() = imf_compression(options.compression);
  header.zipCompressionLevel() = kZipLevel;
  const Chromaticities c = chromaticities_of(options.space);
  imf::addChromaticities(header, imf::Chromaticities(Imath::V2f(c[0], c[1]), Imath::V2f(c[2], c[3]),
                                                     Imath::V2f(c[4], c[5]), Imath::V2f(c[6], c[7])));
  if (options.white_luminance) {
    imf::addWhiteLuminance(header, *options.white_luminance);
  }
  if (options.latlong) {
    imf::addEnvmap(header, imf::ENVMAP_LATLONG);
  }
  if (options.cube) {
    imf::addEnvmap(header, imf::ENVMAP_CUBE);
  }
  if (options.world_to_camera) {
    Imath::M44f matrix;
    std::copy(options.world_to_camera->begin(), options.world_to_camera->end(), matrix.getValue());
    imf::addWorldToCamera(header, matrix);
  }
  if (!options.comments.empty()) {
    imf::addComments(header, options.comments);
  }
  if (options.provenance) {
    add_provenance(header, *options.provenance);
    header.insert("software", imf::StringAttribute("airlight " + options.provenance->version));
  }
  for (const auto& [name, text] : options.strings) {
    header.insert(name, imf::StringAttribute(text));
  }
  for (const auto& [name, number] : options.numbers) {
    header.insert(name, imf::FloatAttribute(number));
  }
  return header;
}

bool is_alpha(const std::string& name) {
  return name == "A" || name.ends_with(".A");
}

void write_float(imf::OutputFile& file, int width, int height, std::span<const ExrChannel> channels,
                 ExrCounts& counts) {
  imf::FrameBuffer frame;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (const ExrChannel& channel : channels) {
    const std::size_t step = channel.stride * sizeof(float);
    // OpenEXR only reads through the pointer that it wants as char*.
    frame.insert(channel.name, imf::Slice(imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(channel.first)), step,
                                          step * static_cast<std::size_t>(width)));
    if (!is_alpha(channel.name)) {
      count_samples(channel.first, channel.stride, pixels, counts);
    }
  }
  file.setFrameBuffer(frame);
  file.writePixels(height);
}

void write_half(imf::OutputFile& file, int width, int height, std::span<const ExrChannel> channels, ExrCounts& counts) {
  const std::size_t row = static_cast<std::size_t>(width);
  const std::size_t block = row * static_cast<std::size_t>(std::min(kRowsAtOnce, height));
  std::vector<std::uint16_t> halves(block * channels.size());
  for (int y = 0; y < height; y += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, height - y);
    const std::size_t pixels = row * static_cast<std::size_t>(rows);
    const std::size_t done = row * static_cast<std::size_t>(y);
    imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const ExrChannel& channel = channels[c];
      std::uint16_t* const plane = halves.data() + c * block;
      ExrCounts found;
      convert_to_half(channel.first + done * channel.stride, channel.stride, pixels, plane, found);
      if (!is_alpha(channel.name)) {
        add_counts(counts, found);
      }
      frame.insert(channel.name, imf::Slice::Make(imf::HALF, plane, Imath::V2i(0, y), width, rows));
    }
    file.setFrameBuffer(frame);
    file.writePixels(rows);
  }
}

std::string axis_text(const TableAxis& axis) {
  return axis.name + " [" + axis.unit + "]: " + axis.mapping;
}

}  // namespace

std::span<const std::string> exr_compression_names() {
  return kCompressionNames;
}

std::optional<ExrCompression> exr_compression(std::string_view name) {
  const auto found = std::find(kCompressionNames.begin(), kCompressionNames.end(), name);
  if (found == kCompressionNames.end()) {
    return std::nullopt;
  }
  return static_cast<ExrCompression>(found - kCompressionNames.begin());
}

void add_channels(std::vector<ExrChannel>& channels, std::string_view layer, const RadianceImage& image,
                  bool with_alpha) {
  const std::string prefix = layer.empty() ? std::string() : std::string(layer) + ".";
  static constexpr std::array<const char*, 4> kNames = {"R", "G", "B", "A"};
  for (std::size_t c = 0; c < (with_alpha ? 4U : 3U); ++c) {
    channels.push_back({prefix + kNames[c], image.rgba.data() + c, 4});
  }
}

ExrFile encode_exr(int width, int height, std::span<const ExrChannel> channels, const ExrOptions& options) {
  assert(width > 0 && height > 0 && !channels.empty());
  start_threads();
  ExrFile result;
  try {
    imf::Header header = make_header(width, height, options);
    for (const ExrChannel& channel : channels) {
      header.channels().insert(channel.name, imf::Channel(options.half ? imf::HALF : imf::FLOAT));
    }
    MemoryStream stream(result.bytes);
    imf::OutputFile file(stream, header);
    if (options.half) {
      write_half(file, width, height, channels, result.counts);
    } else {
      write_float(file, width, height, channels, result.counts);
    }
  } catch (const std::exception& error) {
    throw RunError(std::string("EXR: cannot encode the picture: ") + error.what());
  }
  return result;
}

ExrCounts write_exr(const std::filesystem::path& file, int width, int height, std::span<const ExrChannel> channels,
                    const ExrOptions& options) {
  const ExrFile encoded = encode_exr(width, height, channels, options);
  write_file(file, encoded.bytes);
  return encoded.counts;
}

std::array<float, 16> world_to_camera(const Axis& right, const Axis& up, const Axis& forward, double altitude) {
  const Axis back = {-forward[0], -forward[1], -forward[2]};
  std::array<float, 16> matrix{};
  const std::array<const Axis*, 3> axes = {&right, &up, &back};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      matrix[4 * row + column] = static_cast<float>((*axes[column])[row]);
    }
    matrix[12 + column] = static_cast<float>(-altitude * (*axes[column])[1]);  // the camera stands at (0, altitude, 0)
  }
  matrix[15] = 1.0F;
  return matrix;
}

void write_table_exr(const std::filesystem::path& file, const Table& table,
                     const std::optional<Provenance>& provenance) {
  ExrOptions options;
  options.half = false;
  options.provenance = provenance;
  options.strings = {{"airlight:quantity", table.quantity},
                     {"airlight:axis:x", axis_text(table.x)},
                     {"airlight:axis:y", axis_text(table.y)}};
  if (table.slices > 1) {
    options.strings["airlight:axis:z"] = axis_text(table.z);
    options.strings["airlight:slices"] = std::to_string(table.slices) + " side by side";
  }
  std::vector<ExrChannel> channels;
  for (std::size_t c = 0; c < 4; ++c) {
    channels.push_back({std::string(1, "RGBA"[c]), table.rgba + c, 4});
  }
  write_exr(file, table.width, table.height, channels, options);
}

}  // namespace airlight
