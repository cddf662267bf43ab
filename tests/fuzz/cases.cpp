#include "tests/fuzz/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "core/methods/method.h"
#include "core/output/exr.h"
#include "core/output/finite.h"
#include "core/output/frame_state.h"
#include "core/output/picture_reader.h"
#include "core/render/render.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/printable.h"
#include "core/scene/resolve.h"
#include "core/scene/rules.h"
#include "core/things/ground.h"
#include "tests/fuzz/any_preset.h"
#include "tests/fuzz/guarded.h"
#include "tests/of_scene.h"

namespace airlight::fuzz {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' || c == '-' || c == '_';
}

// Strings with their quotes, words and numbers; every other character by itself.
Words tokens_of(const std::string& text) {
  Words tokens;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text[i] == '"') {
      while (end < text.size() && text[end] != '"') {
        ++end;
      }
      end = std::min(end + 1, text.size());
    } else if (is_word(text[i])) {
      while (end < text.size() && is_word(text[end])) {
        ++end;
      }
    }
    tokens.push_back(text.substr(i, end - i));
    i = end;
  }
  return tokens;
}

const Words& dictionary() {
  static const Words words = [] {
    Words list = {"{",
                  "}",
                  "[",
                  "]",
                  ",",
                  ":",
                  "null",
                  "true",
                  "false",
                  "0",
                  "-0.0",
                  "1",
                  "-1",
                  "5e-324",
                  "1e308",
                  "1e999",
                  "2147483648",
                  "-2147483649",
                  "1e-45",
                  "1e38",
                  "0.1",
                  "\"\"",
                  "\"auto\"",
                  "\"\\u001b[31m\"",
                  "\"\\n\"",
                  "\"\\u202e\"",
                  "\"\\ud800\"",
                  "/*",
                  "*/",
                  "//",
                  "\n",
                  "\x1b",
                  "\xff",
                  "\xc2\x9b",
                  "\"",
                  "\"extends\"",
                  "\"../a\"",
                  "\"/\"",
                  "\"~\"",
                  "\"media\"",
                  "\"sequence\"",
                  "\"frames\"",
                  "\"at\"",
                  "\"/sun/elevation_deg\"",
                  "\"/media/0/name\"",
                  "\"/media\"",
                  "\"interpolation\"",
                  "\"x\":1",
                  std::string(3000, '9'),
                  "\"" + std::string(5000, 'k') + "\""};
    for (const Rule& rule : rules()) {
      list.push_back(json_string(rule.key.substr(rule.key.rfind('.') + 1)));
      for (const std::string_view choice : rule.choices) {
        list.push_back(json_string(choice));
      }
    }
    for (const MethodInfo& method : method_infos()) {
      list.push_back(json_string(method.name));
      for (const ParameterInfo& parameter : method.parameters) {
        list.push_back(json_string(parameter.key));
      }
    }
    return list;
  }();
  return words;
}

std::string changed(Random& random, const std::string& text) {
  Words tokens = tokens_of(text);
  for (std::uint64_t changes = random.below(8); changes > 0 && !tokens.empty(); --changes) {
    const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(random.below(tokens.size()));
    switch (random.below(14)) {
      case 0:
        tokens.erase(at);
        break;
      case 1: {
        const std::string copy = *at;
        tokens.insert(at, copy);
        break;
      }
      case 2:
        std::swap(*at, tokens[random.below(tokens.size())]);
        break;
      case 3:
        tokens.insert(at, random.pick(dictionary()));
        break;
      case 4:
        *at = random.pick(dictionary());
        break;
      default: {  // a number becomes another, a string another: what stays JSON
        const std::string other = random.pick(dictionary());
        if (!other.empty() && (is_word(other[0]) ? is_word((*at)[0]) : other.size() > 2 && other[0] == (*at)[0])) {
          *at = other;
        }
        break;
      }
    }
  }
  std::string out;
  for (const std::string& token : tokens) {
    out += token;
  }
  return out;
}

