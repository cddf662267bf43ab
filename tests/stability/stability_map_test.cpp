// The map of failures: it finds what is broken, and the methods hold where no failure is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "core/stability/energy.h"
#include "core/stability/examine.h"
#include "core/stability/report.h"
#include "tests/shared_executor.h"

namespace airlight::stability {
namespace {

using physics::vec3;

auto* const shared_device = new test::SharedExecutor({.validation = true});
const auto* const device_environment = testing::AddGlobalTestEnvironment(shared_device);

const DeviceOnDemand kDevice = []() -> Executor& { return shared_device->get(); };

Subject subject_named(const std::string& name) {
  for (const Subject& subject : subjects()) {
    if (subject.name == name) {
      return subject;
    }
  }
  ADD_FAILURE() << name << " is no subject";
  return {};
}

Sweep sweep_named(const std::string& name, Form form = Form::quick) {
  for (const Sweep& sweep : sweeps(form)) {
    if (sweep.name == name) {
      return sweep;
    }
  }
  ADD_FAILURE() << name << " is no sweep";
  return {};
}

Look look(double asked, double converged, double in_double) {
  return {vec3(asked), vec3(converged), vec3(in_double)};
}

class Holds : public testing::TestWithParam<const char*> {};

// Keeps every second place along a sweep, and its last, since `orders` takes seconds a place to bake thick air. The
// views of a column are its pixels and all stay.
void thin(Sweep& sweep) {
  if (sweep.x == Quantity::view) {
    return;
  }
  std::vector<double> kept;
  for (std::size_t i = 0; i < sweep.xs.size(); ++i) {
    if (i % 2 == 0 || i + 1 == sweep.xs.size()) {
      kept.push_back(sweep.xs[i]);
    }
  }
  sweep.xs = kept;
}

TEST_P(Holds, WhereNothingIsKnownAgainstIt) {
  Examination e;
  e.sweeps = sweeps(Form::quick);
  if (std::string(GetParam()) == "orders") {
    std::ranges::for_each(e.sweeps, thin);
  }
  e.subjects = {subject_named(GetParam())};
  for (const Sweep& sweep : e.sweeps) {
    ConvergedShots converged;
    e.blocks.push_back(examine(kDevice, e.subjects.front(), sweep, converged));
  }
  std::size_t failing = 0;
  for (const Region& region : all_regions(e)) {
    EXPECT_FALSE(region.cause.empty()) << region.sweep << ": " << symptom_name(region.symptom) << ", x " << region.x_low
                                       << " to " << region.x_high << ", y " << region.y_low << " to " << region.y_high
                                       << ", worst " << region.worst;
    EXPECT_TRUE(region.symptom != 'F' && region.symptom != 'N') << region.sweep;
    failing += region.cells;
  }
  std::size_t cells = 0;
  for (const Block& block : e.blocks) {
    cells += block.cells.size();
  }
  // An explanation for everything would prove nothing, so most cells must hold.
  EXPECT_LT(failing, cells / 3);
  EXPECT_EQ(Executor::validation_message_count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Method, Holds, testing::Values("nested", "march", "sky-view", "analytic", "orders"));

// One step too few along the view gives an error far from convergence, and the symptom says so.
TEST(StabilityMap, FindsOneStepWanting) {
  Sweep sweep = sweep_named("steps");
  sweep.xs = {1, 64};
  sweep.ys = {30};
  const Subject march = subject_named("march");
  ConvergedShots converged;
  const Block block = examine(kDevice, march, sweep, converged);
  ASSERT_EQ(block.cells.size(), 2U);
  EXPECT_NE(block.cells[0].symptoms.find('E'), std::string::npos);
  EXPECT_EQ(block.cells[1].symptoms, "");
  EXPECT_LT(block.cells[1].rounding, 1e-5);
  const std::vector<Region> found = regions(block, sweep, march);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().cause, "few steps");
}

// Thin air over a white ground: light that the disc does not catch passes by.
TEST(StabilityMap, AWhitePlanetReturnsAllLight) {
  Sweep sweep = sweep_named("optical-depth");
  sweep.xs = {1e-4};
  sweep.ys = {30};
  const double share = returned_share(kDevice, subject_named("nested"), place_of(sweep, 0, 0));
  EXPECT_NEAR(share, 1.0, 2e-3);
}

// Where nothing absorbs, all light comes back: from haze with sharp forward and backward peaks, which lie between the
// directions by which light is gathered, and from deep air.
TEST(StabilityMap, OrdersKeepsAllLightWhereNothingAbsorbs) {
  const Subject orders = subject_named("orders");
  Sweep haze = sweep_named("asymmetry");
  haze.xs = {-0.9, 0.97};
  haze.ys = {1.0};
  Sweep molecules = sweep_named("optical-depth");
  molecules.xs = {10.0};
  for (const Place& place : {place_of(haze, 0, 0), place_of(haze, 1, 0), place_of(molecules, 0, 0)}) {
    // 1.3 %: the effect of degree 2 on a backward peak.
    const double most = place[Quantity::asymmetry] < 0.0 ? 0.013 : 0.01;
    EXPECT_NEAR(returned_share(kDevice, orders, place), 1.0, most)
        << place[Quantity::asymmetry] << ", " << place[Quantity::optical_depth];
  }
}

TEST(StabilityMap, ErrorsAreRelativeAndRoundingStandsApart) {
  Cell cell;
  measure(cell, {look(1.1, 1.0, 1.1), look(0.9, 1.0, 0.9)}, 1.0);
  EXPECT_NEAR(cell.error, 0.1, 1e-12);
  EXPECT_NEAR(cell.rounding, 0.0, 1e-12);
  measure(cell, {look(1.0, 1.0, 1.25), look(0.0, 0.0, 0.0)}, 1.0);
  EXPECT_NEAR(cell.rounding, 0.2, 1e-12);  // the black look counts for nothing
  measure(cell, {look(1e-3, 0.0, NAN)}, 1.0);
  EXPECT_NEAR(cell.error, 1.0, 1e-12);  // against a thousandth of the mean
  EXPECT_TRUE(std::isnan(cell.rounding));
}

TEST(StabilityMap, ASlopeIsNoJump) {
  EXPECT_LE(jump_between({look(1.0, 1.0, NAN)}, {look(2.0, 2.0, NAN)}, 1.0), 0.0);
  EXPECT_LE(jump_between({look(1.0, 1.0, NAN)}, {look(2.4, 2.0, NAN)}, 1.0), 0.0);
  EXPECT_NEAR(jump_between({look(1.0, 1.0, NAN)}, {look(1.1, 1.0, NAN)}, 1.0), 0.1, 1e-12);
}

TEST(StabilityMap, EachSymptomHasItsLetter) {
  const Sweep sweep = sweep_named("sun-altitude");
  Cell cell;
  cell.energy = NAN;
  cell.rounding = NAN;
  EXPECT_EQ(symptoms_of(cell, sweep, {}), "");
  cell.not_finite = 1;
  cell.negative = 1;
  cell.error = 0.021;
  cell.jump = 0.06;
  cell.energy = 1.02;
  cell.rounding = 0.01;
  EXPECT_EQ(symptoms_of(cell, sweep, {}), "FNEJGR");
}

TEST(StabilityMap, ACauseHoldsInItsRegionAndForItsSymptomsAlone) {
  SkyMethod method;
  method.validity.optical_depth_max = 2.0;
  method.validity.known_failures = {{"E", {{Quantity::steps, 1, 8}, {Quantity::sun_elevation, -90, 0}}, "few"}};
  const Subject subject{"it", &method, {}, false};
  Place place;
  place.set(Quantity::steps, 4);
  EXPECT_EQ(explanation(subject, place, 'E'), "");  // no sun is given, so the limit on it does not hold
  place.set(Quantity::sun_elevation, -1);
  EXPECT_EQ(explanation(subject, place, 'E'), "few");
  EXPECT_EQ(explanation(subject, place, 'N'), "");
  place.set(Quantity::steps, 9);
  EXPECT_EQ(explanation(subject, place, 'E'), "");
  place.set(Quantity::optical_depth, 3);
  EXPECT_EQ(explanation(subject, place, 'E'), "claims nothing for optical depths above 2");
}

// Checks core/STABILITY.md for every method; for `orders` with its table, the default.
TEST(StabilityMap, TheMapLeavesNothingUnexplained) {
  std::ifstream file(AIRLIGHT_SOURCE_DIR "/core/STABILITY.md");
  const std::string map((std::istreambuf_iterator<char>(file)), {});
  EXPECT_NE(map.find("## orders tabulated"), std::string::npos);
  EXPECT_EQ(map.find("**not explained**"), std::string::npos);
}

// scripts/stability remakes the map. A cause that explains no cell of it excuses nothing and must be removed.
TEST(StabilityMap, EachKnownFailureExplainsACell) {
  std::ifstream file(AIRLIGHT_SOURCE_DIR "/core/STABILITY.md");
  std::map<std::string, std::string> by_subject;
  std::string subject;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) {
      subject = line.substr(3);
    }
    by_subject[subject] += line + "\n";
  }
  for (const SkyMethod& method : methods()) {
    std::string map;
    for (const auto& [name, text] : by_subject) {
      map += name == method.info.name || name.rfind(std::string(method.info.name) + " ", 0) == 0 ? text : "";
    }
    for (const KnownFailure& known : method.validity.known_failures) {
      EXPECT_TRUE(known.symptoms.empty() || map.find("| " + std::string(known.cause) + " |") != std::string::npos)
          << method.info.name << ": " << known.cause;
    }
  }
}

