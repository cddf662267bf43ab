#include "core/choice/choose.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "core/choice/assumed_error.h"
#include "core/choice/leave_out.h"
#include "core/methods/ready.h"
#include "core/scene/thing_kinds.h"

namespace airlight::choice {
namespace {

constexpr std::size_t kProbes = 256;
constexpr std::size_t kTracedOf = 2;      // every second one
constexpr double kReferenceShare = 0.65;  // of a tolerance, that the reference's own error may take up

double mean_at_most(const measure::SampleError& measured) {
  constexpr double kSpreads = 2.0;
  return measured.mean + kSpreads * measured.spread;
}

Stage at_wavelengths(const Stage& stage, int wavelengths) {
  Scene scene = stage.scene();
  scene.spectra->wavelengths = wavelengths;
  return ready(scene, stage);
}

std::string percent_line(int wavelengths, double error) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "all but %d wavelengths: the mean error is at most %.2g %%", wavelengths,
                100.0 * error);
  return text.data();
}

void tell_darkness(Choice& choice) {
  if (choice.dark > 0.0) {
    choice.left_out.push_back("all light: nothing in the picture is brighter than 1e-15 of the sun's irradiance");
  }
}

// What every search begins with: lighter air, probe rays, tables that are there already. `enough`: what the reference
// may err and need not be judged.
struct Ground {
  const Scene& scene;
  const Looks& looks;
  Lighter lighter;
  Probes probes;
  std::vector<Candidate> made;  // their tables are there
  std::vector<float> truth;     // near it
  double known_error = 0.0;     // of the reference and of what was left out
  double dark = 0.0;
  Judge& judge;

  Ground(const Stage& wanted, double tolerance, double enough, const Looks& through, Probes at, Judge& judged_by)
      : scene(wanted.scene()),
        looks(through),
        lighter(leave_out_media(wanted, 0.25 * tolerance)),
        probes(std::move(at)),
        judge(judged_by) {
    known_error = lighter.error;
    // Tables among things are dear. There paths judge, at all wavelengths, and the scene's own will do.
    if (lighter.stage.in_colours() && !probes.directions.empty() && !stand_at_true_distance(scene)) {
      settle_wavelengths(tolerance);
    }
    made = {reference(lighter.stage, false)};
    if (probes.directions.empty()) {
      return;
    }
    if (truth.empty()) {
      truth = looks.probe(made.front().stage, probes);
    }
    const std::optional<double> known = plain_reference_error(lighter.stage);
    if (known && *known <= enough && !judge.was_asked()) {
      known_error += *known;
    } else {
      judge_reference(tolerance);
    }
  }

  // The fewest wavelengths, or those asked for, held against many more.
  void settle_wavelengths(double tolerance) {
    constexpr int kMany = 24;
    constexpr double kOfMany = 0.0005;  // what many are off all 48, over the skies of core/SPECTRA.md
    constexpr double kShare = 0.4;      // of a tolerance, that the spectrum may take up
    const int wished = lighter.stage.scene().spectra->wavelengths;
    if (wished == kMostWavelengths) {
      return;
    }
    const int many = wished < kMany ? kMany : kMostWavelengths;
    const std::vector<float> better = looks.probe(reference(at_wavelengths(lighter.stage, many), false).stage, probes);
    const double night = dark_radiance(lighter.stage.scene(), better);
    const std::vector<int> counts = wished != 0 ? std::vector<int>{wished} : std::vector<int>{3, 6, 12};
    double error = 0.0;
    for (const int count : counts) {
      lighter.stage = at_wavelengths(lighter.stage, count);
      truth = looks.probe(reference(lighter.stage, false).stage, probes);
      error = mean_at_most(measure::sample_error(truth, better, probes.weights, night)) + kOfMany;
      if (error <= kShare * tolerance) {
        break;
      }
    }
    known_error += error;
    lighter.reasons.push_back(percent_line(lighter.stage.scene().spectra->wavelengths, error));
  }

  // The plain reference, and the fine one where that may do better. What was left out and the wavelengths are in the
  // verdict.
  void judge_reference(double tolerance) {
    constexpr double kHopeless = 3.0;  // of the tolerance: finer tables do not mend as much
    const std::vector<float> plain = every(truth, kTracedOf);
    dark = judge.darkness(plain);
    if (dark > 0.0) {
      return;
    }
    Judgement verdict = judge.tell(plain, kReferenceShare);
    if (verdict.at_most > kReferenceShare * tolerance && verdict.at_least <= kHopeless * tolerance &&
        !judge.is_over()) {
      made.push_back(reference(lighter.stage, true));
      std::vector<float> better = looks.probe(made.back().stage, probes);
      const Judgement of_better = judge.told(every(better, kTracedOf));
      if (of_better.at_most < verdict.at_most) {
        verdict = of_better;
        truth = std::move(better);
      }
    }
    known_error = verdict.at_most;
  }