std::string fault_of_picture(const Rendering& rendering) {
  if (std::string fault = rendering.fault(); !fault.empty()) {
    return fault;
  }
  if (!std::isfinite(rendering.exposure) || !(rendering.exposure > 0.0)) {
    return "the exposure is no positive number";
  }
  for (const std::optional<RadianceImage>* image : {&rendering.bloom, &rendering.standard_error}) {
    if (*image && !std::ranges::all_of((*image)->rgba, [](float x) { return std::isfinite(x) && x >= 0.0f; })) {
      return image == &rendering.bloom ? "the glow is not finite" : "the standard error is not finite";
    }
  }
  return {};
}

const std::vector<char>& whole_exr(const fs::path& folder) {
  static const std::vector<char> bytes = [&] {
    const Scene scene = resolve(parse_preset(R"({"airlight": 1, "media": [{"name": "air", "density":
      {"profile": "exponential", "scale_height_km": 8}}]})",
                                             "whole", {}),
                                method_infos());
    const RadianceImage image{8, 6, std::vector<float>(8 * 6 * 4, 0.5f)};
    std::vector<ExrChannel> channels;
    add_channels(channels, "", image, true);
    add_channels(channels, "bloom", image);
    ExrOptions options;
    options.provenance = {to_json(scene), "march", "1", "device"};
    options.comments = "made to be broken";
    const fs::path file = folder / "whole.exr";
    write_exr(file, image.width, image.height, channels, options);
    std::ifstream in(file, std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(in), {});
  }();
  return bytes;
}

std::vector<float> any_values(Random& random, std::size_t count) {
  std::vector<float> values(count);
  std::generate(values.begin(), values.end(), [&] { return static_cast<float>(random.uniform(0.0, 1.0)); });
  return values;
}

// Possible contents of the files named in the preset.
void fill_maps(Scene& scene, std::uint64_t seed) {
  Random random(~seed);
  if (scene.terrain && (!scene.terrain->height_map.empty() || !scene.terrain->albedo_map.empty())) {
    auto files = std::make_shared<TerrainFiles>();
    files->identity = "fuzz " + std::to_string(seed);
    files->columns = 2 + static_cast<int>(random.below(40));
    files->rows = 2 + static_cast<int>(random.below(40));
    if (!scene.terrain->height_map.empty()) {
      files->heights =
          any_values(random, static_cast<std::size_t>(files->columns) * static_cast<std::size_t>(files->rows));
    }
    if (!scene.terrain->albedo_map.empty()) {
      files->colour_columns = files->colour_rows = 1 + static_cast<int>(random.below(9));
      files->colours = any_values(random, 3 * static_cast<std::size_t>(files->colour_columns * files->colour_rows));
    }
    scene.terrain->files = files;
  }
  if (scene.ground) {
    auto files = std::make_shared<GroundFiles>();
    files->identity = "fuzz " + std::to_string(seed);
    if (!scene.ground->albedo_map.empty()) {
      files->colour_rows = 1 + static_cast<int>(random.below(30));
      files->colours = any_values(random, 6 * static_cast<std::size_t>(files->colour_rows * files->colour_rows));
      scene.planet.ground_albedo = mean_albedo(*files);
    }
    if (scene.ground->ocean && !scene.ground->ocean->mask_map.empty()) {
      files->water_rows = 1 + static_cast<int>(random.below(30));
      files->water = any_values(random, 2 * static_cast<std::size_t>(files->water_rows * files->water_rows));
    }
    scene.ground->files = files;
  }
}

Executor& device() {
  static Executor executor{{}};
  return executor;
}

}  // namespace

std::string fault_of_message(const std::string& message) {
  constexpr std::size_t kLongest = (kMostProblems + 1) * 700;
  if (message.empty()) {
    return "an empty message";
  }
  if (message.size() > kLongest || static_cast<std::size_t>(std::ranges::count(message, '\n')) > kMostProblems) {
    return "a message of " + std::to_string(message.size()) + " bytes";
  }
  return printable(message, true) == message ? "" : "a message that a terminal obeys";
}

void add(Outcome& outcome, const Outcome& part) {
  outcome.fault = outcome.fault.empty() ? part.fault : outcome.fault;
  outcome.refused = outcome.refused || part.refused;
  outcome.message += part.message.empty() ? "" : part.message + " | ";
}

