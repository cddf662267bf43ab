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
};

// `target_error`: mean over the probes of standard error / radiance that is good enough.
using TraceFunction = std::function<Traced(const Scene& scene, const Probes& probes, double target_error)>;

// Whether path-trace renders such a scene: there are no spheres in it.
bool can_be_traced(const Scene& scene);

// By the method's own sampler, of spectra at all wavelengths; as noisy as it is after kMostSamples a probe or
// kMostCpuSeconds of all threads. One scene gives the same samples but where that time was up.
Traced trace_probes(const Scene& scene, const Probes& probes, double target_error);
inline constexpr int kMostSamples = 1 << 16;
inline constexpr double kMostCpuSeconds = 20.0;

// Bounds on the mean relative error over the picture, two standard errors either way, what the paths' noise adds to it
// taken off: of the distance d between radiance and a noisy truth the noise n alone would make the mean of a normal
// distribution's magnitude, and d^2 is taken for error^2 + n^2. Uneven errors or noise make the result greater than the
// error; of an error that is alike everywhere and far below the noise 0.8 is found, which the two standard errors
// cover.
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

// Path-trace's verdicts on pictures of one scene at the same probes. Nothing is traced before it is asked.
class Judge {
 public:
  Judge(const Scene& scene, const Probes& probes, double tolerance, const TraceFunction& trace)
      : scene_(scene), probes_(probes), tolerance_(tolerance), trace_(trace) {}

  // Radiance at the probes: by paths as many as it takes to tell whether its error is below `share` of the tolerance or
  // above the tolerance, until their noise is as small as the tolerance or time is up.
  Judgement tell(std::span<const float> radiance, double share);
  // By the paths that there are.
  Judgement told(std::span<const float> radiance) const { return judge(radiance, traced_, probes_.weights); }
  // dark_radiance() of a picture, where few paths bring no more light either.
  double darkness(const std::vector<float>& radiance) const;
  bool was_asked() const { return !traced_.radiance.empty(); }
  const Probes& probes() const { return probes_; }

 private:
  double noise_of(const Traced& traced) const;

  const Scene& scene_;
  Probes probes_;
  double tolerance_;
  const TraceFunction& trace_;
  Traced traced_;
  double noise_ = 0.0;  // standard error / radiance that traced_ was to have, halved each time
};

}  // namespace airlight::choice
