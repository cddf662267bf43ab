// Phase functions by table: lists, files of other programs, refusals, and the way back to JSON.

#include "core/scene/phase_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/of_scene.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

constexpr double kIsotropic = 0.25 / std::numbers::pi;

std::string with_phase(const std::string& phase, const std::string& extra = "") {
  return R"({"airlight": 1, "media": [{"name": "a", "scattering_per_km": 0.01, "phase": )" + phase +
         R"(, "density": {"profile": "exponential", "scale_height_km": 8}}])" + (extra.empty() ? "" : ", " + extra) +
         "}";
}

std::string table(const std::string& angles, const std::string& values, const std::string& extra = "") {
  return R"({"function": "table", "angles_deg": )" + angles + R"(, "values": )" + values + extra + "}";
}

// Per steradian or with mean 1: the same function, with integral 1 after reading.
TEST(PhaseTables, AreNormalisedAndSaySo) {
  const Scene mean = scene_from(with_phase(table("[0, 90, 180]", "[1, 1, 1]")));
  EXPECT_NEAR(mean.media[0].phase_table.rows[0][1], kIsotropic, 1e-12);
  EXPECT_TRUE(phase_notes(mean).empty());
  EXPECT_FALSE(mean.spectra.has_value());
  const Scene off = scene_from(with_phase(table("[0, 90, 180]", "[0.0812, 0.0812, 0.0812]")));
  EXPECT_NEAR(off.media[0].phase_table.rows[0][1], kIsotropic, 1e-12);
  ASSERT_EQ(phase_notes(off).size(), 1u);
  EXPECT_EQ(phase_notes(off)[0],
            "/media/0/phase: the table's integral is 1.0204 of what it should be; it is divided by it");
}

TEST(PhaseTables, ComeBackFromJson) {
  for (const std::string& phase :
       {table("[0, 10.5, 180]", "[1.4, 1.2, 0.85]"),
        table("[0, 90, 180]", "[[1, 1, 1], [1.2, 0.9, 1.1]]", R"(, "wavelengths_nm": [440, 670])"),
        std::string(R"({"function": "rayleigh", "depolarization": 0.0147})"),
        std::string(
            R"({"function": "rayleigh", "depolarization": {"wavelengths_nm": [400, 700], "values": [0.02, 0.01]}})")}) {
    const Scene scene = scene_from(with_phase(phase));
    const Scene again = scene_from(to_json(scene));
    EXPECT_EQ(again.media[0], scene.media[0]) << phase;
    EXPECT_EQ(to_json(again), to_json(scene)) << phase;
    if (scene.spectra) {
      EXPECT_EQ(again.media[0].depolarization.curve, scene.media[0].depolarization.curve);
    }
  }
}

// Rows over the wavelength are a curve: they are refused beside three channels, and wavelengths between are
// interpolated.
TEST(PhaseTables, OverTheWavelengthMakeAScenesSpectra) {
  const std::string rows = table("[0, 90, 180]", "[[1, 1, 1], [1.2, 0.9, 1.1]]", R"(, "wavelengths_nm": [440, 670])");
  const Scene scene = scene_from(with_phase(rows));
  ASSERT_TRUE(scene.spectra.has_value());
  const PhaseTable& read = scene.media[0].phase_table;
  EXPECT_NEAR(phase_at(read, 555.0, 90.0), std::sqrt(read.rows[0][1] * read.rows[1][1]), 1e-15);
  EXPECT_EQ(phase_at(read, 300.0, 90.0), phase_at(read, 440.0, 90.0));
  EXPECT_EQ(phase_at(read, 900.0, 180.0), phase_at(read, 670.0, 180.0));
  EXPECT_EQ(scene.media[0].phase_wavelengths[1], 541.0);
  EXPECT_NE(problems_of(with_phase(rows, R"("planet": {"ground_albedo": [0.1, 0.2, 0.3]})"))
                .find("three channels in a scene whose /media/0/phase/wavelengths_nm is a curve over the wavelength"),
            std::string::npos);
}

