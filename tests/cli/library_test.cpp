// libairlight as it is installed: its examples, built against the installed files alone by CMake and by pkg-config, and
// the tree inside another project.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/pages.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

const fs::path kLibrary = fs::path(AIRLIGHT_SOURCE_DIR) / "core/library";

class InstalledLibrary : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<Scratch>();
    for (const char* component : {"Library", "Development"}) {
      const Outcome outcome = run(scratch_->path(), {"cmake", "--install", AIRLIGHT_BUILD_DIR, "--prefix",
                                                     (scratch_->path() / "prefix").string(), "--component", component});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
  }
  static void TearDownTestSuite() { scratch_.reset(); }

  void SetUp() override {
    if (!fs::exists(fs::path(AIRLIGHT_BUILD_DIR) / "libairlight.a")) {
      GTEST_SKIP() << "this build has no libairlight";
    }
  }

  static Outcome in_prefix(const std::string& line) {
    Start start;
    start.environment = {{"EXAMPLES", (kLibrary / "examples").string()},
                         {"PKG_CONFIG_PATH", (scratch_->path() / "prefix/lib/pkgconfig").string()},
                         {"LD_LIBRARY_PATH", (scratch_->path() / "prefix/lib").string()}};
    return shell(scratch_->path(), line, start);
  }

  static std::unique_ptr<Scratch> scratch_;
};
std::unique_ptr<Scratch> InstalledLibrary::scratch_;

TEST_F(InstalledLibrary, ItsExamplesAreBuiltAndRun) {
  const Outcome built = in_prefix(
      "cmake -S \"$EXAMPLES\" -B build -DCMAKE_PREFIX_PATH=\"$PWD/prefix\" && "
      "cmake --build build");
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  const Outcome one = in_prefix("build/one_sky");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_TRUE(contains(one.out, "row  2: ")) << one.out;
  // The archive holds what the shared library holds.
  EXPECT_EQ(in_prefix("build/one_sky_static").out, one.out);
  const Outcome suns = in_prefix("build/suns");
  EXPECT_EQ(suns.exit_code, 0) << suns.err;
  EXPECT_TRUE(contains(suns.out, "64 degrees: zenith ")) << suns.out;
  // The tool's own answer, on the same row: the radiance printed is that of the picture.
  const Outcome tool = airlight(scratch_->path(), {"render", "earth-noon", "--projection", "latlong", "--size", "64x32",
                                                   "--sun-elevation", "4", "-q", "-o", "sky.npy"});
  ASSERT_EQ(tool.exit_code, 0) << tool.err;
  const Outcome same = in_prefix(
      "/usr/bin/python3 -c 'import numpy; s = numpy.load(\"sky.npy\"); [print(\"row %2d: %.4f %.4f %.4f\" % (y, *s[y, "
      "32])) for "
      "y "
      "in (2, 8, 15)]'");
  EXPECT_EQ(same.out, one.out) << same.err;
}

TEST_F(InstalledLibrary, PkgConfigKnowsIt) {
  const Outcome built = in_prefix(
      "g++ \"$EXAMPLES/one_sky.cpp\" -o one $(pkg-config --cflags --libs airlight) && ./one && pkg-config --modversion "
      "airlight");
  EXPECT_EQ(built.exit_code, 0) << built.err;
  EXPECT_TRUE(contains(built.out, "row 15: ")) << built.out;
  EXPECT_TRUE(contains(airlight(scratch_->path(), {"--version"}).out, lines_of(built.out).back())) << built.out;
}

