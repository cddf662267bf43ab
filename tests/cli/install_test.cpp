// Contents of `cmake --install` and of the Debian package, and their use outside the build folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tests/cli/pages.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

// Besides what is named here, the presets and the pages with their pictures, whose lists are those of the source.
// `whole`: with the formats of pictures, libairlight and the Python package, which have Debian packages of their own.
std::vector<std::string> expected_files(const std::string& zsh_folder, bool whole) {
  std::vector<std::string> files = {"bin/airlight",
                                    "share/airlight/presets/plates/hills.exr",
                                    "share/airlight/presets/schema/preset-1.schema.json",
                                    "share/bash-completion/completions/airlight",
                                    "share/doc/airlight/changelog.gz",
                                    "share/doc/airlight/copyright",
                                    "share/fish/vendor_completions.d/airlight.fish",
                                    "share/man/man1/airlight.1.gz",
                                    "share/zsh/" + zsh_folder + "/_airlight"};
  for (const fs::directory_entry& entry : fs::directory_iterator(AIRLIGHT_SOURCE_DIR "/presets")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".json" && name != "chart.json") files.push_back("share/airlight/presets/" + name);
  }
  const fs::path build = AIRLIGHT_BUILD_DIR;
  if (whole) {
    for (const char* file : {"lib/airlight/modules/airlight_foreign.so", "share/doc/airlight-formats/changelog.gz",
                             "share/doc/airlight-formats/copyright"}) {
      files.emplace_back(file);
    }
  }
  if (whole && fs::exists(build / "libairlight.a")) {
    for (const char* file :
         {"include/airlight/airlight.h", "lib/cmake/airlight/airlightConfig.cmake",
          "lib/cmake/airlight/airlightConfigVersion.cmake", "lib/libairlight.a", "lib/libairlight.so",
          "lib/libairlight.so.0.1", "lib/libairlight.so.0.1.0", "lib/pkgconfig/airlight.pc"}) {
      files.emplace_back(file);
    }
    for (const char* package : {"libairlight-dev", "libairlight0.1"}) {
      files.push_back(std::string("share/doc/") + package + "/changelog.gz");
      files.push_back(std::string("share/doc/") + package + "/copyright");
    }
  }
  if (whole && fs::exists(build / "python")) {
    for (const fs::directory_entry& entry : fs::directory_iterator(build / "python/airlight")) {
      if (entry.is_regular_file()) {
        files.push_back("lib/python3/dist-packages/airlight/" + entry.path().filename().string());
      }
    }
    files.emplace_back("share/doc/python3-airlight/changelog.gz");
    files.emplace_back("share/doc/python3-airlight/copyright");
  }
  std::set<fs::path> documents;
  for (const Document& page : pages_below(AIRLIGHT_SOURCE_DIR)) {
    const fs::path room = page.file.parent_path();
    if (room != "app" && room != "core" && room != "presets" && room != "tests/truth") continue;
    documents.insert(page.file);
    for (const fs::path link : page.links) {
      if (link.extension() == ".png") documents.insert((room / link).lexically_normal());
    }
  }
  for (const fs::path& document : documents) files.push_back("share/doc/airlight/" + document.string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// All may read what is installed, and enter its folders, whatever the umask of whoever installed it.
void expect_rights_for_all(const fs::path& prefix) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix)) {
    const bool enter = entry.is_directory() || entry.path() == prefix / "bin/airlight";
    const auto wanted = static_cast<fs::perms>(enter ? 0555 : 0444);
    EXPECT_EQ(entry.status().permissions() & wanted, wanted) << entry.path();
  }
}