TEST(PhaseTables, AreRefusedWithPlaceAndRemedy) {
  const auto expect = [](const std::string& phase, const std::string& message) {
    EXPECT_EQ(problems_of(with_phase(phase)), "test:1: /media/0/phase" + message) << phase;
  };
  expect(table("[5, 90, 180]", "[1, 1, 1]"), "/angles_deg: begins at 5 degrees; expected angles from 0 to 180");
  expect(table("[0, 90, 175]", "[1, 1, 1]"), "/angles_deg: ends at 175 degrees; expected angles from 0 to 180");
  expect(table("[0, 90, 80, 180]", "[1, 1, 1, 1]"),
         "/angles_deg: 80 degrees does not follow 90; expected ascending numbers");
  expect(table("[0, 90, 190]", "[1, 1, 1]"), "/angles_deg: 190 is outside 0 to 180 degrees");
  expect(table("[0]", "[1]"), "/angles_deg: 1 of them; expected 2 to 4096");
  expect(table("[0, 90, 180]", "[1, 1]"), "/values: 2 values for 3 angles; expected as many of both");
  expect(table("[0, 90, 180]", "[0, 0, 0]"), "/values: 0 at all angles; expected light at some");
  expect(table("[0, 90, 180]", "[1, -1, 1]"), "/values: -1 is outside 0 to 1e9");
  expect(table("[0, 90, 180]", "[1, \"x\", 1]"),
         "/values: \"x\" is not a number; expected an array of numbers, 0 to 1e9, or one such array a wavelength");
  expect(table("[0, 90, 180]", "1"),
         "/values: 1 is not an array; expected an array of numbers, 0 to 1e9, or one such array a wavelength");
  expect(table("[0, 90, 180]", "[2, 2, 2]"),
         "/values: the integral over the sphere is 25.133; expected 1, or 4 pi where the mean is 1, to 5 %: divide the "
         "values by it, or look for angles that are missing in the peak");
  expect(table("[0, 90, 180]", "[[1, 1, 1], [1, 1, 1]]"), "/wavelengths_nm: 0 of them; expected 2 to 4096");
  expect(table("[0, 90, 180]", "[[1, 1, 1], [1, 1, 1]]", R"(, "wavelengths_nm": [400, 500, 600])"),
         "/values: 2 rows for 3 wavelengths; expected as many of both");
  expect(table("[0, 90, 180]", "[[1, 1, 1], [1, 1]]", R"(, "wavelengths_nm": [400, 500])"),
         "/values: at 500 nm 2 values for 3 angles; expected as many of both");
  expect(table("[0, 90, 180]", "[[1, 1, 1], [1, 1, 1]]", R"(, "wavelengths_nm": [500, 400])"),
         "/wavelengths_nm: 400 nm does not follow 500; expected ascending numbers");
  expect(R"({"function": "table", "values": [1, 1]})",
         "/angles_deg: missing for \"table\"; expected an array of ascending numbers, 0 to 180 degrees, or a file");
  expect(R"({"function": "henyey-greenstein", "values": [1, 1]})",
         "/values: not a key of \"henyey-greenstein\"; it belongs to table: remove it");
  expect(R"({"function": "isotropic", "depolarization": 0.1})",
         "/depolarization: not a key of \"isotropic\"; it belongs to rayleigh: remove it");
  expect(R"({"function": "rayleigh", "depolarization": 1.5})", "/depolarization: 1.5 is outside 0 to 1");
}

class PhaseFile : public FolderTest {
 protected:
  std::string preset_with(const std::string& text) const {
    write("x.csv", text);
    return write("p.json", with_phase(R"({"function": "table", "file": "x.csv"})")).string();
  }
  PhaseTable read(const std::string& text) const {
    return resolve(load_preset(preset_with(text)), local_methods()).media[0].phase_table;
  }
};

// A heading of angles in degrees, rows of a wavelength in metres.
TEST_F(PhaseFile, OfCosmoScout) {
  const PhaseTable found = read(
      "lambda,0.0,90.0,180.0\n4.4e-07,0.0796,0.0796,0.0796\n5.5e-07,0.0796,0.0796,0.0796\n6.7e-07,0.08,0.08,0.08\n");
  EXPECT_EQ(found.angles_deg, (std::vector<double>{0.0, 90.0, 180.0}));
  EXPECT_EQ(found.wavelengths_nm, (std::vector<double>{440.0, 550.0, 670.0}));
  EXPECT_NEAR(found.rows[2][1], kIsotropic, 1e-12);
}

