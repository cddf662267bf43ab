#include "core/output/display.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/huge_pages.h"
#include "core/base/text.h"
#include "core/output/color_cube.h"
#include "core/output/embedded_config.h"
#include "core/output/parallel.h"
#include "core/scene/suggestion.h"

namespace airlight {
namespace {

namespace ocio = OCIO_NAMESPACE;

constexpr const char* kEmbeddedName = "the built-in config";
constexpr int kBlockPixels = 1 << 19;               // 8 MB as floats
constexpr std::size_t kFewestCubePixels = 1 << 16;  // below, a colour cube costs more than it saves

struct Config {
  ocio::ConstConfigRcPtr config;
  std::string name;  // for messages
};

Config open_embedded() {
  std::istringstream text(kEmbeddedConfig);
  return {ocio::Config::CreateFromStream(text), kEmbeddedName};
}

Config open_config(const std::string& asked) {
  std::string path = asked;
  std::string name = asked;
  if (path.empty()) {
    const char* const variable = std::getenv("OCIO");
    if (variable == nullptr || *variable == '\0') {
      return open_embedded();
    }
    path = variable;
    name = path + " (from $OCIO)";
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(name + ": no such OCIO config file; give a config.ocio, or none for " + kEmbeddedName);
  }
  try {
    return {ocio::Config::CreateFromFile(path.c_str()), name};
  } catch (const ocio::Exception& reason) {
    throw InputError(name + ": is not an OCIO config that OpenColorIO " + ocio::GetVersion() +
                     " can read: " + reason.what());
  }
}

// Checks a name, since OpenColorIO answers a wrong one with a message about colour spaces.
void require_name(const char* what, const std::string& name, const std::vector<std::string>& choices,
                  const std::string& where) {
  if (std::ranges::find(choices, name) != choices.end()) {
    return;
  }
  std::string message = std::string(what) + " '" + name + "' is not in " + where;
  const std::optional<std::string> nearest = nearest_name(name, choices);
  message += nearest ? "; did you mean '" + *nearest + "'?" : ".";
  throw InputError(message + " Choose one of " +
                   joined_of(choices, [](const std::string& choice) { return "'" + choice + "'"; }));
}

std::vector<std::string> displays_of(const ocio::Config& config) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumDisplays(); ++i) {
    names.emplace_back(config.getDisplay(i));
  }
  return names;
}

std::vector<std::string> views_of(const ocio::Config& config, const std::string& display) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumViews(display.c_str()); ++i) {
    names.emplace_back(config.getView(display.c_str(), i));
  }
  return names;
}

// The name of linear Rec.709 in the config; empty when it has none under a usual name.
std::string linear_rec709_in(const ocio::Config& config) {
  static constexpr std::array<const char*, 8> kUsualNames = {
      "Linear Rec.709 (sRGB)", "lin_rec709_srgb",         "lin_rec709",    "lin_srgb",
      "Linear Rec.709",        "Utility - Linear - sRGB", "Linear BT.709", "Utility - Linear - Rec.709"};
  for (const char* const name : kUsualNames) {
    if (config.getColorSpace(name) != nullptr) {
      return config.getColorSpace(name)->getName();
    }
  }
  return {};
}

