#include "tests/fuzz/file_cases.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <sys/stat.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "app/cli/scene_files.h"
#include "app/composite/foreground.h"
#include "core/foreign/foreign_picture.h"
#include "core/methods/method.h"
#include "core/output/exr.h"
#include "core/output/png.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/fuzz/any_preset.h"
#include "tests/fuzz/guarded.h"
#include "tests/vdb_file.h"

namespace airlight::fuzz {
namespace {

namespace fs = std::filesystem;
namespace imf = OPENEXR_IMF_NAMESPACE;

constexpr int kColumns = 16;  // of each picture: twice as wide as high, as a map of a planet is
constexpr int kRows = 8;
constexpr std::size_t kPixels = std::size_t{kColumns} * kRows;

void put(const fs::path& file, const std::string& contents) {
  std::ofstream(file, std::ios::binary) << contents;
}

std::vector<char> bytes_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

float value_at(std::size_t i) {
  return 0.1F + 0.8F * static_cast<float>(i) / static_cast<float>(kPixels);
}

void write_plain_png(const fs::path& file) {
  PixelImage image{kColumns, kRows, 3, 8, {}, {}};
  for (std::size_t i = 0; i < 3 * kPixels; ++i) {
    image.bytes.push_back(static_cast<std::uint8_t>(255.0F * value_at(i / 3)));
  }
  write_png(file, image, {});
}

// Three floats a pixel, not compressed, in strips of two rows.
void write_tiff(const fs::path& file) {
  constexpr std::uint32_t kStrips = kRows / 2;
  constexpr std::uint32_t kStripBytes = 2 * kColumns * 3 * 4;
  constexpr std::uint32_t kEntries = 10;
  std::string bytes("II*\0", 4);
  const auto number = [&](std::uint32_t value, int size) {
    for (int k = 0; k < size; ++k) {
      bytes += static_cast<char>(value >> (8 * k) & 0xffU);
    }
  };
  number(8, 4);
  const std::uint32_t lists = 8 + 2 + 12 * kEntries + 4;  // offsets, counts, bits, formats
  const std::uint32_t pixels = lists + 8 * kStrips + 12;
  const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    number(tag, 2);
    number(type, 2);
    number(count, 4);
    number(value, 4);
  };
  number(kEntries, 2);
  entry(256, 3, 1, kColumns);
  entry(257, 3, 1, kRows);
  entry(258, 3, 3, lists + 8 * kStrips);
  entry(259, 3, 1, 1);
  entry(262, 3, 1, 2);
  entry(273, 4, kStrips, lists);
  entry(277, 3, 1, 3);
  entry(278, 3, 1, 2);
  entry(279, 4, kStrips, lists + 4 * kStrips);
  entry(339, 3, 3, lists + 8 * kStrips + 6);
  number(0, 4);
  for (std::uint32_t k = 0; k < kStrips; ++k) number(pixels + k * kStripBytes, 4);
  for (std::uint32_t k = 0; k < kStrips; ++k) number(kStripBytes, 4);
  for (int k = 0; k < 3; ++k) number(32, 2);
  for (int k = 0; k < 3; ++k) number(3, 2);
  for (std::size_t i = 0; i < 3 * kPixels; ++i) number(std::bit_cast<std::uint32_t>(value_at(i / 3)), 4);
  put(file, bytes);
}

void write_radiance_picture(const fs::path& file) {
  std::string bytes =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(kRows) + " +X " + std::to_string(kColumns) + "\n";
  for (std::size_t i = 0; i < kPixels; ++i) {
    const char value = static_cast<char>(255.0F * value_at(i));
    bytes += {value, value, value, static_cast<char>(128)};
  }
  put(file, bytes);
}

// R, G, B, A and Z; the values may be anything but good.
void write_plate(const fs::path& file, Random* spoiled) {
  std::array<std::vector<float>, 5> planes;
  std::vector<ExrChannel> channels;
  for (std::size_t c = 0; c < planes.size(); ++c) {
    for (std::size_t i = 0; i < kPixels; ++i) {
      planes[c].push_back(c == 4 ? 1000.0F * value_at(i) : value_at(i));
      if (spoiled != nullptr && spoiled->chance(0.1)) {
        constexpr std::array kBad{NAN, INFINITY, -INFINITY, -1.0F, 0.0F, 1e30F, 1e-40F};
        planes[c].back() = spoiled->pick(kBad);
      }
    }
    channels.push_back({std::string(1, "RGBAZ"[c]), planes[c].data(), 1, true});
  }
  ExrOptions options;
  options.half = false;
  write_exr(file, kColumns, kRows, channels, options);
}

void write_deep_plate(const fs::path& file) {
  imf::Header header(kColumns, kRows);
  header.setType(imf::DEEPSCANLINE);
  header.compression() = imf::ZIPS_COMPRESSION;
  std::vector<unsigned> counts(kPixels);
  std::array<std::vector<float>, 5> values;
  for (std::size_t i = 0; i < kPixels; ++i) {
    counts[i] = static_cast<unsigned>(i % 3);
    for (std::size_t c = 0; c < values.size(); ++c) {
      values[c].insert(values[c].end(), counts[i], c == 4 ? 1000.0F * value_at(i) : value_at(i));
    }
  }
  imf::DeepFrameBuffer frame;
  const auto base = [](auto* first) { return reinterpret_cast<char*>(first); };
  frame.insertSampleCountSlice(
      imf::Slice(imf::UINT, base(counts.data()), sizeof(unsigned), sizeof(unsigned) * kColumns));
  std::array<std::vector<float*>, 5> pointers;
  for (std::size_t c = 0; c < values.size(); ++c) {
    float* next = values[c].data();
    for (std::size_t i = 0; i < kPixels; ++i) {
      pointers[c].push_back(next);
      next += counts[i];
    }
    const std::string name(1, "RGBAZ"[c]);
    header.channels().insert(name, imf::Channel(imf::FLOAT));
    frame.insert(name, imf::DeepSlice(imf::FLOAT, base(pointers[c].data()), sizeof(float*), sizeof(float*) * kColumns,
                                      sizeof(float)));
  }
  imf::DeepScanLineOutputFile out(file.c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(kRows);
}

constexpr std::array<const char*, 5> kWholePlates{"whole.png", "whole.tif", "whole.hdr", "whole.exr", "deep.exr"};

constexpr const char* kCloud =
    "3, 2, 2 # points\n0.02, 0.02\n0.44, 0.48\ni, j, k, lwc, reff\n1, 1, 1, 0.2, 10\n3, 2, 2, 0.1, 12\n";

// All names that a preset may give; made once a folder.
const std::vector<std::string>& names_of(const fs::path& folder) {
  static const std::vector<std::string> names = [&] {
    write_plain_png(folder / "whole.png");
    write_tiff(folder / "whole.tif");
    write_radiance_picture(folder / "whole.hdr");
    write_plate(folder / "whole.exr", nullptr);
    write_deep_plate(folder / "deep.exr");
    Random bad(1);
    write_plate(folder / "spoiled.exr", &bad);
    const std::vector<char> png = bytes_of_file(folder / "whole.png");
    put(folder / "half.png", std::string(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(png.size() / 2)));
    put(folder / "curve.csv", "nm,value\n400,0.2\n700,0.4\n");
    put(folder / "mark.csv",
        "\xef\xbb\xbf"
        "400,0.2\n700,0.4\n");
    put(folder / "nan.csv", "400,nan\n700,0.4\n");
    put(folder / "words.csv", "a curve, they said\n\x01\x02\xff\n");
    put(folder / "long.csv", std::string(1U << 20U, '1'));
    put(folder / "large.csv", std::string((16U << 20U) + 1, ' '));
    put(folder / "phase.csv", "angle,value\n0,1\n90,1\n180,1\n");
    put(folder / "phase.pfn", "Date,0[442nm],180[442nm]\nx,1,1\n");
    put(folder / "map.null", "x");
    put(folder / "cloud.txt", kCloud);
    put(folder / "cloud.vdb", test::vdb_file(test::vdb_leaf()));
    put(folder / "words.vdb", "a cloud, they said\n");
    put(folder / "thick.txt", "1, 1, 2\n1e-4, 100\n0, 50\ni, j, k, lwc, reff\n1, 1, 1, 100, 1e-9\n");
    put(folder / "many.txt", "4096, 4096, 2\n0.02, 0.02\n0.4, 0.5\ni, j, k, lwc, reff\n1, 1, 1, 1, 10\n");
    put(folder / "empty", "");
    fs::create_directory(folder / "folder");
    fs::create_symlink("circle", folder / "circle");
    fs::create_symlink("/dev/zero", folder / "link");
    ::mkfifo((folder / "pipe").c_str(), 0600);
    std::vector<std::string> all{"/dev/zero", "/dev/null", "/dev/stdin", "/proc/self/mem",
                                 "none",      "",          "a\\u0000b",  ".."};
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      all.push_back(entry.path().filename().string());
    }
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

// Preset keys that name files, as assignments to which a name in quotes and what follows it are added.
struct FileKey {
  const char* before;
  const char* after;
  const char* good;  // a file that suits
};
constexpr std::array<FileKey, 10> kFileKeys{
    {{"/planet/ground_albedo={\"file\": ", "}", "curve.csv"},
     {"/media/0/scattering_per_km={\"file\": ", "}", "mark.csv"},
     {"/sun/spectrum={\"file\": ", "}", "curve.csv"},
     {"/media/0/phase={\"function\": \"table\", \"file\": ", "}", "phase.csv"},
     {"/planet/albedo_map=", "", "whole.png"},
     {"/planet/ocean={\"mask_map\": ", "}", "whole.tif"},
     {"/planet/terrain={\"width_km\": 10, \"height_map\": ", "}", "whole.hdr"},
     {"/planet/terrain={\"width_km\": 10, \"ridge\": {}, \"albedo_map\": ", "}", "whole.exr"},
     {"/clouds=[{\"type\": \"volume\", \"file\": ", "}]", "broken.txt"},
     {"/clouds=[{\"type\": \"volume\", \"base_km\": 1, \"file\": ", "}]", "broken.vdb"}}};

std::string absolute(const fs::path& folder, const std::string& name) {
  return name.empty() || name.front() == '/' ? name : (folder / name).string();
}

constexpr const char* kSmallPreset =
    R"({"airlight": 1, "media": [{"name": "air", "density": {"profile": "exponential", "scale_height_km": 8},
        "scattering_per_km": 0.01}], "image": {"width": 4, "height": 2}})";

