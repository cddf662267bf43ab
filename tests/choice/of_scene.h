#pragma once
// The doors of core/choice and core/chart for a test that has a scene.

#include "core/choice/assumed_error.h"
#include "core/choice/choose.h"
#include "core/choice/leave_out.h"
#include "tests/of_scene.h"

namespace airlight::choice {

inline Candidate reference(const Scene& scene, bool fine) {
  return reference(ready(scene), fine);
}
inline Candidate default_candidate(const Scene& scene) {
  return default_candidate(ready(scene));
}
inline std::vector<Candidate> candidates(const Scene& scene, double tolerance, const std::string& only,
                                         const std::vector<Candidate>& made) {
  return candidates(ready(scene), tolerance, only, made);
}
inline Choice choose_for_tolerance(const Scene& scene, double tolerance, const std::string& only, const Looks& looks) {
  return choose_for_tolerance(ready(scene), tolerance, only, looks);
}
inline Choice choose_for_time(const Scene& scene, double limit_ms, const std::string& only, const Looks& looks,
                              const TimeFunction& time) {
  return choose_for_time(ready(scene), limit_ms, only, looks, time);
}
inline std::optional<double> default_error(const Scene& scene) {
  return default_error(ready(scene));
}
inline std::optional<double> plain_reference_error(const Scene& scene) {
  return plain_reference_error(ready(scene));
}
inline bool search_may_pay(const Scene& scene) {
  return search_may_pay(ready(scene));
}
inline Lighter leave_out_media(const Scene& scene, double allowed) {
  return leave_out_media(ready(scene), allowed);
}

}  // namespace airlight::choice
