#pragma once
// The symptoms of a cell, and whether they are known.

#include <string>
#include <string_view>
#include <vector>

#include "core/physics/vector.h"
#include "core/stability/subject.h"

namespace airlight::stability {

// One direction of one cell: at the requested quality, converged, and by the formulas in double (NaN where there are
// none).
struct Look {
  physics::vec3 asked;
  physics::vec3 converged;
  physics::vec3 in_double;
};

struct Cell {
  double x = 0.0;
  double y = 0.0;
  int not_finite = 0;      // number of values, of radiance and transmittance
  int negative = 0;        // number of values; transmittance above 1 counts as well
  double error = 0.0;      // mean relative, against the converged quality
  double error95 = 0.0;    // 95th percentile
  double rounding = 0.0;   // mean relative, 32 bits against double; NaN: no formulas in double
  double jump = 0.0;       // largest step of the error between neighbours, in shares of the radiance, less what the
                           // converged radiance's own slope explains
  double energy = 0.0;     // leaving over arriving energy; NaN: not taken in this sweep
  double brightest = 0.0;  // mean radiance around the camera over that of a white plane that faces the sun
  std::string symptoms;    // letters of kSymptoms
};

struct Symptom {
  char letter;
  std::string_view name;
};
inline constexpr Symptom kSymptoms[] = {
    {'F', "not finite"},          {'N', "negative"},      {'E', "error against the converged quality"},
    {'J', "discontinuity"},       {'G', "energy gained"}, {'L', "energy lost"},
    {'R', "rounding of 32 bits"},
};
std::string_view symptom_name(char letter);

// Fills in error, error95 and rounding from a cell's looks. Each is relative to the larger of a value and a thousandth
// of `mean`, the mean of the row's converged radiances. Looks that are black in both are left out.
void measure(Cell& cell, const std::vector<Look>& looks, double mean);

// The jump between two neighbouring cells with the same directions.
double jump_between(const std::vector<Look>& a, const std::vector<Look>& b, double mean);

// The cell's symptoms by its numbers and by the error that the subject claims. Lost energy is judged only where nothing
// absorbs and no glory leaves between the directions that sum it.
std::string symptoms_of(const Cell& cell, const Sweep& sweep, const Validity& validity);

// Why a method shows a symptom at a place: it claims nothing there, or the failure is known. Empty where it should
// hold.
std::string explanation(const Subject& subject, const Place& place, char symptom);

// Neighbouring cells with the same symptom and explanation.
struct Region {
  std::string subject;
  std::string sweep;
  char symptom = 'E';
  std::string cause;  // empty: unexplained
  std::size_t cells = 0;
  std::size_t of = 0;  // number of cells in the sweep
  double x_low = 0.0;
  double x_high = 0.0;
  double y_low = 0.0;
  double y_high = 0.0;
  double worst = 0.0;  // worst value behind the symptom
};

// One subject in one sweep, cells row by row (x fastest).
struct Block {
  std::string subject;
  std::string sweep;
  std::vector<Cell> cells;
};

std::vector<Region> regions(const Block& block, const Sweep& sweep, const Subject& subject);

}  // namespace airlight::stability
