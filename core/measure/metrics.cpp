#include "core/measure/metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/huge_pages.h"

namespace airlight::measure {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

enum class Pairing { finite, same, unequal };

Pairing pair_up(float a, float b, NonfiniteRule rule) {
  if (std::isfinite(a) && std::isfinite(b)) return Pairing::finite;
  const bool same_kind = (std::isnan(a) && std::isnan(b)) || a == b;
  return rule == NonfiniteRule::equal_to_same && same_kind ? Pairing::same : Pairing::unequal;
}

// Errors are kept as floats to halve the memory; a finite error stays finite.
float stored(double error) {
  if (std::isinf(error)) return kInfinite;
  return static_cast<float>(std::min(error, static_cast<double>(std::numeric_limits<float>::max())));
}

// Calls visit(index) for each value of the area, without a division per value.
template <class Visit>
void visit_area(const Area& area, std::size_t count, Visit visit) {
  if (area.bits.empty()) {
    for (std::size_t i = 0; i < count; ++i) visit(i);
    return;
  }
  for (std::size_t start = 0; start < count; start += area.bits.size()) {
    const std::size_t end = std::min(count, start + area.bits.size());
    for (std::size_t i = start; i < end; ++i) {
      if ((area.bits[i - start] & area.wanted) != 0) visit(i);
    }
  }
}

// One error a value, from the double-precision difference where both values are finite.
template <class Measure>
std::vector<float> errors_of(std::span<const float> a, std::span<const float> b, NonfiniteRule rule, Measure measure) {
  assert(a.size() == b.size());
  std::vector<float> errors = large_vector<float>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Pairing pairing = pair_up(a[i], b[i], rule);
    if (pairing == Pairing::finite) {
      errors[i] = stored(measure(std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])), i));
    } else {
      errors[i] = pairing == Pairing::same ? 0.0F : kInfinite;
    }
  }
  return errors;
}

double ratio(double difference, double unit) {
  return difference == 0.0 ? 0.0 : difference / unit;  // 0 / 0 is no error; x / 0 is infinite
}

// Returns the value of nearest rank and moves it to its place among values[0, end).
double take_percentile(std::span<float> values, std::size_t end, double fraction, std::size_t& rank) {
  const double exact = std::ceil(fraction * static_cast<double>(values.size()) - 1e-9);
  rank = static_cast<std::size_t>(std::max(exact, 1.0)) - 1;
  const auto begin = values.begin();
  if (rank < end) {
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(rank), begin + static_cast<std::ptrdiff_t>(end));
  }
  return static_cast<double>(values[rank]);
}

}  // namespace

Deviation& Deviation::operator+=(const Deviation& other) {
  count += other.count;
  sum_squares += other.sum_squares;
  sum_a += other.sum_a;
  sum_b += other.sum_b;
  peak = std::max(peak, other.peak);
  return *this;
}

double Deviation::rms() const {
  return std::sqrt(sum_squares / static_cast<double>(count));
}

double Deviation::psnr() const {
  return 20.0 * std::log10(peak / rms());
}

double Deviation::bias() const {
  return sum_a == sum_b ? 0.0 : (sum_a - sum_b) / std::abs(sum_b);
}

ChiSquare& ChiSquare::operator+=(const ChiSquare& other) {
  count += other.count;
  sum += other.sum;
  unequal_exact += other.unequal_exact;
  return *this;
}

double ChiSquare::per_value() const {
  return sum / static_cast<double>(count);
}

double mean_magnitude(std::span<const float> values) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    sum += std::abs(static_cast<double>(value));
    ++count;
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

std::vector<float> absolute_errors(std::span<const float> a, std::span<const float> b, NonfiniteRule rule) {
  return errors_of(a, b, rule, [](double difference, std::size_t) { return difference; });
}

std::vector<float> relative_errors(std::span<const float> a, std::span<const float> b, double reference_mean,
                                   NonfiniteRule rule) {
  const double floor = kRelativeFloor * reference_mean;
  return errors_of(a, b, rule, [&](double difference, std::size_t i) {
    return ratio(difference, std::max(std::abs(static_cast<double>(b[i])), floor));
  });
}