// Transform from our scene-linear Rec.709 to a display and view. A config without that space is entered through
// ACES2065-1 if it says which space that is; else its scene_linear is assumed to be ours, with a warning.
ocio::ConstTransformRcPtr make_transform(const Config& config, const std::string& display, const std::string& view,
                                         std::string& warning) {
  auto to_view = ocio::DisplayViewTransform::Create();
  to_view->setDisplay(display.c_str());
  to_view->setView(view.c_str());
  const std::string linear = linear_rec709_in(*config.config);
  if (!linear.empty()) {
    to_view->setSrc(linear.c_str());
    return to_view;
  }
  if (config.config->hasRole("aces_interchange")) {
    auto to_ap1 = ocio::BuiltinTransform::Create();
    to_ap1->setStyle("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD");
    to_ap1->setDirection(ocio::TRANSFORM_DIR_INVERSE);
    auto to_ap0 = ocio::BuiltinTransform::Create();
    to_ap0->setStyle("ACEScg_to_ACES2065-1");
    to_view->setSrc("aces_interchange");
    auto all = ocio::GroupTransform::Create();
    all->appendTransform(to_ap1);
    all->appendTransform(to_ap0);
    all->appendTransform(to_view);
    return all;
  }
  if (!config.config->hasRole(ocio::ROLE_SCENE_LINEAR)) {
    throw InputError(config.name + ": names no linear Rec.709 space, and has neither the role aces_interchange nor " +
                     "scene_linear to reach one; add one of them to the config");
  }
  warning = config.name + ": has no linear Rec.709 space and no role aces_interchange; its role scene_linear (" +
            config.config->getColorSpace(ocio::ROLE_SCENE_LINEAR)->getName() + ") is taken to be linear Rec.709";
  to_view->setSrc(ocio::ROLE_SCENE_LINEAR);
  return to_view;
}

// None for a view of raw numbers.
std::optional<ColourCode> colours_of(const ocio::Config& config, const std::string& display, const std::string& view) {
  const char* const name = config.getDisplayViewColorSpaceName(display.c_str(), view.c_str());
  const ocio::ConstColorSpaceRcPtr space = config.getColorSpace(name);
  const bool data = space != nullptr && space->isData();
  return data ? std::nullopt : colour_code_of_display(display);
}

}  // namespace

struct DisplayTransform::State {
  DisplaySettings settings;
  std::string config_name, warning;
  ocio::ConstCPUProcessorRcPtr processor;
  std::optional<ColourCode> colours;

  void transform(std::span<float> rgba) const {
    ocio::PackedImageDesc pixels(rgba.data(), static_cast<long>(rgba.size() / 4), 1, 4);
    processor->apply(pixels);
  }
  bool interpolates(int width, int height) const {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return !settings.exact && settings.pixels.bits == 8 && pixels >= kFewestCubePixels;
  }
};

DisplayTransform::DisplayTransform(const DisplaySettings& settings) : state_(std::make_unique<State>()) {
  const Config config = open_config(settings.config);
  state_->settings = settings;
  state_->config_name = config.name;
  std::string& display = state_->settings.display;
  std::string& view = state_->settings.view;
  try {
    const std::vector<std::string> displays = displays_of(*config.config);
    if (displays.empty()) {
      throw InputError(config.name + ": defines no display; add one to the config");
    }
    if (display.empty()) {
      display = config.config->getDefaultDisplay();
    }
    require_name("display", display, displays, config.name);
    if (view.empty()) {
      view = config.config->getDefaultView(display.c_str());
    }
    require_name("view", view, views_of(*config.config, display), "display '" + display + "' of " + config.name);
    const auto transform = make_transform(config, display, view, state_->warning);
    state_->processor = config.config->getProcessor(transform)->getDefaultCPUProcessor();
    state_->colours = colours_of(*config.config, display, view);
  } catch (const ocio::Exception& reason) {
    throw InputError(config.name + ": view '" + view + "' of display '" + display +
                     "' cannot be used: " + reason.what());
  }
}

DisplayTransform::~DisplayTransform() = default;
DisplayTransform::DisplayTransform(DisplayTransform&&) noexcept = default;
DisplayTransform& DisplayTransform::operator=(DisplayTransform&&) noexcept = default;

const std::string& DisplayTransform::display() const {
  return state_->settings.display;
}
const std::string& DisplayTransform::view() const {
  return state_->settings.view;
}
const std::string& DisplayTransform::config() const {
  return state_->config_name;
}
const std::string& DisplayTransform::warning() const {
  return state_->warning;
}
std::optional<ColourCode> DisplayTransform::colours() const {
  return state_->colours;
}