  // Against the reference, whose own error is known; of `orders` against path-trace as well, where that was asked.
  double bound_of(const Candidate& candidate) const {
    if (probes.directions.empty()) {
      return 0.0;  // nothing of the planet is in the picture
    }
    const std::vector<float> radiance = looks.probe(candidate.stage, probes);
    const double bound = error_bound(measure::sample_error(radiance, truth, probes.weights, dark), known_error);
    const bool judged = judge.was_asked() && dark == 0.0 && candidate.method == "orders";
    return judged ? std::min(bound, judge.told(every(radiance, kTracedOf)).at_most) : bound;
  }

  Choice begin() const {
    Choice choice;
    choice.probes = probes.directions.size();
    choice.traced = judge.was_asked() ? judge.probes().directions.size() : 0;
    choice.reference_error = known_error;
    choice.left_out = lighter.reasons;
    choice.dark = dark;
    tell_darkness(choice);
    return choice;
  }
};

void note(Choice& choice, const Tried& tried) {
  choice.tried.push_back(tried);
  if (!choice.best || tried.error < choice.best->error) {
    choice.best = tried;
  }
}

void settle(Choice& choice, const Candidate& candidate, const Tried& tried) {
  choice.chosen = candidate;
  choice.error = tried.error;
  choice.ms = tried.ms;
  choice.left_out.insert(choice.left_out.end(), candidate.left_out.begin(), candidate.left_out.end());
}

Choice only_choice(const Candidate& candidate, double error) {
  Choice choice;
  choice.reference_error = error;
  const Tried tried{candidate.method, candidate.quality, candidate.cost.total(), error, 0.0};
  note(choice, tried);
  settle(choice, candidate, tried);
  return choice;
}

// Tables among terrain cost as much as the picture: there the defaults are judged, and nothing else is tried.
bool only_defaults(const Stage& stage, const std::string& only) {
  return (only.empty() || only == "orders") && stage.scene().terrain;
}

bool default_will_do(const Stage& stage, const std::string& only) {
  return only_defaults(stage, only) || ((only.empty() || only == "orders") && !search_may_pay(stage));
}

// `orders` at its defaults, where that is sure to do and no search may pay: where nothing shines, that is black.
std::optional<Choice> sure_choice(const Stage& stage, double tolerance, const std::string& only) {
  if (default_will_do(stage, only) && std::ranges::max(stage.scene().sun.irradiance) <= 0.0) {
    return only_choice(default_candidate(stage), 0.0);
  }
  const std::optional<double> error = default_error(stage);
  if (!error || *error > tolerance || !default_will_do(stage, only)) {
    return std::nullopt;
  }
  return only_choice(default_candidate(stage), *error);
}

// The same, where path-trace says that it does; a refusal where nothing else is tried or the time is up.
std::optional<Choice> judged_choice(const Stage& stage, double tolerance, const std::string& only,
                                    const ProbeFunction& probe, Judge& judge) {
  if (!default_will_do(stage, only) || judge.probes().directions.empty()) {
    return std::nullopt;
  }
  const Candidate candidate = default_candidate(stage);
  const std::vector<float> radiance = probe(candidate.stage, judge.probes());
  const double dark = judge.darkness(radiance);
  const Judgement verdict = dark > 0.0 ? Judgement{} : judge.tell(radiance, 1.0);
  const bool refused = verdict.at_most > tolerance;
  if (refused && !only_defaults(stage, only) && !judge.is_over()) {
    return std::nullopt;
  }
  Choice choice = only_choice(candidate, verdict.at_most);
  if (refused) {
    choice.chosen.reset();
  }
  choice.probes = judge.probes().directions.size();
  choice.traced = choice.probes;
  choice.ran_out = refused && judge.is_over();
  choice.dark = dark;
  tell_darkness(choice);
  return choice;
}