Examination small_examination() {
  Examination e;
  e.version = "airlight 1";
  e.device = "device";
  e.form = "quick";
  e.sweeps = {sweep_named("steps")};
  e.sweeps[0].xs = {1, 2};
  e.sweeps[0].ys = {0, 30};
  e.subjects = {subject_named("march")};
  Block block{"march", "steps", std::vector<Cell>(4)};
  for (std::size_t i = 0; i < 4; ++i) {
    block.cells[i].x = e.sweeps[0].xs[i % 2];
    block.cells[i].y = e.sweeps[0].ys[i / 2];
    block.cells[i].error = 0.1 / (1.0 + static_cast<double>(i));
    block.cells[i].energy = NAN;
  }
  block.cells[0].symptoms = "EJ";
  block.cells[3].symptoms = "E";
  e.blocks = {block};
  return e;
}

TEST(StabilityMap, AnUnfinishedTableIsReadBackAndAFinishedOneIsNot) {
  const Examination e = small_examination();
  const std::vector<Block> read = unfinished_blocks(csv_text(e, false), e);
  ASSERT_EQ(read.size(), 1U);
  ASSERT_EQ(read[0].cells.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read[0].cells[i].error, e.blocks[0].cells[i].error);
    EXPECT_EQ(read[0].cells[i].symptoms, e.blocks[0].cells[i].symptoms);
    EXPECT_TRUE(std::isnan(read[0].cells[i].energy));
  }
  EXPECT_TRUE(unfinished_blocks(csv_text(e, true), e).empty());
  Examination other = e;
  other.device = "another";
  EXPECT_TRUE(unfinished_blocks(csv_text(e, false), other).empty());
  Examination cut = e;
  cut.blocks[0].cells.pop_back();
  EXPECT_TRUE(unfinished_blocks(csv_text(cut, false), e).empty());
  EXPECT_TRUE(unfinished_blocks("nonsense", e).empty());
}