PixelImage DisplayTransform::apply(const RadianceImage& image, const AddedLight& light, float exposure) const {
  PixelImage pixels = make_pixels(image.width, image.height, state_->settings.pixels);
  std::size_t done = 0;
  DisplayRows rows(*this, image.width, image.height, [&](const PixelImage& part) {
    std::ranges::copy(part.bytes, pixels.bytes.data() + (part.bits == 8 ? done : 0));
    std::ranges::copy(part.words, pixels.words.data() + (part.bits == 16 ? done : 0));
    done += part.bytes.size() + part.words.size();
  });
  rows.add(image, light, exposure);
  return pixels;
}

// Rows are gathered into blocks that depend only on the picture's size, since the blocks determine what the colour cube
// evaluates.
struct DisplayRows::State {
  const DisplayTransform::State& transform;
  int width, height;
  Sink sink;
  int block_rows;
  int y = 0;       // of the block's first row
  int filled = 0;  // rows of the block
  std::vector<float> block;
  std::optional<ColorCube> cube;

  std::size_t row_length() const { return 4 * static_cast<std::size_t>(width); }
  std::span<float> row(int of_block) {
    return std::span(block).subspan(static_cast<std::size_t>(of_block) * row_length(), row_length());
  }
  void fill(const RadianceImage& rows, const AddedLight& light, float exposure, int first, int count);
  void flush();
};

void DisplayRows::State::fill(const RadianceImage& rows, const AddedLight& light, float exposure, int first,
                              int count) {
  for_row_strips(count, [&](int from, int end) {
    for (int k = from; k < end; ++k) {
      const std::span<float> rgba = row(filled + k);
      const std::size_t start = row_length() * static_cast<std::size_t>(first + k);
      for (std::size_t i = 0; i < rgba.size(); ++i) {
        const float radiance = rows.rgba[start + i];
        const float sum = light.rgba == nullptr ? radiance : radiance + light.intensity * light.rgba[start + i];
        rgba[i] = i % 4 == 3 ? radiance : sum * exposure;
      }
    }
  });
  filled += count;
}

void DisplayRows::State::flush() {
  const ColorTransform exact = [this](std::span<float> rgba) { transform.transform(rgba); };
  if (cube) {
    cube->prepare(std::span(block).first(static_cast<std::size_t>(filled) * row_length()), exact);
  }
  const QuantizeOptions& options = transform.settings.pixels;
  PixelImage pixels = make_pixels(width, filled, options);
  for_row_strips(filled, [&](int first, int end) {
    for (int k = first; k < end; ++k) {
      if (cube) {
        cube->apply(row(k), exact);
      } else {
        exact(row(k));
      }
      quantize_row(row(k), y + k, options, pixels, y);
    }
  });
  sink(pixels);
  y += std::exchange(filled, 0);
}

DisplayRows::DisplayRows(const DisplayTransform& transform, int width, int height, Sink sink)
    : state_(std::make_unique<State>(State{*transform.state_,
                                           width,
                                           height,
                                           std::move(sink),
                                           std::clamp(kBlockPixels / width, 1, height),
                                           0,
                                           0,
                                           {},
                                           {}})) {
  const std::size_t values = state_->row_length() * static_cast<std::size_t>(state_->block_rows);
  state_->block.reserve(values);
  prefer_huge_pages(state_->block.data(), values * sizeof(float));
  state_->block.resize(values);
  if (state_->transform.interpolates(width, height)) {
    state_->cube.emplace();
  }
}

DisplayRows::~DisplayRows() = default;

void DisplayRows::add(const RadianceImage& rows, const AddedLight& light, float exposure) {
  for (int first = 0; first < rows.height;) {
    const int count = std::min(state_->block_rows - state_->filled, rows.height - first);
    state_->fill(rows, light, exposure, first, count);
    first += count;
    if (state_->filled == state_->block_rows || state_->y + state_->filled == state_->height) {
      state_->flush();
    }
  }
}

}  // namespace airlight