// The dearest qualities of each method that should fit into the time: its cheapest one is timed, and the others are
// predicted from that by their costs.
std::vector<Candidate> likely_to_fit(const std::vector<Candidate>& all, double limit_ms, const TimeFunction& time,
                                     std::map<std::string, double>& fastest) {
  constexpr std::size_t kOfEach = 2;
  std::map<std::string, double> ms_per_cost;
  std::map<std::string, std::vector<Candidate>> fitting;
  for (const Candidate& candidate : all) {
    if (!ms_per_cost.contains(candidate.method)) {
      const double ms = time(candidate.stage);
      fastest[candidate.method] = ms;
      ms_per_cost[candidate.method] = ms / std::max(candidate.cost.total(), 1.0);
    }
    if (ms_per_cost[candidate.method] * candidate.cost.total() <= limit_ms) {
      fitting[candidate.method].push_back(candidate);
    }
  }
  std::vector<Candidate> likely;
  for (auto& [method, of_method] : fitting) {
    const std::size_t count = std::min(kOfEach, of_method.size());
    likely.insert(likely.end(), of_method.end() - static_cast<std::ptrdiff_t>(count), of_method.end());
  }
  return likely;
}

}  // namespace

double error_bound(const measure::SampleError& measured, double reference_error) {
  constexpr double kSafety = 1.1;
  return kSafety * mean_at_most(measured) + reference_error;
}

bool search_may_pay(const Stage& stage) {
  // In units of Cost, of which a core of the software device does some hundred million a second: twice what probes,
  // plans and the shaders of candidates take.
  constexpr double kSearch = 2e7;
  constexpr double kCheapestPixel = 2.0;
  const double pixels = static_cast<double>(stage.scene().image.width) * stage.scene().image.height;
  return default_candidate(stage).cost.picture - kCheapestPixel * pixels > kSearch;
}

Choice choose_for_tolerance(const Stage& stage, double tolerance, const std::string& only, const Looks& looks) {
  if (std::optional<Choice> choice = sure_choice(stage, tolerance, only)) {
    return *std::move(choice);
  }
  const Probes probes = choose_probes(stage.scene(), kProbes);
  Judge judge(stage, every(probes, kTracedOf), tolerance, looks.trace, looks.patience);
  if (std::optional<Choice> choice = judged_choice(stage, tolerance, only, looks.probe, judge)) {
    return *std::move(choice);
  }
  const Ground ground(stage, tolerance, kReferenceShare * tolerance, looks, probes, judge);
  Choice choice = ground.begin();
  const auto holds = [&](const Candidate& candidate) {
    const Tried tried{candidate.method, candidate.quality, candidate.cost.total(), ground.bound_of(candidate), 0.0};
    note(choice, tried);
    if (tried.error <= tolerance) {
      settle(choice, candidate, tried);
    }
    return tried.error <= tolerance;
  };
  for (const Candidate& candidate : candidates(ground.lighter.stage, tolerance, only, ground.made)) {
    if (!choice.tried.empty() && looks.is_up()) {
      choice.ran_out = true;
      break;
    }
    if (judge.is_over() && ground.known_error > tolerance) {
      const bool any = only.empty() || only == "orders";
      // More paths might find the reference better, but not what is too far from it.
      choice.ran_out = !holds(any ? default_candidate(ground.lighter.stage) : candidate) &&
                       choice.best->error - ground.known_error <= tolerance;
      break;
    }
    if (holds(candidate)) {
      break;
    }
  }
  return choice;
}

Choice choose_for_time(const Stage& stage, double limit_ms, const std::string& only, const Looks& looks,
                       const TimeFunction& time) {
  constexpr double kClose = 0.01;    // how well errors are told apart
  constexpr double kAnything = 1e9;  // that is known of the reference serves: no tolerance hangs on it
  const Probes probes = choose_probes(stage.scene(), kProbes);
  Judge judge(stage, every(probes, kTracedOf), kClose, looks.trace, looks.patience);
  const Ground ground(stage, kClose, kAnything, looks, probes, judge);
  Choice choice = ground.begin();
  std::map<std::string, double> fastest;
  std::vector<std::pair<Tried, Candidate>> ranked;
  // A picture's time holds its tables, whoever else has made them.
  const std::vector<Candidate> all = candidates(ground.lighter.stage, kClose, only, {});
  for (const Candidate& candidate : likely_to_fit(all, limit_ms, time, fastest)) {
    const Tried tried{candidate.method, candidate.quality, candidate.cost.total(), ground.bound_of(candidate), 0.0};
    ranked.emplace_back(tried, candidate);
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first.error; });
  for (auto& [tried, candidate] : ranked) {
    if (!choice.chosen) {
      tried.ms = time(candidate.stage);
    }
    note(choice, tried);
    if (!choice.chosen && tried.ms <= limit_ms) {
      settle(choice, candidate, tried);
    }
  }
  if (choice.chosen) {
    return choice;
  }
  choice.best.reset();
  for (const auto& [method, ms] : fastest) {
    if (!choice.best || ms < choice.best->ms) {
      choice.best = Tried{method, "its cheapest quality", 0.0, 0.0, ms};
    }
  }
  return choice;
}

}  // namespace airlight::choice
