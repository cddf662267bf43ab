#include "core/foreign/voxels.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/foreign/module.h"
#include "core/foreign/vdb_head.h"
#include "core/scene/named_file.h"
#include "core/scene/printable.h"

namespace airlight::foreign {
namespace {

// What the reading process may take: grids of zeros are packed tight, so files grow in memory.
constexpr std::uint64_t kMemory = std::uint64_t{640} << 20U;
constexpr std::uint64_t kMemoryPerByte = 16;
constexpr std::uint64_t kSeconds = 20;
constexpr std::uint64_t kBytesPerSecond = std::uint64_t{4} << 20U;

bool write_all(int to, const void* data, std::size_t bytes) {
  const char* next = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = ::write(to, next, bytes);
    if (written <= 0 && errno != EINTR) {
      return false;
    }
    next += std::max<ssize_t>(written, 0);
    bytes -= static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  return true;
}

bool read_all(int from, void* data, std::size_t bytes) {
  char* next = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t got = ::read(from, next, bytes);
    if (got == 0 || (got < 0 && errno != EINTR)) {
      return false;
    }
    next += std::max<ssize_t>(got, 0);
    bytes -= static_cast<std::size_t>(std::max<ssize_t>(got, 0));
  }
  return true;
}

void limit(int resource, std::uint64_t most) {
  struct rlimit now = {};
  ::getrlimit(static_cast<__rlimit_resource_t>(resource), &now);
  now.rlim_cur = std::min<rlim_t>(most, now.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &now);
}

std::uint64_t memory_now() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// In the reading process: the length of the problem and its text, then the head and the values.
[[noreturn]] void answer(int to, VoxelsFunction read, const std::string& file, const std::string& grid,
                         std::size_t most, std::uint64_t file_bytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_AS, memory_now() + kMemory + kMemoryPerByte * file_bytes);
  limit(RLIMIT_CPU, kSeconds + file_bytes / kBytesPerSecond);
  std::signal(SIGXCPU, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
  // The library reports damage there too, in lines of its own.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDERR_FILENO);
  // Voxels that are read when they are asked for come from a copy of the file, which nobody would remove.
  ::setenv("OPENVDB_DISABLE_DELAYED_LOAD", "1", 1);
  Voxels voxels;
  std::string problem;
  read(file, grid, most, voxels, problem);
  const std::size_t length = problem.size();
  const bool told = write_all(to, &length, sizeof length) && write_all(to, problem.data(), length) &&
                    write_all(to, &voxels.count, sizeof voxels.count) &&
                    write_all(to, &voxels.size, sizeof voxels.size) &&
                    write_all(to, &voxels.corner, sizeof voxels.corner) &&
                    write_all(to, voxels.values.data(), voxels.values.size() * sizeof(float));
  ::_exit(told ? 0 : 1);
}

// The other end of answer(); whether all of it came.
bool receive(int from, std::size_t most, Voxels& voxels, std::string& problem) {
  constexpr std::size_t kLongest = 4096;
  std::size_t length = 0;
  if (!read_all(from, &length, sizeof length) || length > kLongest) {
    return false;
  }
  problem.resize(length);
  if (!read_all(from, problem.data(), length) || !read_all(from, &voxels.count, sizeof voxels.count) ||
      !read_all(from, &voxels.size, sizeof voxels.size) || !read_all(from, &voxels.corner, sizeof voxels.corner)) {
    return false;
  }
  if (!problem.empty()) {
    return true;
  }
  const auto [nx, ny, nz] = voxels.count;
  if (std::min({nx, ny, nz}) < 1 || 1.0 * nx * ny * nz > static_cast<double>(most)) {
    return false;
  }
  voxels.values.resize(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz));
  return read_all(from, voxels.values.data(), voxels.values.size() * sizeof(float));
}

std::string read_apart(const std::string& file, const std::string& grid, std::size_t most, Voxels& voxels) {
  static const auto read = reinterpret_cast<VoxelsFunction>(module_entry(kVoxelsEntry));
  std::error_code ignored;
  const std::uint64_t bytes = std::filesystem::file_size(file, ignored);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    throw RunError(file + ": no pipe to read it through: " + std::strerror(errno));
  }
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    answer(ends[1], read, file, grid, most, bytes);
  }
  ::close(ends[1]);
  std::string problem;
  const bool whole = child > 0 && receive(ends[0], most, voxels, problem);
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child < 0) {
    throw RunError(file + ": no process to read it in: " + std::strerror(errno));
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    return "takes longer than a file of its size may: is it damaged?";
  }
  return whole ? problem : "damaged or cut short: reading it failed; write or copy it again";
}

// `file` holds a grid of numbers of that name.
void require_grid(const std::string& file, const std::string& grid) {
  const std::vector<VdbGrid> grids = vdb_grids(file);
  const auto named = std::ranges::find(grids, grid, &VdbGrid::name);
  if (named == grids.end()) {
    constexpr std::size_t kMostNamed = 20;
    std::string list = joined_of(std::span(grids).first(std::min(grids.size(), kMostNamed)),
                                 [](const VdbGrid& other) { return quoted_text(other.name); });
    if (grids.size() > kMostNamed) {
      list += " and " + std::to_string(grids.size() - kMostNamed) + " more";
    }
    throw std::runtime_error("has no grid " + quoted_text(grid) + "; " +
                             (grids.empty() ? "it has none" : "it has " + list));
  }
  if (!named->real) {
    throw std::runtime_error("the grid " + quoted_text(grid) +
                             " holds no floating-point numbers, so it is no fog volume; choose another");
  }
}

}  // namespace

Voxels read_voxels(const std::string& file, const std::string& grid, std::size_t most) {
  if (const std::string problem = named_file_problem(file); !problem.empty()) {
    throw InputError(file + ": cannot be read: " + problem + "; expected a file of OpenVDB");
  }
  Voxels voxels;
  std::string problem;
  try {
    require_grid(file, grid);
    problem = read_apart(file, grid, most, voxels);
  } catch (const RunError&) {
    throw;
  } catch (const std::runtime_error& reason) {
    problem = reason.what();
  }
  if (!problem.empty()) {
    throw InputError(file + ": " + printable(problem));
  }
  return voxels;
}

}  // namespace airlight::foreign