// Uses the tool from / with only the installed folder before the system's own on PATH.
void expect_that_it_works(const fs::path& prefix, const Scratch& scratch) {
  Start start;
  start.environment = {{"PATH", (prefix / "bin").string() + ":/usr/bin:/bin"}, {"OUT", scratch.path().string()}};
  const Outcome used = run("/",
                           {"sh", "-euc",
                            "airlight render earth-noon --size 16x9 -q -o \"$OUT/a.exr\" --png \"$OUT/a.png\"\n"
                            "airlight render \"$0/share/airlight/presets/earth-noon.json\" --size 16x9 -q -o "
                            "\"$OUT/b.exr\"\n"
                            "airlight diff \"$OUT/a.exr\" \"$OUT/b.exr\" --heatmap \"$OUT/error.png\"\n"
                            "gzip -dc \"$0/share/man/man1/airlight.1.gz\" | head -1\n"
                            "gzip -dc \"$0/share/doc/airlight/changelog.gz\" | dpkg-parsechangelog -l - -S Version\n",
                            prefix.string()},
                           start);
  EXPECT_EQ(used.exit_code, 0) << used.err;
  EXPECT_TRUE(contains(used.out, "PASS")) << used.out;
  EXPECT_TRUE(contains(used.out, ".TH AIRLIGHT 1")) << used.out;
  EXPECT_TRUE(contains(airlight(scratch.path(), {"--version"}).out, lines_of(used.out).back())) << used.out;
  EXPECT_EQ(scratch.read("a.png").substr(1, 3), "PNG");
  EXPECT_EQ(scratch.read("error.png").substr(1, 3), "PNG");
}

TEST(Install, PutsEverythingInPlaceAndMayBeMoved) {
  const Scratch scratch;
  const Outcome outcome = run(scratch.path(), {"sh", "-c", "umask 077; exec cmake --install \"$0\" --prefix \"$1\"",
                                               AIRLIGHT_BUILD_DIR, (scratch.path() / "first").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_rights_for_all(scratch.path() / "first");
  EXPECT_EQ(files_below(scratch.path() / "first"), expected_files("site-functions", true));
  EXPECT_EQ(dead_links(scratch.path() / "first/share/doc/airlight"), std::vector<std::string>());
  fs::rename(scratch.path() / "first", scratch.path() / "moved to");
  expect_that_it_works(scratch.path() / "moved to", scratch);
  EXPECT_TRUE(contains(scratch.read("moved to/share/doc/airlight/copyright"), "MIT License"));
}

TEST(Install, NothingIsCopiedWhereAFileIsMissing) {
  const Scratch scratch;
  const Scratch build;
  std::string script = build.read(AIRLIGHT_BUILD_DIR "/cmake_install.cmake");
  const std::string made = "airlight.1.gz";
  for (std::size_t at = script.find(made); at != std::string::npos; at = script.find(made, at)) {
    script.replace(at, made.size(), "never-made");
  }
  const std::string told = "set(airlight_build \"";
  const std::size_t from = script.find(told) + told.size();
  const std::string far = "/" + std::string(100, 'x');
  script.replace(from, script.find('"', from) - from, far + "/someone's build");
  const std::string file = build.write("cmake_install.cmake", script).string();
  const Outcome outcome =
      run(build.path(), {"cmake", "-DCMAKE_INSTALL_PREFIX=" + (scratch.path() / "prefix").string(), "-P", file});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.err, "never-made is missing, so nothing is installed;")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "cmake --build '" + far + "/someone'\\''s build' --target airlight\n"))
      << outcome.err;
  EXPECT_FALSE(fs::exists(scratch.path() / "prefix"));
}

TEST(Install, NothingIsCopiedWhereAFolderCannotBe) {
  const Scratch scratch;
  scratch.write("share", "a file where a folder is to be");
  const Outcome outcome =
      run(scratch.path(), {"cmake", "--install", AIRLIGHT_BUILD_DIR, "--prefix", scratch.path().string()});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.err, "/share cannot be written")) << outcome.err;
  EXPECT_EQ(scratch.files(), std::vector<std::string>{"share"});
}