// Nobody's own symbols, or those of a library that it uses, are among what a program sees of ours.
TEST_F(InstalledLibrary, ShowsNoNamesButItsOwn) {
  const Outcome names = in_prefix("nm -DC --defined-only prefix/lib/libairlight.so | cut -d' ' -f3-");
  ASSERT_EQ(names.exit_code, 0) << names.err;
  std::size_t ours = 0;
  for (const std::string& name : lines_of(names.out)) {
    const bool is_ours = contains(name, "airlight::v0::");
    ours += is_ours ? 1 : 0;
    const bool is_linkers = name == "__bss_start" || name == "_edata" || name == "_end";
    EXPECT_TRUE(is_ours || is_linkers || contains(name, "std::")) << name;
  }
  EXPECT_GT(ours, 20U);
  const Outcome needs = in_prefix("readelf -d prefix/lib/libairlight.so | grep NEEDED");
  for (const char* not_needed : {"OpenEXR", "OpenColorIO", "OpenImageIO", "CLI11", "png", "vulkan", "erfa"}) {
    EXPECT_FALSE(contains(needs.out, not_needed)) << needs.out;
  }
}

// Inside another project the tree asks for none of the tool's libraries and sets nothing there.
TEST_F(InstalledLibrary, InsideAProjectItDisturbsNothing) {
  fs::create_directory(scratch_->path() / "project");
  scratch_->write("project/CMakeLists.txt",
                  "cmake_minimum_required(VERSION 3.22)\nproject(sky LANGUAGES CXX)\n"
                  "set(CMAKE_EXPORT_COMPILE_COMMANDS ON)\n"
                  "add_subdirectory(\"" AIRLIGHT_SOURCE_DIR
                  "\" airlight)\n"
                  "add_executable(sky main.cpp)\ntarget_link_libraries(sky airlight::airlight)\n");
  scratch_->write("project/main.cpp",
                  "#include <airlight/airlight.h>\nint main() { return airlight::presets().empty(); }\n");
  const Outcome configured = in_prefix(
      "cmake -S project -B inside -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON "
      "-DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenColorIO=ON "
      "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON");
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const std::string commands = scratch_->read("inside/compile_commands.json");
  const std::size_t at = commands.find("main.cpp.o -c");
  ASSERT_NE(at, std::string::npos) << commands.substr(0, 2000);
  const std::string mine = commands.substr(commands.rfind("\"command\"", at), 500);
  for (const char* flag : {"-Wconversion", "-Werror", "ccache", "-O3", "-fvisibility"}) {
    EXPECT_FALSE(contains(mine.substr(0, mine.find("main.cpp\"")), flag)) << mine;
  }
  EXPECT_FALSE(fs::exists(scratch_->path() / "inside/CTestTestfile.cmake"));
  EXPECT_FALSE(fs::exists(scratch_->path() / "inside/CPackConfig.cmake"));
}

// Programs on the pages are those that are built above, or run as they stand.
TEST_F(InstalledLibrary, ProgramsOfThePagesRun) {
  const Outcome tables = airlight(scratch_->path(), {"luts", "earth-noon", "-o", "tables"});  // which a page reads
  ASSERT_EQ(tables.exit_code, 0) << tables.err;
  std::size_t python = 0;
  std::size_t cpp = 0;
  for (const Document& page : pages_below(AIRLIGHT_SOURCE_DIR)) {
    for (const CodeBlock& block : page.code) {
      if (block.language == "cpp" && contains(block.text, "airlight.h")) {
        ++cpp;
        EXPECT_EQ(block.text, scratch_->read((kLibrary / "examples/one_sky.cpp").string())) << page.file;
      }
      if (block.language != "python" || !fs::exists(fs::path(AIRLIGHT_BUILD_DIR) / "python")) continue;
      ++python;
      scratch_->write("page.py", block.text);
      Start start;
      start.environment = {{"PYTHONPATH", AIRLIGHT_BUILD_DIR "/python"}};
      const Outcome outcome = run(scratch_->path(), {"/usr/bin/python3", "page.py"}, start);
      EXPECT_EQ(outcome.exit_code, 0) << page.file << ":\n" << block.text << outcome.err;
    }
  }
  EXPECT_GT(cpp, 0U);
  EXPECT_TRUE(python > 1 || !fs::exists(fs::path(AIRLIGHT_BUILD_DIR) / "python"));
}

}  // namespace
}  // namespace airlight::test