TEST(StabilityMap, NeighboursOfOneCauseAreOneRegion) {
  Examination e = small_examination();
  EXPECT_EQ(all_regions(e).size(), 3U);  // two of E, apart from corner to corner, and one of J
  e.blocks[0].cells[1].symptoms = "E";
  const std::vector<Region> joined = all_regions(e);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(joined[0].cells, 3U);
  EXPECT_EQ(joined[0].x_high, 2.0);
  EXPECT_EQ(joined[0].y_high, 30.0);
}

TEST(StabilityMap, TheSummaryNamesWhatIsNotExplained) {
  Examination e = small_examination();
  EXPECT_NE(summary_text(e).find("Every failing region has a known cause."), std::string::npos);
  e.blocks[0].cells[3].symptoms = "N";
  const std::string text = summary_text(e);
  EXPECT_NE(text.find("**not explained**"), std::string::npos);
  EXPECT_EQ(text.find("Every failing region"), std::string::npos);
}

// The colour of each cell, and the letter of each failing one; blank where there is no number.
TEST(StabilityMap, AMapShowsEveryCell) {
  Examination e = small_examination();
  e.blocks[0].cells[0].not_finite = 1;
  e.blocks[0].cells[1].symptoms = "JR";
  const std::string script = map_script(e);
  const std::size_t at = script.find("$block0 << EOD\n");
  ASSERT_NE(at, std::string::npos) << script;
  std::istringstream lines(script.substr(script.find('\n', at) + 1));
  for (std::size_t i = 0; i < e.blocks[0].cells.size(); ++i) {
    const Cell& cell = e.blocks[0].cells[i];
    std::size_t x = 0;
    std::size_t y = 0;
    std::string error;
    std::string letter;
    lines >> x >> y >> error >> letter;
    EXPECT_EQ(y * e.sweeps[0].xs.size() + x, i);
    if (i == 0) {
      EXPECT_EQ(error, "NaN");
    } else {
      EXPECT_NEAR(std::stod(error), std::max(cell.error, 1e-5), 1e-5 * std::stod(error)) << i;
    }
    EXPECT_EQ(letter, cell.symptoms.empty() ? "-" : cell.symptoms.substr(0, 1)) << i;
  }
  std::string end;
  lines >> end;
  EXPECT_EQ(end, "EOD");
  EXPECT_NE(script.find("set title '" + e.blocks[0].subject + "'"), std::string::npos);
}

TEST(StabilityMap, EveryMethodIsExaminedOrLeftOutByName) {
  for (const SkyMethod& method : methods()) {
    bool found = false;
    for (const Subject& subject : subjects()) {
      found = found || subject.method == &method;
    }
    for (const LeftOut& one : subjects_left_out()) {
      found = found || one.name == method.info.name;
    }
    EXPECT_TRUE(found) << method.info.name;
  }
}

}  // namespace
}  // namespace airlight::stability
