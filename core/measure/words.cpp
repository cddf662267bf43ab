#include "core/measure/words.h"

#include "core/base/text.h"

namespace airlight::measure {

std::string number(double value) {
  return rounded(value, 4);
}

std::string percent(double fraction) {
  return rounded(100.0 * fraction, 3) + "%";
}

std::string verdict_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::warn:
      return "pass with warnings";
    case Verdict::differ:
      return "differ";
    case Verdict::cannot_compare:
      break;
  }
  return "cannot compare";
}

}  // namespace airlight::measure