std::string fault_of_composite(cli::CompositeOrder order, const fs::path& folder) {
  order.scene.no_cache = true;
  order.output = (folder / "composite.exr").string();
  order.quiet = true;
  cli::run_composite(order);
  const ExrPicture made = read_exr_picture(order.output);
  return finite_fault("the composite", made.radiance.rgba, static_cast<std::size_t>(made.radiance.width), 4);
}

void change_bytes(Random& random, std::vector<char>& bytes) {
  for (std::uint64_t changes = 1 + random.below(3); changes > 0 && !bytes.empty(); --changes) {
    const auto at = static_cast<std::ptrdiff_t>(
        random.below(random.chance(0.7) ? std::min<std::size_t>(bytes.size(), 900) : bytes.size()));
    switch (random.below(20)) {
      case 0:
        bytes.resize(static_cast<std::size_t>(at));
        break;
      case 1:
        bytes.insert(bytes.begin() + at, static_cast<char>(random.below(256)));
        break;
      case 2:
        bytes.erase(bytes.begin() + at);
        break;
      default:
        bytes[static_cast<std::size_t>(at)] = static_cast<char>(
            random.chance(0.3) ? random.pick(std::array{0, 1, 127, 128, 255}) : static_cast<int>(random.below(256)));
        break;
    }
  }
}

Outcome text_case(std::uint64_t seed) {
  Random random(seed);
  const std::string text = changed(random, any_preset(random));
  Outcome outcome = guarded([&]() -> std::string {
    const Scene scene = resolve(parse_preset(text, "fuzz", "/nonexistent"), method_infos());
    const std::string again = to_json(scene);
    const Scene same = resolve(parse_preset(again, "again", {}), method_infos());
    return to_json(same) == again ? "" : "the scene's own text gives another scene";
  });
  outcome.input = text;
  return outcome;
}

Outcome exr_case(std::uint64_t seed, const fs::path& folder) {
  Random random(seed);
  std::vector<char> bytes = whole_exr(folder);
  change_bytes(random, bytes);
  const fs::path file = folder / "broken.exr";
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  Outcome outcome;
  add(outcome, guarded([&]() -> std::string {
        is_exr(file);
        const Provenance provenance = read_provenance(file);
        resolve(parse_preset(provenance.preset_json, file.string(), {}), method_infos());
        return {};
      }));
  add(outcome, guarded([&]() -> std::string {
        read_frame_mark(file);
        return {};
      }));
  add(outcome, guarded([&]() -> std::string {
        const ExrPicture picture = read_exr_picture(file);
        const auto pixels =
            static_cast<std::size_t>(picture.radiance.width) * static_cast<std::size_t>(picture.radiance.height);
        return picture.radiance.rgba.size() == 4 * pixels ? "" : "a picture without all its pixels";
      }));
  outcome.input.assign(bytes.begin(), bytes.end());
  return outcome;
}

std::string scene_text(std::uint64_t seed) {
  Random random(seed);
  return any_preset(random);
}

Outcome scene_case(std::uint64_t seed) {
  const std::string text = scene_text(seed);
  Outcome outcome = guarded([&]() -> std::string {
    Scene scene = resolve(parse_preset(text, "fuzz", {}), method_infos());
    fill_maps(scene, seed);
    RenderRequest request;
    request.bloom = true;
    request.gpu_tone = seed % 4 == 0;
    const SkyMethod& method = *find_method(scene.render.method);
    if (method.add_layer_passes != nullptr && seed % 5 == 0) {
      request.layers = seed % 2 == 0 ? LayerSet::light : LayerSet::stokes;
    }
    request.host.threads = 1;
    return fault_of_picture(render([]() -> Executor& { return device(); }, scene, request));
  });
  outcome.input = text;
  return outcome;
}

