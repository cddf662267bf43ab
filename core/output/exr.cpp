#include "core/output/exr.h"

#include <ImathMatrix.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfTimeCode.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/exr_blocks.h"
#include "core/output/half_block.h"
#include "core/output/long_text.h"
#include "core/output/parallel.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

// Threads that OpenEXR reads by; twice as many blocks are written at a time.
int exr_threads() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
}

// Number of rows converted to half at a time: whole blocks of ZIP (16), two of them for every thread, and of wide or
// deep pictures fewer.
int rows_at_once(std::size_t width, std::size_t channels) {
  constexpr std::size_t kBlock = 16;
  constexpr std::size_t kFewest = 8;  // blocks
  constexpr std::size_t kSamples = std::size_t{1} << 24;
  const std::size_t fit = kSamples / (kBlock * width * channels);
  const std::size_t wanted = std::max(2 * static_cast<std::size_t>(exr_threads()), kFewest);
  return static_cast<int>(kBlock * std::clamp(fit, kFewest, wanted));
}

ExrSink sink_into(std::vector<std::byte>& bytes) {
  return [&bytes](std::uint64_t position, std::span<const std::byte> piece) {
    if (position + piece.size() > bytes.size()) {
      bytes.resize(position + piece.size());
    }
    std::ranges::copy(piece, bytes.begin() + static_cast<std::ptrdiff_t>(position));
  };
}

void add_text(imf::Header& header, const std::string& name, const std::string& text) {
  for (const auto& [piece_name, piece] : attributes_of(name, text)) {
    header.insert(piece_name, imf::StringAttribute(piece));
  }
}

// Shortens a standard attribute, which every reader expects in one piece.
std::string at_most_one_attribute(const std::string& text) {
  const std::string more = "...";
  return text.size() <= kLongestAttribute
             ? text
             : text.substr(0, whole_characters(text, 0, kLongestAttribute - more.size())) + more;
}

void add_provenance(imf::Header& header, const Provenance& provenance) {
  add_text(header, kPresetKey, provenance.preset_json);
  add_text(header, kMethodKey, provenance.method);
  add_text(header, kVersionKey, provenance.version);
  add_text(header, kDeviceKey, provenance.device);
}

// Hours, minutes, seconds and frames at a whole rate; none beyond 24 hours or where the rate needs more than two
// digits.
std::optional<imf::TimeCode> time_code(int number, int frames_a_second) {
  constexpr int kMostFrames = 60;
  if (number < 0 || frames_a_second < 1 || frames_a_second > kMostFrames || number / frames_a_second >= 24 * 3600) {
    return std::nullopt;
  }
  const int seconds = number / frames_a_second;
  return imf::TimeCode(seconds / 3600, seconds / 60 % 60, seconds % 60, number % frames_a_second);
}

void add_frame(imf::Header& header, const FrameAttributes& frame) {
  const auto add = [&](const auto& value, auto adder) {
    if (value) {
      adder(header, *value);
    }
  };
  if (frame.number) {
    header.insert("imageCounter", imf::IntAttribute(*frame.number));
  }
  add(frame.capture_date, imf::addCapDate);
  add(frame.utc_offset, imf::addUtcOffset);
  add(frame.latitude, imf::addLatitude);
  add(frame.longitude, imf::addLongitude);
  add(frame.altitude, imf::addAltitude);
  if (frame.frames_a_second) {
    imf::addFramesPerSecond(header, imf::Rational(*frame.frames_a_second, 1U));
    add(frame.number ? time_code(*frame.number, *frame.frames_a_second) : std::nullopt, imf::addTimeCode);
  }
}

// OpenEXR's latlong map has longitude +pi at the left edge, falling to the right, with +z at longitude 0 and +x at
// pi/2: seen from inside with y up, +x lies left of +z. Ours has azimuth a0 + 180 (2 x/W - 1) degrees, so that
// longitude = a0 - a. At our centre, east of north lies to the right, and our frame is right-handed too. The two
// pictures therefore differ by a rotation about y (by a0 - 180 degrees, none when the camera looks south), not by a
// mirror image, and the tag is right. OpenEXR puts the centres of the outer pixels on the poles and on +-180 degrees;
// we put their edges there.
imf::Header make_header(int width, int height, const ExrOptions& options) {
  imf::Header header(width, height);
  header.compression() = options.aces_container ? imf::NO_COMPRESSION : imf::ZIP_COMPRESSION;
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
    std::ranges::copy(*options.world_to_camera, matrix.getValue());
    imf::addWorldToCamera(header, matrix);
  }
  if (!options.comments.empty()) {
    imf::addComments(header, at_most_one_attribute(options.comments));
  }
  if (options.frame) {
    add_frame(header, *options.frame);
  }
  if (options.aces_container) {
    header.insert("acesImageContainerFlag", imf::IntAttribute(1));
    imf::addAdoptedNeutral(header, Imath::V2f(c[6], c[7]));
  }
  if (options.provenance) {
    add_provenance(header, *options.provenance);
    header.insert("software", imf::StringAttribute("airlight " + options.provenance->version));
  }
  for (const auto& [name, text] : options.strings) {
    add_text(header, name, text);
  }
  for (const auto& [name, number] : options.numbers) {
    header.insert(name, imf::FloatAttribute(number));
  }
  for (const auto& [name, v] : options.vectors) {
    header.insert(name, imf::V3fAttribute(Imath::V3f(v[0], v[1], v[2])));
  }
  return header;
}

