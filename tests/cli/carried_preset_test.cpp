// A preset inside an EXR may come from anybody: it may not name any file of the machine that renders it.
#include <fstream>

#include "core/output/exr.h"
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

class CarriedPreset : public SmallSky {
 protected:
  // An EXR in the folder "got" that carries this preset.
  void write_exr_with(const std::string& preset) const {
    fs::create_directories(scratch_.path() / "got");
    const std::vector<float> grey(16, 0.5F);
    ExrOptions options;
    options.provenance = Provenance{.preset_json = preset, .method = "march", .version = "", .device = ""};
    write_exr(scratch_.path() / "got/sky.exr", 4, 4, std::vector<ExrChannel>{{"R", grey.data(), 1, true}}, options);
  }
  static std::string with_curve(const std::string& file) {
    return R"({"airlight": 1, "extends": "earth", "planet": {"ground_albedo": {"file": ")" + file + "\"}}}";
  }
  Outcome check(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"check", "got/sky.exr"});
    return tool(more);
  }
};

constexpr const char* kCurve = "400,0.1\n700,0.1\n";

TEST_F(CarriedPreset, NamesFilesBesideThePictureAlone) {
  write_exr_with(with_curve("curve.csv"));
  scratch_.write("got/curve.csv", kCurve);
  EXPECT_EQ(check().exit_code, 0) << check().err;
  const std::string outside = scratch_.write("curve.csv", kCurve).string();
  fs::create_symlink(outside, scratch_.path() / "got/link.csv");
  for (const std::string& file : {outside, std::string("../curve.csv"), std::string("link.csv")}) {
    write_exr_with(with_curve(file));
    const Outcome refused = check();
    EXPECT_EQ(refused.exit_code, 2) << file;
    EXPECT_TRUE(
        contains(refused.err, "/planet/ground_albedo/file: \"" + file + "\" is outside of the picture's folder"))
        << refused.err;
    EXPECT_TRUE(contains(refused.err, "--allow-files")) << refused.err;
    EXPECT_EQ(check({"--allow-files"}).exit_code, 0) << check({"--allow-files"}).err;
  }
}

TEST_F(CarriedPreset, IsNotOpenedToTellItApart) {
  for (const char* key : {R"("planet": {"albedo_map": "/etc/hostname"})", R"("extends": "../sky.json")",
                          R"("planet": {"terrain": {"width_km": 1, "height_map": "/etc/hostname"}})",
                          R"("media": [{"name": "a", "phase": {"function": "table", "file": "/etc/hostname"}}])"}) {
    write_exr_with(R"({"airlight": 1, )" + std::string(key) + "}");
    const Outcome refused = check();
    EXPECT_EQ(refused.exit_code, 2) << key;
    EXPECT_TRUE(contains(refused.err, "is outside of the picture's folder")) << refused.err;
  }
  scratch_.write("got/base.json", small_preset());
  write_exr_with(R"({"airlight": 1, "extends": "base.json"})");
  EXPECT_EQ(check().exit_code, 0) << check().err;
}

}  // namespace
}  // namespace airlight::test
