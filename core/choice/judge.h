#pragma once
// How wrong a picture is by path-trace, at some of its pixels: what a choice looks at where nothing is known of the
// scene beforehand.

#include <functional>
#include <span>
#include <vector>

#include "core/choice/probes.h"
#include "core/measure/sample_error.h"

namespace airlight::choice {

// The probes' radiance by path-trace, of all that the scene holds.
struct Traced {
  std::vector<float> radiance;        // RGB of each probe
  std::vector<float> standard_error;  // the same
  double samples = 0.0;               // a probe
  double batches = 0.0;               // the standard error is told by the differences of so many
};

// One run of path-trace: of one seed the same samples each time, but where the time was up.
struct TraceOrder {
  int seed = 0;
  double target_error = 0.0;  // mean over the probes of standard error / radiance that is good enough; 0: none is
  double samples = 0.0;       // a probe, at most
  double cpu_seconds = 0.0;   // of all threads, at most
};

// Of no probe where the time was up before there was a standard error.
using TraceFunction = std::function<Traced(const Stage& stage, const Probes& probes, const TraceOrder& order)>;

// CPU-seconds of all threads that a choice may take from when the first paths are wanted; asked then.
using PatienceFunction = std::function<double()>;
inline constexpr double kLongPatience = 20.0;

// By the method's own sampler, of spectra at all wavelengths. Kept for later starts (core/gpu/kept_values.h), which
// trace nothing anew.
Traced trace_probes(const Stage& stage, const Probes& probes, const TraceOrder& order);

// Both runs as one; their seeds differ.
Traced together(const Traced& a, const Traced& b);

// Bounds on the mean relative error over the picture, two and a half standard errors up and three down: the error that,
// alike everywhere and with the paths' noise, normal and alike everywhere, makes the mean distance from the truth what
// it is. Errors or noise that are uneven make no greater distance by a greater mean (a normal value's mean magnitude is
// convex in its mean and deviation), so the upper bound holds for them too.
struct Judgement {
  double at_least = 0.0;
  double at_most = 0.0;
};
Judgement judge(std::span<const float> radiance, const Traced& truth, std::span<const double> weights);

// By night, where nothing of a picture is brighter than 1e-15 of the sun's irradiance, every method's radiance is only
// held against 1e-12 of it, far below starlight; returned in the scene's units. Else 0: all errors are relative,
// however dark the picture. `reference`: RGB near the truth; the thousandfold between the two is for what is wrong with
// it so far from the light.
double dark_radiance(const Scene& scene, const std::vector<float>& reference);

// Path-trace's verdicts on pictures of one scene at the same probes. Nothing is traced before it is asked; every sample
// counts in all verdicts after it.
class Judge {
 public:
  Judge(const Stage& stage, const Probes& probes, double tolerance, const TraceFunction& trace,
        const PatienceFunction& patience)
      : stage_(stage), probes_(probes), tolerance_(tolerance), trace_(trace), patience_(patience) {}

  // Radiance at the probes: by paths as many as it takes to tell whether its error is below `share` of the tolerance or
  // above the tolerance, until their noise is a quarter of the tolerance or time is up.
  Judgement tell(std::span<const float> radiance, double share);
  // By the paths that there are. Without any an error may be as great as can be.
  Judgement told(std::span<const float> radiance) const;
  // dark_radiance() of a picture, where few paths bring no more light either.
  double darkness(const std::vector<float>& radiance);
  bool was_asked() const { return !traced_.radiance.empty(); }
  // Whether the time is up, or more paths were wanted than there was time for.
  bool is_over() const;
  const Probes& probes() const { return probes_; }

 private:
  bool is_settled(const Judgement& verdict, double share) const;
  bool trace_more(double target_error);

  Stage stage_;
  Probes probes_;
  double tolerance_;
  const TraceFunction& trace_;
  const PatienceFunction& patience_;
  Traced traced_;
  int runs_ = 0;
  double end_ = 0.0;          // of the time, in the process' CPU-seconds
  double cpu_seconds_ = 0.0;  // spent on paths
  bool ran_out_ = false;
};

}  // namespace airlight::choice
