#include "core/stage/stage.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "core/base/on_demand.h"
#include "core/base/text.h"

namespace airlight {
namespace {

std::atomic<unsigned int> stages_made = 0;
std::atomic<unsigned int> airs_made = 0;

// "R 441.5 nm, G 548 nm, B 608 nm".
std::string channels_of(const ColourBasis& basis, const std::array<std::size_t, 3>& at) {
  std::string text;
  for (std::size_t c = 0; c < 3; ++c) {
    text += (c > 0 ? ", " : "") + std::string(1, "RGB"[c]) + " " + shortest(basis.nodes.nm[at[c]]) + " nm";
  }
  return text;
}

// Colours of transmittance, relative to sunlight above the air.
std::array<Rgb, 3> over_the_sun(std::array<Rgb, 3> colours, const Rgb& sun) {
  for (Rgb& colour : colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] /= sun[c];
    }
  }
  return colours;
}

// The same for a light of another spectrum than the sun's: relative to that light above the air.
std::array<Rgb, 3> over_the_light(std::array<Rgb, 3> colours, const Scene& part, const Scene& whole) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      colours[k][c] *= whole.sun.irradiance[c] > 0.0 ? part.sun.irradiance[k] / whole.sun.irradiance[c] : 0.0;
    }
  }
  return colours;
}

}  // namespace

struct Stage::Content {
  const SkyMethod& method;
  Part whole;
  std::function<PartSettings(const Part& whole)> of_parts;
  FitInputs inputs;
  OnDemand<ColourBasis> basis;
  mutable std::vector<Air> known;  // of another stage, until the parts are made
  mutable std::vector<Things> known_things;
  mutable std::once_flag once = {};
  mutable std::atomic<bool> made = false;
  mutable std::vector<Part> parts = {};
  std::function<std::vector<Stage>(const Stage&)> make_others = {};
  std::string light = {};
  mutable std::once_flag once_others = {};
  mutable std::vector<Stage> others = {};
  std::function<Night(const Air&)> night_at_wavelengths = {};
  mutable std::once_flag once_night = {};
  mutable std::optional<Night> night = {};

  void make_parts() const {
    const PartScenes scenes(whole.scene, basis.get());
    const PartSettings settings = of_parts(whole);
    for (std::size_t g = 0; g < scenes.count(); ++g) {
      Scene scene = scenes.scene(g);
      scene.render = settings.render;
      Air air = air_like(known, scene, settings.air);
      Things::Others like{&whole.things};
      for (const Things& things : known_things) {
        like.push_back(&things);
      }
      Things things(scene, like);
      const std::array<Rgb, 3> colours = scenes.colours(g);
      const std::array<Rgb, 3> shares = whole.scene.spectra->light ? over_the_light(colours, scene, whole.scene)
                                                                   : over_the_sun(colours, basis.get().sun);
      parts.push_back({std::move(scene), std::move(air), std::move(things), colours, shares,
                       " of group " + std::to_string(g), channels_of(basis.get(), scenes.nodes(g))});
    }
    known.clear();
    known_things.clear();
    made = true;
  }
};

const Scene& Stage::scene() const {
  return content_->whole.scene;
}

const SkyMethod& Stage::method() const {
  return content_->method;
}

const Part& Stage::whole() const {
  return content_->whole;
}

std::span<const Part> Stage::parts() const {
  if (!in_colours()) {
    return {&content_->whole, 1};
  }
  std::call_once(content_->once, [this] { content_->make_parts(); });
  return content_->parts;
}

std::span<const Stage> Stage::others() const {
  if (content_->make_others) {
    std::call_once(content_->once_others, [this] {
      parts();  // for their airs
      content_->others = content_->make_others(*this);
    });
  }
  return content_->others;
}

const Night* Stage::night() const {
  if (!scene().night_sky && !scene().stars) {
    return nullptr;
  }
  std::call_once(content_->once_night, [this] {
    if (content_->night_at_wavelengths) {
      content_->night = content_->night_at_wavelengths(whole().air);
      return;
    }
    NightAirs through;
    for (const Part& part : parts()) {
      through.airs.push_back(part.air);
    }
    if (in_colours()) {
      through.nm = basis().nodes.nm;
    }
    content_->night = night_of(scene(), through);
  });
  return &*content_->night;
}

const std::string& Stage::light() const {
  return content_->light;
}

const ColourBasis& Stage::basis() const {
  return content_->basis.get();
}

std::uint32_t Stage::scattering_media() const {
  std::uint32_t bits = 0;
  for (const Part& part : parts()) {
    bits |= part.air.scattering_media();
  }
  return bits;
}

std::vector<Air> StageMaker::airs_of(const Stage& stage) {
  std::vector<Air> airs{stage.whole().air};
  if (stage.content_->made) {
    for (const Part& part : stage.content_->parts) {
      airs.push_back(part.air);
    }
  }
  return airs;
}

Things::Others StageMaker::things_of(const Stage& stage) {
  Things::Others things{&stage.whole().things};
  if (stage.content_->made) {
    for (const Part& part : stage.content_->parts) {
      things.push_back(&part.things);
    }
  }
  return things;
}

Stage StageMaker::make() const {
  ++stages_made;
  std::vector<Air> known{whole.air};
  std::vector<Things> known_things;
  if (like != nullptr) {
    std::ranges::copy(airs_of(*like), std::back_inserter(known));
    for (const Things* things : things_of(*like)) {
      known_things.push_back(*things);
    }
  }
  const Scene& scene = whole.scene;
  FitInputs inputs;
  OnDemand<ColourBasis> basis;
  if (scene.spectra && listed) {
    basis = OnDemand<ColourBasis>([spectra = *scene.spectra, nodes = *listed] { return basis_at(spectra, nodes); });
  } else if (scene.spectra) {
    inputs = FitInputs(scene, whole.air.options().schlick);
    const bool same = like != nullptr && like->content_->basis && like->content_->inputs == inputs;
    basis = same ? like->content_->basis
                 : OnDemand<ColourBasis>([scene = scene, air = whole.air] { return fitted_basis(scene, air); });
  }
  return Stage(std::shared_ptr<const Stage::Content>(new Stage::Content{.method = method,
                                                                        .whole = whole,
                                                                        .of_parts = of_parts,
                                                                        .inputs = std::move(inputs),
                                                                        .basis = std::move(basis),
                                                                        .known = std::move(known),
                                                                        .known_things = std::move(known_things),
                                                                        .make_others = others,
                                                                        .light = light,
                                                                        .night_at_wavelengths = night}));
}

Air air_like(const std::vector<Air>& known, const Scene& scene, const AirOptions& options) {
  const auto same_matter = [&](const Air& air) { return air.media() == scene.media && air.planet() == scene.planet; };
  const auto same = [&](const Air& air) { return air.options() == options && same_matter(air); };
  if (const auto found = std::ranges::find_if(known, same); found != known.end()) {
    return *found;
  }
  if (const auto found = std::ranges::find_if(known, same_matter); found != known.end()) {
    return found->with(options);
  }
  ++airs_made;
  return {scene.media, scene.planet, options};
}

MadeSoFar made_so_far() {
  return {stages_made, airs_made};
}

}  // namespace airlight
