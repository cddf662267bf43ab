#pragma once
// The cheapest method and quality whose error stays below a tolerance, or the most accurate that fits a time: measured
// at a few directions of the picture at hand.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/choice/candidates.h"
#include "core/choice/judge.h"
#include "core/choice/probes.h"
#include "core/measure/sample_error.h"

namespace airlight::choice {

// RGB, three values a direction, of the stage's method as its picture would have them there.
using ProbeFunction = std::function<std::vector<float>(const Stage& stage, const Probes& probes)>;

// What a choice looks at a scene through.
struct Looks {
  ProbeFunction probe;
  TraceFunction trace;
  PatienceFunction patience = [] { return kLongPatience; };
  // Whether the whole search has had its time; asked before each quality that is tried after the first.
  std::function<bool()> is_up = [] { return false; };
};

struct Tried {
  std::string method;
  std::string quality;
  double cost = 0.0;   // predicted, in steps of `march`
  double error = 0.0;  // bound on the mean relative error of the picture
  double ms = 0.0;     // measured, where a time limit asked for it and nothing more accurate had fitted
};

struct Choice {
  std::optional<Candidate> chosen;  // none: nothing is within the tolerance or the time
  double error = 0.0;               // of the chosen, as in Tried
  double ms = 0.0;
  double reference_error = 0.0;  // what of it is the reference's own, and what was left out of the air
  std::vector<Tried> tried;      // in order
  std::optional<Tried> best;     // of those: the smallest error
  std::size_t probes = 0;
  std::size_t traced = 0;  // probes that path-trace judged
  bool ran_out = false;    // time was up before anything was sure to do; the same choice again goes on
  std::vector<std::string> left_out;
  double dark = 0.0;  // dark_radiance() of the picture
};

// A tolerance is of the mean relative error over the picture without the sun's disc; see measure::sample_error(). Where
// `orders` at its defaults is sure to hold it and no search may pay, nothing is probed. Where nothing that is fine
// enough is known of the reference, path-trace judges it.
Choice choose_for_tolerance(const Stage& stage, double tolerance, const std::string& only, const Looks& looks);

// `time`: ms that the device takes for the scene's tables and picture.
using TimeFunction = std::function<double(const Stage& stage)>;
Choice choose_for_time(const Stage& stage, double limit_ms, const std::string& only, const Looks& looks,
                       const TimeFunction& time);

// The bound that a tolerance is held against, from what the probes say and what is known of the reference.
double error_bound(const measure::SampleError& measured, double reference_error);

// Whether what a search may save is more than it costs: not where the pixels of `orders` at its defaults are fetches
// from a table, nor for a small picture.
bool search_may_pay(const Stage& stage);

}  // namespace airlight::choice
