// freeze_presets OUT.cpp PRESET.json...: the frozen modules that these presets ask for, as C++ that defines
// ready_modules(). Plans are data, so no device is opened. The folder OUT.cpp.kept keeps the modules for the next
// build: most of them are the same when a source changes.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/in_parallel.h"
#include "core/gpu/frozen_modules.h"
#include "core/gpu/shader.h"
#include "core/methods/ready.h"
#include "core/render/render.h"
#include "core/scene/resolve.h"

namespace {

using namespace airlight;
using Module = std::pair<std::string, std::vector<ConstantValue>>;  // shader, values

struct Wanted {
  std::map<Module, std::vector<std::uint32_t>> modules;
  std::mutex mutex;
};

struct Shaders {
  Shaders() {
    for (const EmbeddedShader& shader : embedded_shaders()) {
      sources.emplace(shader.name, shader);
      infos.emplace(shader.name, reflect(shader.name, shader.spirv));
    }
  }
  std::map<std::string, EmbeddedShader, std::less<>> sources;
  std::map<std::string, ShaderInfo, std::less<>> infos;
};

// Collects the modules for processors and for other devices, which share a point among threads.
void want(const Plan& plan, const Shaders& shaders, Wanted& wanted) {
  for (const PassDesc& pass : plan.passes()) {
    for (const bool teams : {false, true}) {
      const MatchedPass matched = match(plan, pass, shaders.infos.at(pass.shader), teams);
      const std::scoped_lock lock(wanted.mutex);
      wanted.modules.try_emplace({pass.shader, matched.constants});
    }
  }
}

Plan listed_directions(const Stage& given) {
  const Stage stage = without_filter(given);
  const std::vector<Direction> directions(2);
  Plan plan;
  plan.scene_data = device_scene_bytes(stage.whole().air, stage.scene());
  stage.method().add_passes(plan, stage.whole(), probe_view(stage, directions));
  return plan;
}

// Replaces the scene's terrain by a level map of few heights. The heights and their shadow take most of a second each,
// but they are contents of buffers, which a module does not depend on.
void level_terrain(Scene& scene) {
  if (!scene.terrain) return;
  TerrainFiles files;
  files.columns = 4;
  files.rows = 4;
  files.heights.assign(16, 0.0F);
  files.heights.front() = 1.0F;
  scene.terrain->ridge.reset();
  scene.terrain->files = std::make_shared<const TerrainFiles>(std::move(files));
}

// Stars are contents of a buffer too, and in bent light each is placed anew for every plan: the brightest do.
constexpr double kBrightStars = 3.0;

// Collects the modules that `render`, `sequence`, `luts` and `probe` need: pictures small and large, the sun on either
// side of the horizon, an EXR alone, a picture by OpenColorIO and one by the tone curve on the device.
void want_all_of(const std::string& preset, const Shaders& shaders, Wanted& wanted) {
  Scene own = resolve(load_preset(preset), method_infos());
  level_terrain(own);
  if (own.stars) own.stars->magnitude_limit = std::min(own.stars->magnitude_limit, kBrightStars);
  if (find_method(own.render.method)->add_passes == nullptr) return;
  const Stage stage = ready(own);
  constexpr double kLowSun = -0.1;  // radians
  for (const double sun : {own.sun.elevation, kLowSun, 0.5}) {
    for (const ImageSize size : {own.image, ImageSize{1, 1}, ImageSize{1280, 720}}) {
      Scene scene = own;
      scene.sun.elevation = sun;
      scene.image = size;
      const Stage changed = ready(scene, stage);
      for (int choice = 0; choice < 8; ++choice) {
        RenderRequest request;
        request.bloom = (choice & 1) != 0;
        request.bloom_picture = (choice & 2) != 0;
        request.gpu_tone = (choice & 4) != 0;
        want(plan_for(changed, request), shaders, wanted);
      }
    }
    want(listed_directions(stage), shaders, wanted);
  }
}

void freeze(const Shaders& shaders, Wanted& wanted, const FrozenModules& kept) {
  std::vector<std::pair<const Module, std::vector<std::uint32_t>>*> modules;
  for (auto& module : wanted.modules) modules.push_back(&module);
  in_parallel(modules.size(), [&](std::size_t i) {
    const auto& [shader, values] = modules[i]->first;
    bool made = false;
    const FrozenModules::Words words = kept.get(shaders.sources.at(shader), values, made);
    modules[i]->second.assign(words.get().begin(), words.get().end());
  });
  kept.trim();
}

std::string source_text(const Shaders& shaders, const Wanted& wanted) {
  std::string arrays;
  std::string entries;
  std::size_t count = 0;
  char digits[16];
  for (const auto& [module, words] : wanted.modules) {
    const std::string name = "kModule" + std::to_string(count++);
    arrays += "// " + module.first + "\nconstexpr std::uint32_t " + name + "[] = {";
    for (std::size_t i = 0; i < words.size(); ++i) {
      std::snprintf(digits, sizeof digits, "0x%x,", words[i]);
      arrays += (i % 12 == 0 ? "\n" : "") + std::string(digits);
    }
    arrays += "};\n";
    entries += "    {{";
    for (const std::uint8_t byte : module_key(shaders.sources.at(module.first).digest, module.second)) {
      std::snprintf(digits, sizeof digits, "0x%02x,", byte);
      entries += digits;
    }
    entries += "},\n     " + name + "},\n";
  }
  return "// Made by freeze_presets.\n#include \"core/gpu/ready_modules.h\"\n\nnamespace airlight {\nnamespace {\n" +
         arrays + "const ReadyModule kModules[] = {\n" + entries + "};\n}  // namespace\n\n" +
         "std::span<const ReadyModule> ready_modules() {\n  return kModules;\n}\n\n}  // namespace airlight\n";
}

int run(std::span<const char* const> arguments) {
  const Shaders shaders;
  Wanted wanted;
  const std::span<const char* const> presets = arguments.subspan(1);
  in_parallel(presets.size(), [&](std::size_t i) { want_all_of(presets[i], shaders, wanted); });
  freeze(shaders, wanted, FrozenModules(std::filesystem::absolute(std::string(arguments[0]) + ".kept")));
  std::ofstream out(arguments[0]);
  out << source_text(shaders, wanted);
  out.close();
  if (!out) {
    std::fprintf(stderr, "freeze_presets: %s cannot be written\n", arguments[0]);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: freeze_presets OUT.cpp PRESET.json...\n", stderr);
    return 2;
  }
  try {
    return run(std::vector<const char*>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "freeze_presets: %s\n", error.what());
    return 1;
  }
}
