// rotate_loops FILE.spv: rotates the loops of the file's module (core/gpu/rotate_loops.h).

#include "core/gpu/rotate_loops.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::vector<std::uint32_t> read_words(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0)) / 4);
  file.seekg(0);
  file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
  if (!file) throw std::runtime_error("cannot read it");
  return words;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  if (arguments.size() != 2) {
    std::fputs("rotate_loops: expected FILE.spv\n", stderr);
    return 2;
  }
  try {
    const std::vector<std::uint32_t> words = airlight::rotate_loops(read_words(arguments[1]));
    std::ofstream file(arguments[1], std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write it");
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "rotate_loops: %s: %s\n", arguments[1], problem.what());
    return 1;
  }
  return 0;
}