Scene scene_with(const std::string& assignment) {
  Preset preset = parse_preset(kSmallPreset, "fuzz", {});
  apply_override(preset, assignment);
  return cli::judged(preset);
}

std::string fault_of(const foreign::Picture& picture) {
  std::size_t values = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.deep) {
    values = 0;
    for (const std::uint32_t count : picture.samples) values += count;
  }
  for (const foreign::Channel& channel : picture.channels) {
    if (channel.values.size() != values) {
      return "channel " + channel.name + " has " + std::to_string(channel.values.size()) + " values of " +
             std::to_string(values);
    }
  }
  return {};
}

std::string fault_of(const cli::Foreground& fore) {
  for (const composite::Thing& thing : fore.things) {
    if (!std::isfinite(thing.alpha) || !std::isfinite(thing.colour[0] + thing.colour[1] + thing.colour[2])) {
      return "light of a plate that is not finite";
    }
  }
  return fore.distances.size() == fore.things.size() ? "" : "a plate without all its distances";
}

}  // namespace

Outcome file_case(std::uint64_t seed, const fs::path& folder) {
  Random random(seed);
  const std::vector<std::string>& names = names_of(folder);
  const bool simple = random.chance(0.5);
  const std::string text = any_preset(random);
  std::vector<char> cloud(kCloud, kCloud + std::strlen(kCloud));
  if (random.chance(0.8)) {
    change_bytes(random, cloud);
  }
  put(folder / "broken.txt", std::string(cloud.begin(), cloud.end()));
  std::vector<char> voxels = bytes_of_file(folder / "cloud.vdb");
  if (random.chance(0.9)) {
    change_bytes(random, voxels);
  }
  put(folder / "broken.vdb", std::string(voxels.begin(), voxels.end()));
  std::vector<std::string> assignments;
  for (std::uint64_t count = 1 + random.below(2); count > 0; --count) {
    const FileKey& key = random.pick(kFileKeys);
    const std::string name = absolute(folder, random.chance(0.4) ? key.good : random.pick(names));
    const bool has_escape = name.find("\\u") != std::string::npos;
    assignments.push_back(key.before + (has_escape ? "\"" + name + "\"" : json_string(name)) + key.after);
  }
  Outcome outcome = guarded([&]() -> std::string {
    if (simple) {
      scene_with(assignments.front());
      return {};
    }
    Preset preset = parse_preset(text, "fuzz", folder);
    for (const std::string& assignment : assignments) {
      apply_override(preset, assignment);
    }
    cli::judged(preset);
    return {};
  });
  outcome.input = text;
  for (const std::string& assignment : assignments) {
    outcome.input += "\n--set " + assignment;
  }
  return outcome;
}