namespace {

const DeviceOnDemand kDevice = []() -> Executor& { return device(); };

// A plate for composite_case, of one pixel's size with the preset's picture.
void write_any_plate(Random& random, const fs::path& file, int width, int height) {
  constexpr std::array kOdd{NAN, INFINITY, -INFINITY, -1.0F, 0.0F, 1e-40F};
  std::array<std::vector<float>, 5> planes;
  std::vector<ExrChannel> channels;
  for (std::size_t c = 0; c < planes.size(); ++c) {
    for (int i = 0; i < width * height; ++i) {
      const double most = c == 4 ? 1e6 : 1.0;
      planes[c].push_back(random.chance(0.2) ? random.pick(kOdd)
                                             : static_cast<float>(random.log_uniform(1e-3 * most, most)));
    }
    channels.push_back({std::string(1, "RGBAZ"[c]), planes[c].data(), 1, true});
  }
  ExrOptions options;
  options.half = false;
  write_exr(file, width, height, channels, options);
}

std::string fault_of_plates(Random& random, const std::string& preset, const fs::path& folder) {
  const fs::path plate = folder / "plate.exr";
  const fs::path depth = folder / "depth.exr";
  write_any_plate(random, plate, 6, 4);
  write_any_plate(random, depth, 6, 4);
  const fs::path file = folder / "preset.json";
  std::ofstream(file) << preset;
  cli::CompositeOrder order;
  order.scene.preset = file.string();
  order.beauty = plate.string();
  order.depth = random.chance(0.5) ? depth.string() + ":Z" : "";
  order.layers = random.chance(0.5) ? "inscatter,transmittance" : "";
  order.aerial = random.chance(0.3) ? "volume" : "";
  order.fog = random.chance(0.1) ? "height" : "";
  return fault_of_composite(order, folder);
}

std::string fault_of_tables(const Scene& scene) {
  for (const TableDump& table : bake_tables(kDevice, scene)) {
    const std::string fault = finite_fault(table.name, table.rgba, static_cast<std::size_t>(table.width), 4);
    if (!fault.empty()) {
      return "luts: " + fault;
    }
  }
  return {};
}

std::string fault_of_directions(Random& random, const Scene& scene) {
  std::vector<Direction> directions{{0.5 * std::numbers::pi, 0.0}, {-0.5 * std::numbers::pi, 1.0}};
  for (int i = 0; i < 4; ++i) {
    directions.push_back({random.uniform(-1.57, 1.57), random.uniform(-4.0, 4.0)});
  }
  for (const ProbeResult& result : probe(kDevice, scene, directions).directions) {
    for (const double value : {result.radiance[0], result.radiance[1], result.radiance[2], result.transmittance[0],
                               result.transmittance[1], result.transmittance[2]}) {
      if (!std::isfinite(value) || (value < 0.0 && !scene.spectra)) {
        return "probe: " + std::to_string(value);
      }
    }
  }
  return {};
}

}  // namespace

Outcome method_case(std::uint64_t seed, const fs::path& folder) {
  Random random(~seed);
  const std::string text = scene_text(seed);
  Outcome outcome;
  outcome.refused = true;  // until a method takes it
  for (const SkyMethod& method : methods()) {
    const std::string name(method.info.name);
    const auto part = [&](const std::string& what, const std::function<std::string(const Scene&)>& work) {
      const double before = processor_seconds();
      const Outcome done = guarded([&]() -> std::string {
        Preset preset = parse_preset(text, "fuzz", {});
        apply_override(preset, "/render={\"method\": " + json_string(name) +
                                   (method.render_on_host != nullptr ? ", \"samples\": 4}" : "}"));
        Scene scene = resolve(preset, method_infos());
        fill_maps(scene, seed);
        return work(scene);
      });
      outcome.seconds = std::max(outcome.seconds, processor_seconds() - before);
      outcome.refused = outcome.refused && done.refused;
      outcome.fault = outcome.fault.empty() && !done.fault.empty() ? name + ", " + what + done.fault : outcome.fault;
      outcome.message += done.message.empty() ? "" : name + ": " + done.message + " | ";
    };
    part("", [&](const Scene& scene) {
      RenderRequest request;
      request.host.threads = 1;
      return fault_of_picture(render(kDevice, scene, request));
    });
    part("", [&](const Scene& scene) { return fault_of_directions(random, scene); });
    if (method.add_passes != nullptr) {
      part("", fault_of_tables);
    }
    if (method.add_span_passes != nullptr) {
      part("composite: ", [&](const Scene& scene) { return fault_of_plates(random, to_json(scene), folder); });
    }
  }
  outcome.input = text;
  return outcome;
}

}  // namespace airlight::fuzz