bool is_alpha(const std::string& name) {
  return name == "A" || name.ends_with(".A");
}

}  // namespace

void start_exr_threads() {
  static std::once_flag once;
  std::call_once(once, [] {
    const int threads = exr_threads();
    imf::setGlobalThreadCount(threads > 1 ? threads : 0);
  });
}

void add_channels(std::vector<ExrChannel>& channels, std::string_view layer, const RadianceImage& image,
                  bool with_alpha) {
  const std::string prefix = layer.empty() ? std::string() : std::string(layer) + ".";
  static constexpr std::array<const char*, 4> kNames = {"R", "G", "B", "A"};
  for (std::size_t c = 0; c < (with_alpha ? 4U : 3U); ++c) {
    channels.push_back({prefix + kNames[c], image.rgba.data() + c, 4});
  }
}

struct ExrRows::State {
  ExrSink sink;
  ExrBlocks blocks;
  std::size_t width;
  bool half;
  ExrCounts counts;

  State(const ExrSink& to, const imf::Header& header, int columns, bool halves_wanted)
      : sink(to), blocks(to, header), width(static_cast<std::size_t>(columns)), half(halves_wanted) {}

  void add(int rows, std::size_t done, std::span<const ExrChannel> channels);
};

void ExrRows::State::add(int rows, std::size_t done, std::span<const ExrChannel> channels) {
  std::vector<std::size_t> first_words;
  for (const ExrChannel& channel : channels) {
    first_words.push_back(blocks.first_word(channel.name));
  }
  const std::span<std::uint16_t> room = blocks.room(rows);
  std::mutex counting;
  for_row_strips(rows, [&](int begin, int end) {
    ExrCounts found;
    for (std::size_t row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row) {
      for (std::size_t c = 0; c < channels.size(); ++c) {
        const ExrChannel& channel = channels[c];
        const float* const first = channel.first + (done + width * row) * channel.stride;
        std::uint16_t* const words = room.data() + row * blocks.row_words() + first_words[c];
        ExrCounts of_channel;
        if (half && !channel.full_float) {
          convert_to_half(first, channel.stride, width, words, of_channel);
        } else {
          copy_floats(first, channel.stride, width, words, of_channel);
        }
        if (!is_alpha(channel.name)) {
          add_counts(found, of_channel);
        }
      }
    }
    const std::lock_guard lock(counting);
    add_counts(counts, found);
  });
  blocks.add(rows);
}

namespace {

template <class Work>
void encoding(const Work& work) {
  try {
    work();
  } catch (const RunError&) {  // of the sink, whose message is complete
    throw;
  } catch (const std::exception& error) {
    throw RunError(std::string("EXR: cannot encode the picture: ") + error.what());
  }
}

// Offset of an attribute's value in a header; `type` with the value's length in four bytes: "float\0\4\0\0\0".
std::size_t place_of_value(std::span<const std::byte> head, const std::string& name, const std::string& type) {
  const std::string mark = name + '\0' + type;
  const auto found = std::search(head.begin(), head.end(), mark.begin(), mark.end(),
                                 [](std::byte b, char c) { return static_cast<char>(b) == c; });
  if (found == head.end()) {
    throw std::logic_error("EXR: the header has no attribute " + name + " to be set at the end");
  }
  return static_cast<std::size_t>(found - head.begin()) + mark.size();
}

}  // namespace

ExrRows::ExrRows(const ExrSink& sink, int width, int height, std::span<const ExrChannel> channels,
                 const ExrOptions& options) {
  assert(width > 0 && height > 0 && !channels.empty());
  encoding([&] {
    imf::Header header = make_header(width, height, options);
    for (const ExrChannel& channel : channels) {
      const bool half = options.half && !channel.full_float;
      header.channels().insert(channel.name, imf::Channel(half ? imf::HALF : imf::FLOAT));
    }
    state_ = std::make_unique<State>(sink, header, width, options.half);
  });
}

ExrRows::~ExrRows() = default;

void ExrRows::add(int rows, std::span<const ExrChannel> channels) {
  encoding([&] {
    const int most = rows_at_once(state_->width, channels.size());
    for (int done = 0; done < rows; done += most) {
      state_->add(std::min(most, rows - done), state_->width * static_cast<std::size_t>(done), channels);
    }
  });
}

ExrCounts ExrRows::finish(const std::map<std::string, float>& numbers,
                          const std::map<std::string, std::array<float, 3>>& vectors) {
  using namespace std::string_literals;
  state_->blocks.finish();
  const auto put = [&](const auto& values, const std::string& type) {
    for (const auto& [name, value] : values) {
      const auto bits = std::bit_cast<std::array<std::byte, sizeof value>>(value);  // little endian, as the file
      state_->sink(place_of_value(state_->blocks.head(), name, type), bits);
    }
  };
  put(numbers, "float\0\4\0\0\0"s);
  put(vectors, "v3f\0\14\0\0\0"s);
  return state_->counts;
}

ExrFile encode_exr(int width, int height, std::span<const ExrChannel> channels, const ExrOptions& options) {
  ExrFile result;
  ExrRows rows(sink_into(result.bytes), width, height, channels, options);
  rows.add(height, channels);
  result.counts = rows.finish();
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

}  // namespace airlight