Outcome plate_case(std::uint64_t seed, const fs::path& folder) {
  Random random(seed);
  names_of(folder);
  const std::string whole = random.pick(kWholePlates);
  const bool spoils = whole == "whole.exr" && random.chance(0.5);
  const fs::path file = folder / ("broken" + fs::path(whole).extension().string());
  if (spoils) {
    write_plate(file, &random);
  } else {
    std::vector<char> bytes = bytes_of_file(folder / whole);
    change_bytes(random, bytes);
    put(file, std::string(bytes.begin(), bytes.end()));
  }
  Outcome outcome;
  add(outcome, guarded([&]() -> std::string { return fault_of(foreign::read_picture(file.string())); }));
  const std::string name = json_string(file.string());
  for (const FileKey& key : kFileKeys) {
    if (std::string(key.before).find("_map") != std::string::npos) {
      add(outcome, guarded([&]() -> std::string {
            scene_with(key.before + name + key.after);
            return {};
          }));
    }
  }
  if (file.extension() == ".exr") {
    // Its depth by itself, and the depth of another.
    for (const std::string& depth : {std::string(), (folder / "whole.exr").string() + ":Z"}) {
      add(outcome, guarded([&]() -> std::string {
            cli::CompositeOrder order;
            order.scale = random.chance(0.2) ? 1e-3 : 1.0;
            Scene scene = scene_with("/sun/elevation_deg=10");
            return fault_of(read_foreground(order, file.string(), depth, scene));
          }));
    }
  }
  // One in four reaches the picture: as the plate, or as a map of the planet before whose air a plate is put.
  if (random.chance(0.25)) {
    add(outcome, guarded([&]() -> std::string {
          const bool is_map = random.chance(0.5);
          const FileKey& key = kFileKeys[4 + random.below(2)];
          put(folder / "preset.json", kSmallPreset);
          cli::CompositeOrder order;
          order.scene.preset = (folder / "preset.json").string();
          order.scene.set = is_map ? std::vector{key.before + name + key.after} : std::vector<std::string>();
          order.beauty = is_map ? (folder / "whole.exr").string() : file.string();
          order.depth = (folder / "whole.exr").string() + ":Z";
          return fault_of_composite(order, folder);
        }));
  }
  const std::vector<char> bytes = bytes_of_file(file);
  outcome.input.assign(bytes.begin(), bytes.end());
  return outcome;
}

}  // namespace airlight::fuzz
