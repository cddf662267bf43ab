#pragma once
// The methods and qualities that a picture may be rendered with, by what they are predicted to cost.

#include <string>
#include <vector>

#include "core/choice/cost.h"
#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::choice {

struct Candidate {
  Stage stage;          // ready to render
  std::string method;   // of the registry
  std::string quality;  // its label
  std::vector<std::string> left_out;
  Cost cost;
};

// The near-truth quality that probes are measured against: `orders`, each ray marched finely. `fine`: its tables are
// larger too; else they are those of the method's defaults, and a render by it finds them made.
Candidate reference(const Stage& stage, bool fine);

// `orders` at its defaults.
Candidate default_candidate(const Stage& stage);

// Every quality of every method on the device that claims to hold for the scene (of `only` alone where it is not
// empty), by rising cost of tables and picture; tables that those in `made` make cost nothing. Methods that tell single
// from multiple scattering are there with single scattering alone too, where the air is thinner than the tolerance asks
// for more.
std::vector<Candidate> candidates(const Stage& stage, double tolerance, const std::string& only,
                                  const std::vector<Candidate>& made);

}  // namespace airlight::choice
