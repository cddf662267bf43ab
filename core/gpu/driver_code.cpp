#include "core/gpu/driver_code.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "driver_code";
constexpr const char* kCache = "driver_code_tables";  // the cache folder of the build's renders
// Made last by the build: another text for each set of shaders. In the user's cache: which set was taken, and where to.
constexpr const char* kStamp = "stamp";

fs::path from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
}

bool mesa_keeps_nothing() {
  const char* value = std::getenv("MESA_SHADER_CACHE_DISABLE");
  return value != nullptr && (value == std::string("true") || value == std::string("1"));
}

// Where Mesa makes its folders: $MESA_SHADER_CACHE_DIR, else $XDG_CACHE_HOME, else $HOME/.cache.
fs::path mesa_folder() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "XDG_CACHE_HOME"}) {
    if (std::getenv(name) != nullptr) return from_environment(name);
  }
  const fs::path home = from_environment("HOME");
  return home.empty() ? home : home / ".cache";
}

// The folder that the build left; empty: none.
fs::path built_folder() {
  std::error_code problem;
  const fs::path folder = fs::read_symlink("/proc/self/exe", problem).parent_path() / kFolder;
  return fs::exists(folder / kStamp, problem) ? folder : fs::path();
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Whole or not at all, and never over a file that is there: Mesa or another process may be at work in the folder.
void take(const fs::path& from, const fs::path& to) {
  std::error_code problem;
  if (fs::exists(to, problem)) return;
  fs::create_directories(to.parent_path(), problem);
  const fs::path part = to.string() + ".airlight-" + std::to_string(::getpid());
  if (fs::copy_file(from, part, problem) && ::link(part.c_str(), to.c_str()) != 0) problem = {};
  fs::remove(part, problem);
}

void take_all(const fs::path& from, const fs::path& to) {
  std::error_code problem;
  fs::recursive_directory_iterator entry(from, problem);
  for (; !problem && entry != fs::recursive_directory_iterator(); entry.increment(problem)) {
    std::error_code ignored;
    const std::string name = entry->path().filename();
    // Mesa's list of what it has: its own.
    if (name != "index" && name != kStamp && entry->is_regular_file(ignored)) {
      take(entry->path(), to / entry->path().lexically_relative(from));
    }
  }
}

}  // namespace

void take_driver_code(const fs::path& cache) {
  const fs::path to = mesa_folder();
  if (cache.empty() || to.empty() || mesa_keeps_nothing()) return;
  const fs::path from = built_folder();
  if (from.empty()) return;
  const std::string taken = text_of(from / kStamp) + "\n" + to.string() + "\n";
  const fs::path note = cache / kFolder;
  if (text_of(note) == taken) return;
  take_all(from, to);
  std::error_code problem;
  if (fs::create_directories(cache, problem)) fs::permissions(cache, fs::perms::owner_all, problem);
  std::ofstream(note) << taken;
}

fs::path built_tables() {
  const fs::path code = built_folder();
  return code.empty() ? code : code.parent_path() / kCache / "tables";
}

}  // namespace airlight
