#include <cctype>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/library/built_in.h"
#include "core/library/errors.h"
#include "core/library/judged.h"
#include "core/library/scene_state.h"
#include "core/methods/method.h"
#include "core/scene/resolve.h"

namespace airlight {
namespace {

foreign::Picture refused_picture(const std::string& file, const foreign::Accept&) {
  throw InputError(file +
                   ": libairlight reads no pictures; render this preset by the command-line tool, or remove the "
                   "key");
}

foreign::Voxels refused_voxels(const std::string& file, const std::string&, std::size_t) {
  throw InputError(file +
                   ": libairlight reads no files of OpenVDB; render this preset by the command-line tool, or "
                   "remove the cloud");
}

// A message about the command line's options as one about keywords: "render: --place-altitude" is "place_altitude".
std::string about_keywords(const std::string& message) {
  constexpr std::string_view kCommand = "render: ";
  std::string out;
  bool in_option = false;
  for (std::size_t i = message.starts_with(kCommand) ? kCommand.size() : 0; i < message.size(); ++i) {
    if (message.compare(i, 2, "--") == 0) {
      in_option = true;
      ++i;
    } else {
      in_option = in_option && (message[i] == '-' || std::isalpha(static_cast<unsigned char>(message[i])) != 0);
      out += in_option && message[i] == '-' ? '_' : message[i];
    }
  }
  return out;
}

template <class Work>
auto in_keywords(const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(about_keywords(error.what()));
  }
}

}  // namespace

namespace v0 {

airlight::Scene Scene::State::judged(const airlight::Scene* like) const {
  std::vector<Override> all = in_keywords([&] { return sun_overrides(place, changes, "render"); });
  all.insert(all.end(), further.begin(), further.end());
  Preset changed = preset;
  apply_changes(changed, changes, all);
  if (place.date) {
    leave_out_unseen(changed);
  }
  const airlight::Scene scene = airlight::judged(changed, {refused_picture, refused_voxels}, like);
  in_keywords([&] { require_one_refraction(place, scene, "render"); });
  return scene;
}

static_assert(AIRLIGHT_VERSION_MAJOR == AIRLIGHT_MAJOR && AIRLIGHT_VERSION_MINOR == AIRLIGHT_MINOR &&
                  AIRLIGHT_VERSION_PATCH == AIRLIGHT_PATCH,
              "the installed header has another version than the project");

InputError::InputError(const std::string& message) : std::runtime_error(message) {}
InputError::~InputError() = default;
RunError::RunError(const std::string& message) : std::runtime_error(message) {}
RunError::~RunError() = default;

std::string version() {
  return std::to_string(AIRLIGHT_MAJOR) + "." + std::to_string(AIRLIGHT_MINOR) + "." + std::to_string(AIRLIGHT_PATCH);
}

std::vector<std::string> presets() {
  return built_in_names();
}

std::string preset_text(const std::string& name) {
  return translated([&] { return to_json(resolve(built_in_preset(name, "presets()"), method_infos())); });
}

std::vector<std::string> option_names() {
  return change_names();
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(const Scene& other) : state_(std::make_unique<State>(*other.state_)) {}
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) {
  state_ = std::make_unique<State>(*other.state_);
  return *this;
}
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

Scene& Scene::set(const std::string& pointer, const std::string& value) {
  translated([&] {
    const std::string assignment = pointer + "=" + value;
    Preset tried = state_->preset;  // a pointer that leads nowhere is refused here, where it stands
    apply_override(tried, assignment, "set " + assignment);
    std::erase_if(state_->changes.set, [&](const std::string& earlier) { return earlier.starts_with(pointer + "="); });
    state_->changes.set.push_back(assignment);
  });
  return *this;
}

Scene& Scene::option(const std::string& name, const std::string& value) {
  translated([&] { set_option(state_->changes, state_->further, state_->place, name, value); });
  return *this;
}

void Scene::check() const {
  translated([&] { state_->judged(nullptr); });
}

std::string Scene::json() const {
  return translated([&] { return to_json(state_->judged(nullptr)); });
}

}  // namespace v0
}  // namespace airlight