std::vector<float> relative_errors(std::span<const float> a, std::span<const float> b) {
  return relative_errors(a, b, mean_magnitude(b));
}

std::vector<float> sigma_errors(std::span<const float> a, std::span<const float> b, std::span<const float> sigma,
                                NonfiniteRule rule) {
  assert(sigma.size() == b.size());
  return errors_of(a, b, rule,
                   [&](double difference, std::size_t i) { return ratio(difference, static_cast<double>(sigma[i])); });
}

ErrorSummary summarize(std::span<const std::span<const float>> channels, const Area& area,
                       std::vector<float>& scratch) {
  ErrorSummary summary;
  std::size_t all = 0;
  for (const std::span<const float> errors : channels) all += errors.size();
  if (scratch.size() < all) scratch = large_vector<float>(all);
  double sum = 0.0;
  float largest = -1.0F;
  std::size_t before = 0;  // values of the channels before
  for (const std::span<const float> errors : channels) {
    visit_area(area, errors.size(), [&](std::size_t i) {
      scratch[summary.count++] = errors[i];
      sum += static_cast<double>(errors[i]);
      if (std::isinf(errors[i])) ++summary.infinite;
      if (errors[i] > largest) {
        largest = errors[i];
        summary.worst = before + i;
      }
    });
    before += errors.size();
  }
  if (summary.count == 0) return summary;
  summary.mean = sum / static_cast<double>(summary.count);
  summary.max = static_cast<double>(largest);
  const std::span<float> chosen = std::span(scratch).first(summary.count);
  std::size_t rank = chosen.size();
  summary.p99 = take_percentile(chosen, rank, 0.99, rank);
  summary.p95 = take_percentile(chosen, rank, 0.95, rank);
  summary.p50 = take_percentile(chosen, rank, 0.50, rank);
  return summary;
}

ErrorSummary summarize(std::span<const float> errors, const Area& area) {
  std::vector<float> scratch;
  return summarize(std::span(&errors, 1), area, scratch);
}

std::size_t count_over(std::span<const float> errors, double threshold, const Area& area) {
  std::size_t count = 0;
  visit_area(area, errors.size(), [&](std::size_t i) {
    if (static_cast<double>(errors[i]) > threshold || std::isinf(errors[i])) ++count;
  });
  return count;
}

Deviation deviation(std::span<const float> a, std::span<const float> b, const Area& area, NonfiniteRule rule) {
  assert(a.size() == b.size());
  Deviation result;
  visit_area(area, a.size(), [&](std::size_t i) {
    ++result.count;
    const Pairing pairing = pair_up(a[i], b[i], rule);
    if (pairing == Pairing::unequal) result.sum_squares = std::numeric_limits<double>::infinity();
    if (pairing != Pairing::finite) return;
    const double value = static_cast<double>(a[i]);
    const double reference = static_cast<double>(b[i]);
    result.sum_squares += (value - reference) * (value - reference);
    result.sum_a += value;
    result.sum_b += reference;
    result.peak = std::max(result.peak, std::abs(reference));
  });
  return result;
}

ChiSquare chi_square(std::span<const float> a, std::span<const float> b, std::span<const float> sigma, const Area& area,
                     NonfiniteRule rule) {
  assert(a.size() == b.size() && sigma.size() == b.size());
  ChiSquare result;
  visit_area(area, a.size(), [&](std::size_t i) {
    const Pairing pairing = pair_up(a[i], b[i], rule);
    if (pairing == Pairing::same) return;
    if (pairing == Pairing::unequal) {
      ++result.count;
      result.sum = std::numeric_limits<double>::infinity();
      return;
    }
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    if (sigma[i] > 0.0F) {
      const double distance = difference / static_cast<double>(sigma[i]);
      ++result.count;
      result.sum += distance * distance;
    } else if (difference != 0.0) {
      ++result.unequal_exact;
    }
  });
  return result;
}

}  // namespace airlight::measure