// Columns ANGLE[NNNnm] among others, values of mean 1, retrievals of a day that are averaged.
TEST_F(PhaseFile, OfAeronet) {
  const PhaseTable found = read(
      "27:05:2013,Locations=Somewhere,Nmeas=2\nLevel 1.5 Almucantar Retrievals, Version 2\n"
      "Date(dd-mm-yyyy),Time(hh:mm:ss),Julian_Day,0.0000[442nm],90.0000[442nm],180.0000[442nm],0.0000[674nm],"
      "90.0000[674nm],180.0000[674nm],last_processing_date(mm/dd/yyyy),DATA_TYPE\n"
      "27:05:2013,11:19:04,147.4,1.2,0.9,1.1,1,1,1,01/09/2013,Level_1.5\n"
      "27:05:2013,11:46:21,147.5,1.0,1.1,0.9,1,1,1,01/09/2013,Level_1.5\n");
  EXPECT_EQ(found.wavelengths_nm, (std::vector<double>{442.0, 674.0}));
  EXPECT_EQ(found.angles_deg, (std::vector<double>{0.0, 90.0, 180.0}));
  EXPECT_NEAR(found.rows[0][0] / found.rows[0][1], 1.1 / 1.0, 1e-12);
  EXPECT_NEAR(found.rows[1][2], kIsotropic, 1e-12);
}

TEST_F(PhaseFile, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(read("\xef\xbb\xbf"
                 "0,1\n90,1\n180,1\n")
                .angles_deg,
            (std::vector<double>{0.0, 90.0, 180.0}));
}

TEST_F(PhaseFile, OfLines) {
  const PhaseTable found = read("# measured\nangle,value\n0,1\n90,1\n180 , 1\r\n");
  EXPECT_TRUE(found.wavelengths_nm.empty());
  EXPECT_NEAR(found.rows[0][2], kIsotropic, 1e-12);
}

TEST_F(PhaseFile, IsRefusedByLine) {
  const std::string place = (folder_ / "x.csv").string();
  const auto expect = [&](const std::string& text, const std::string& message) {
    EXPECT_EQ(problems_of_file(preset_with(text)),
              (folder_ / "p.json").string() + ":1: /media/0/phase/file: " + message);
  };
  expect("lambda,0,90,180\n4.4e-07,1,1\n", place + ":2: 3 fields; expected 4, as the heading has");
  expect("lambda,0,90,180\n4.4e-07,1,N/A,1\n", place + ":2: \"N/A\" in field 3; expected a number");
  expect("0,1\n90,1\n180\n", place + ":3: nothing in field 2; expected a number");
  expect("Date,0[442nm],180[442nm]\n", place +
                                           ": no table in it; expected CosmoScout's CSV (a heading that begins with "
                                           "lambda), AERONET's .pfn (columns ANGLE[NNNnm]), or lines of angle,value");
  expect("Date,0[442nm],90[442nm],180[442nm]\nx,1,2\n", place + ":2: nothing in field 4; expected a number");
  expect("", place +
                 ": no table in it; expected CosmoScout's CSV (a heading that begins with lambda), AERONET's .pfn "
                 "(columns ANGLE[NNNnm]), or lines of angle,value");
  expect("0,1\n90,1\n170,1\n", "x.csv: ends at 170 degrees; expected angles from 0 to 180");
  expect("lambda,0,90,180\n440,1,1,1\n550,1,1,1\n", "x.csv: 4.4e11 is outside 200 to 4000 nm");
  expect("lambda,0,90,180\n440,1,1,1\n", "x.csv: 4.4e11 is outside 200 to 4000 nm");
  expect("0,nan\n90,1\n180,1\n", place + ":1: \"nan\" in field 2; expected a number");
}

TEST_F(PhaseFile, IsMissing) {
  const std::string preset = write("p.json", with_phase(R"({"function": "table", "file": "none.pfn"})")).string();
  EXPECT_EQ(problems_of_file(preset), preset + ":1: /media/0/phase/file: " + (folder_ / "none.pfn").string() +
                                          " cannot be read: No such file or directory; expected a table of a phase "
                                          "function");
}

// Another function drops the inherited table, and keeps g.
TEST_F(PhaseFile, IsNotInheritedByAnotherFunction) {
  write("base.json", with_phase(R"({"function": "table", "g": 0.3, "angles_deg": [0, 180], "values": [1, 1]})"));
  const auto over = write("over.json", R"({"airlight": 1, "extends": "base.json", "media": [{"name": "a", )"
                                       R"("phase": {"function": "henyey-greenstein"}}]})");
  const Scene scene = resolve(load_preset(over), local_methods());
  EXPECT_EQ(scene.media[0].phase, PhaseFunction::henyey_greenstein);
  EXPECT_EQ(scene.media[0].phase_g, 0.3);
}

}  // namespace
}  // namespace airlight::test