// scripts/test-package installs it with apt in a clean root, which takes minutes and the network.
TEST(Package, HoldsEverythingAndNamesWhatItNeeds) {
  const Scratch scratch;
  for (const char* tool : {"dpkg-shlibdeps", "file"}) {
    if (run(scratch.path(), {"sh", "-c", "command -v " + std::string(tool)}).exit_code != 0) {
      GTEST_SKIP() << tool << " is not installed";
    }
  }
  const Outcome made =
      run(scratch.path(),
          {"sh", "-c",
           "umask 077; exec cpack -D 'CPACK_COMPONENTS_ALL=Tool;Formats' --config \"$0/CPackConfig.cmake\" -B .",
           AIRLIGHT_BUILD_DIR});
  ASSERT_EQ(made.exit_code, 0) << made.err << made.out;
  const Outcome unpacked = run(scratch.path(), {"sh", "-c",
                                                "dpkg-deb -x airlight_*.deb root && dpkg-deb -f airlight_*.deb "
                                                "Package Depends Recommends"});
  ASSERT_EQ(unpacked.exit_code, 0) << unpacked.err;
  // A package needs the libraries of one release, which its file's name tells.
  const Outcome named = run(scratch.path(), {"sh", "-c",
                                             ". /etc/os-release && case $ID in debian) ID=deb ;; esac && "
                                             "ls airlight_*\"~$ID${VERSION_ID}_\"*.deb"});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  for (const char* needed :
       {"libvulkan1", "mesa-vulkan-drivers | vulkan-icd", "tzdata", "libopenexr-", "libopencolorio2", "libpng16",
        "libdeflate0", "libcctz2", "libc6", "Recommends: airlight-formats (= "}) {
    EXPECT_TRUE(contains(unpacked.out, needed)) << needed << " is not in " << unpacked.out;
  }
  // Four fifths of what all of airlight needs come with OpenImageIO, for pictures that are no EXRs.
  EXPECT_FALSE(contains(unpacked.out, "libopenimageio")) << unpacked.out;
  const Outcome formats = run(scratch.path(), {"sh", "-c",
                                               "dpkg-deb -f airlight-formats_*.deb Depends; "
                                               "dpkg-deb -c airlight-formats_*.deb"});
  for (const char* part : {"libopenimageio2", "airlight (= ", "/usr/lib/airlight/modules/airlight_foreign.so"}) {
    EXPECT_TRUE(contains(formats.out, part)) << part << " is not in " << formats.out << formats.err;
  }
  expect_rights_for_all(scratch.path() / "root/usr");
  EXPECT_EQ(files_below(scratch.path() / "root/usr"), expected_files("vendor-completions", false));
  expect_that_it_works(scratch.path() / "root/usr", scratch);
}

// Each package of libairlight with what it needs: none of the tool's libraries for pictures.
TEST(Package, LibrariesComeApart) {
  if (!fs::exists(fs::path(AIRLIGHT_BUILD_DIR) / "libairlight.a")) GTEST_SKIP() << "this build has no libairlight";
  const Scratch scratch;
  const Outcome made =
      run(scratch.path(),
          {"sh", "-c",
           "exec cpack -D 'CPACK_COMPONENTS_ALL=Library;Development;Python' --config \"$0/CPackConfig.cmake\" -B .",
           AIRLIGHT_BUILD_DIR});
  ASSERT_EQ(made.exit_code, 0) << made.err << made.out;
  const auto of = [&](const std::string& package, const std::string& what) {
    return run(scratch.path(), {"sh", "-c", "dpkg-deb " + what + " " + package + "_*.deb"}).out;
  };
  const std::string library = of("libairlight0.1", "-c");
  EXPECT_TRUE(contains(library, "/usr/lib/libairlight.so.0.1.0")) << library;
  EXPECT_FALSE(contains(library, "airlight.h")) << library;
  const std::string needs = of("libairlight0.1", "-f");
  EXPECT_TRUE(contains(needs, "mesa-vulkan-drivers | vulkan-icd")) << needs;
  EXPECT_TRUE(contains(needs, "libc6")) << needs;
  EXPECT_FALSE(contains(needs, "openexr")) << needs;
  const std::string development = of("libairlight-dev", "-c") + of("libairlight-dev", "-f");
  for (const char* part : {"/usr/include/airlight/airlight.h", "/usr/lib/libairlight.a", "/usr/lib/libairlight.so ->",
                           "/usr/lib/pkgconfig/airlight.pc", "libairlight0.1 (= 0.1.0~"}) {
    EXPECT_TRUE(contains(development, part)) << part << " is not in " << development;
  }
  if (!fs::exists(fs::path(AIRLIGHT_BUILD_DIR) / "python")) return;
  const std::string python = of("python3-airlight", "-c") + of("python3-airlight", "-f");
  for (const char* part : {"dist-packages/airlight/__init__.py", "__init__.pyi", "py.typed", "_airlight.cpython-3",
                           "python3-numpy", "python3 (<< 3."}) {
    EXPECT_TRUE(contains(python, part)) << part << " is not in " << python;
  }
}

}  // namespace
}  // namespace airlight::test
