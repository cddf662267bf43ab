#include "core/foreign/module.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace airlight::foreign {
namespace {

constexpr const char* kModuleFile = "airlight_foreign.so";

std::filesystem::path find_module() {
  std::error_code problem;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", problem);
  if (problem)
    throw RunError("/proc/self/exe: " + problem.message() + "; /proc must be mounted to find " + kModuleFile);
  const std::filesystem::path beside = program.parent_path() / kModuleFile;
  const std::filesystem::path installed =
      (program.parent_path() / AIRLIGHT_MODULE_FROM_PROGRAM / kModuleFile).lexically_normal();
  for (const std::filesystem::path& candidate : {beside, installed}) {
    if (std::filesystem::exists(candidate, problem)) return candidate;
  }
  throw RunError(std::string(kModuleFile) + ": is neither at " + beside.string() + " nor at " + installed.string() +
                 "; pictures other than EXRs and files of OpenVDB need it: install the package airlight-formats, or "
                 "build the target "
                 "airlight_foreign_module");
}

void* open_module() {
  const std::filesystem::path file = find_module();
  void* const handle = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (handle == nullptr) {
    throw RunError(std::string(dlerror()) + "; it needs OpenImageIO's library (Debian: libopenimageio2.4)");
  }
  return handle;
}

}  // namespace

void* module_entry(const char* name) {
  static void* const handle = open_module();
  void* const entry = dlsym(handle, name);
  if (entry == nullptr) throw RunError(std::string(kModuleFile) + ": has no entry " + name + "; build it again");
  return entry;
}

}  // namespace airlight::foreign
