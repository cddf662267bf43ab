// Files that a preset or an option names: what is no file, what is too large, what is no picture.
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "core/output/exr.h"
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

class NamedFiles : public SmallSky {
 protected:
  void SetUp() override {
    SmallSky::SetUp();
    fs::create_directory(scratch_.path() / "folder");
    ::mkfifo((scratch_.path() / "pipe").c_str(), 0600);
    std::ofstream(scratch_.path() / "large") << std::string((16U << 20U) + 1, ' ');
  }

  // None of the commands may wait for a writer.
  Outcome bounded(std::vector<std::string> words) const {
    words.insert(words.begin(), {"timeout", "-s", "KILL", "60", tool_program()});
    return run(scratch_.path(), words);
  }

  // The complaint about a preset with these keys.
  std::string complaint(const std::string& keys, const std::string& base = "earth") const {
    scratch_.write(
        "x.json", R"({"airlight": 1, "extends": ")" + base + R"(", "image": {"width": 8, "height": 8}, )" + keys + "}");
    const Outcome outcome = bounded({"check", "x.json"});
    EXPECT_EQ(outcome.exit_code, 2) << keys << outcome.out;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    return outcome.err;
  }
};

struct Kind {
  const char* file;
  const char* told;
};
constexpr Kind kNoFiles[] = {{"/dev/zero", "is a device"}, {"pipe", "is a pipe"}, {"folder", "is a directory"}};

TEST_F(NamedFiles, ACurveIsAFile) {
  for (const auto& [file, told] : {kNoFiles[0], kNoFiles[1], kNoFiles[2], Kind{"large", "is larger than 16 MiB"}}) {
    const std::string text = complaint(R"("planet": {"ground_albedo": {"file": ")" + std::string(file) + "\"}}");
    EXPECT_TRUE(contains(text, std::string(" cannot be read: ") + told)) << text;
  }
}

TEST_F(NamedFiles, APhaseFunctionIsAFile) {
  for (const auto& [file, told] : {kNoFiles[0], kNoFiles[1], kNoFiles[2], Kind{"large", "is larger than 16 MiB"}}) {
    const std::string text =
        complaint(R"("media": [{"name": "a", "scattering_per_km": 0.01, "phase": {"function": "table", "file": ")" +
                  std::string(file) + R"("}, "density": {"profile": "exponential", "scale_height_km": 8}}])");
    EXPECT_TRUE(contains(text, std::string(" cannot be read: ") + told)) << text;
  }
}

TEST_F(NamedFiles, AMapIsAFile) {
  for (const auto& [file, told] : kNoFiles) {
    const std::string name = "\"" + std::string(file) + "\"";
    for (const std::string& keys : {R"("planet": {"albedo_map": )" + name + "}",
                                    R"("planet": {"ocean": {"wind_m_per_s": 5, "mask_map": )" + name + "}}",
                                    R"("planet": {"terrain": {"width_km": 10, "height_map": )" + name + "}}"}) {
      const std::string text = complaint(keys, "earth-hillaire2020");
      EXPECT_TRUE(contains(text, told)) << text;
    }
  }
}

TEST_F(NamedFiles, APresetThatIsExtendedIsAFile) {
  for (const auto& [file, told] : kNoFiles) {
    scratch_.write("y.json", R"({"airlight": 1, "extends": ")" + std::string(file) + "\"}");
    const Outcome outcome = bounded({"check", "y.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, told)) << outcome.err;
  }
}

TEST_F(NamedFiles, ProbeReadsAFile) {
  for (const auto& [file, told] : kNoFiles) {
    const Outcome outcome = bounded({"probe", "sky.json", "--csv", file});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, told)) << outcome.err;
  }
}

TEST_F(NamedFiles, AManifestIsAFile) {
  for (const auto& [file, told] : kNoFiles) {
    const Outcome outcome =
        bounded({"sequence", "sky.json", "-o", "f.#.exr", "--sun-elevation", "1:2:1", "--manifest", file});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, std::string(file) + ": " + told)) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(scratch_.path() / "f.1.exr"));
}

TEST_F(NamedFiles, APlateIsAFile) {
  for (const auto& [file, told] : kNoFiles) {
    const Outcome outcome = bounded({"composite", "sky.json", "--beauty", file, "-o", "out.exr"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, told)) << outcome.err;
  }
}

TEST_F(NamedFiles, DiffTakesFilesFromAFolder) {
  for (const char* folder : {"a", "b"}) {
    fs::create_directory(scratch_.path() / folder);
    const std::vector<float> grey(16, 0.5F);
    write_exr(scratch_.path() / folder / "good.exr", 4, 4, std::vector<ExrChannel>{{"R", grey.data(), 1, true}}, {});
    ::mkfifo((scratch_.path() / folder / "pipe.exr").c_str(), 0600);
  }
  const Outcome outcome = bounded({"diff", "a", "b"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.out, "pipe.exr: is a pipe")) << outcome.out << outcome.err;
}

// A picture that nothing holds: some of OpenImageIO's readers make one of any name.
TEST_F(NamedFiles, AMapIsOfAFormatOfPictures) {
  for (const char* name : {"map.null", "map.txt", "map.zfile"}) {
    scratch_.write(name, "x");
    const std::string text =
        complaint(R"("planet": {"albedo_map": ")" + std::string(name) + "\"}", "earth-hillaire2020");
    EXPECT_TRUE(contains(text, "is no picture that airlight reads; expected EXR, PNG, TIFF")) << text;
  }
}

}  // namespace
}  // namespace airlight::test
