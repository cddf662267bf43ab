// The heap of a program that asked for large pages.

#include "core/base/huge_pages.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/this_build.h"

namespace airlight::test {
namespace {

bool has_huge_pages() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string modes;
  return std::getline(file, modes) && modes.find("[never]") == std::string::npos;
}

// Whether the kernel was advised to use large pages for some part of the mapping of that name.
bool is_advised(const std::string& name) {
  std::ifstream maps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    const bool is_heading = line.find('-') < line.find(' ');
    if (is_heading) inside = line.find(name) != std::string::npos;
    if (inside && line.starts_with("VmFlags:") && line.find(" hg") != std::string::npos) return true;
  }
  return false;
}

TEST(HugePages, HoldTheHeap) {  // this_build.cpp has asked for them
  if (sanitized()) GTEST_SKIP() << "AddressSanitizer has a heap of its own";
  if (!has_huge_pages()) GTEST_SKIP() << "this machine's kernel gives no large pages";
  EXPECT_TRUE(is_advised("[heap]"));
}

}  // namespace
}  // namespace airlight::test
