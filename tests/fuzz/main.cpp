// airlight_fuzz KIND [--count N] [--first SEED] [--seconds S] [--keep DIR] [--tell refused]
// Runs cases by their numbers and reports each fault with its case's number; inputs that caused faults go to DIR. Cases
// run in a child process. If a case ends it, that is reported too, and the next child continues after it.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/fuzz/cases.h"
#include "tests/fuzz/file_cases.h"
#include "tests/fuzz/guarded.h"

namespace airlight::fuzz {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// AddressSanitizer's shadow, and the freed blocks that it keeps, are memory of the process too: a case of 460 MiB takes
// 1186.
#if defined(__SANITIZE_ADDRESS__)
constexpr long kCopiesOfMemory = 3;
#else
constexpr long kCopiesOfMemory = 1;
#endif

// Memory that any case of a few pixels may take, in kB. A broken file's may not take what its numbers ask for.
long most_kilobytes(const std::string& kind) {
  return kCopiesOfMemory * (kind == "exrs" ? 512L << 10 : 1L << 20);
}

// Time of the processor that a picture may take; not by the clock, since other programs run too.
constexpr double kMostSeconds = 60.0;

constexpr std::array<std::string_view, 6> kKinds{"texts", "exrs", "scenes", "files", "plates", "methods"};

struct Order {
  std::string kind;
  std::uint64_t first = 0;
  std::uint64_t count = 100;
  double seconds = 0.0;  // 0: the count alone ends it
  bool tells = false;    // each refusal
  fs::path keep;
};

// The child's results, in memory shared with the parent.
struct Shared {
  std::uint64_t next = 0;  // the case at work
  std::uint64_t refused = 0;
  std::uint64_t faults = 0;
  double slowest = 0.0;
  std::uint64_t slowest_case = 0;
};

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void keep(const Order& order, std::uint64_t number, const std::string& input) {
  if (!order.keep.empty()) {
    fs::create_directories(order.keep);
    const std::string name = order.kind + "-" + std::to_string(number) + (order.kind == "exrs" ? ".exr" : ".json");
    std::ofstream(order.keep / name, std::ios::binary) << input;
  }
}

Outcome run_case(const Order& order, std::uint64_t number, const fs::path& folder) {
  if (order.kind == "texts") {
    return text_case(number);
  }
  return order.kind == "exrs"      ? exr_case(number, folder)
         : order.kind == "files"   ? file_case(number, folder)
         : order.kind == "plates"  ? plate_case(number, folder)
         : order.kind == "methods" ? method_case(number, folder)
                                   : scene_case(number);
}

bool enough(const Order& order, const Shared& shared, Clock::time_point start) {
  return shared.next >= order.first + order.count || (order.seconds > 0.0 && since(start) >= order.seconds);
}

void work(const Order& order, Shared& shared, Clock::time_point start, const fs::path& folder) {
  for (bool alone = true; !enough(order, shared, start); ++shared.next, alone = false) {
    const Clock::time_point began = Clock::now();
    const double before = processor_seconds();
    Outcome outcome = run_case(order, shared.next, folder);
    struct rusage used = {};
    ::getrusage(RUSAGE_SELF, &used);
    if (used.ru_maxrss > most_kilobytes(order.kind) && !alone) {
      return;  // the next child runs the case by itself: a device keeps what it compiled for those before
    }
    if (outcome.fault.empty() && used.ru_maxrss > most_kilobytes(order.kind)) {
      outcome.fault = "took " + std::to_string(used.ru_maxrss >> 10) + " MiB";
    }
    const double seconds = outcome.seconds > 0.0 ? outcome.seconds : processor_seconds() - before;
    if (outcome.fault.empty() && seconds > kMostSeconds) {
      outcome.fault = "took " + std::to_string(seconds) + " s of the processor";
    }
    if (since(began) > shared.slowest) {
      shared.slowest = since(began);
      shared.slowest_case = shared.next;
    }
    shared.refused += outcome.refused ? 1 : 0;
    if (order.tells && outcome.refused) {
      std::printf("%s %llu refused: %s\n", order.kind.c_str(), static_cast<unsigned long long>(shared.next),
                  outcome.message.substr(0, 300).c_str());
    }
    if (!outcome.fault.empty()) {
      ++shared.faults;
      std::printf("%s %llu: %s\n", order.kind.c_str(), static_cast<unsigned long long>(shared.next),
                  outcome.fault.c_str());
      std::fflush(stdout);
      keep(order, shared.next, outcome.input);
      if (used.ru_maxrss > most_kilobytes(order.kind)) {
        ++shared.next;
        return;  // the next child begins with nothing
      }
    }
  }
}

int run(const Order& order) {
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    std::perror("mmap");
    return 1;
  }
  auto& shared = *new (memory) Shared;
  shared.next = order.first;
  std::string pattern = (fs::temp_directory_path() / "airlight-fuzz-XXXXXX").string();
  const fs::path folder = ::mkdtemp(pattern.data());
  const Clock::time_point start = Clock::now();
  while (!enough(order, shared, start)) {
    const pid_t child = ::fork();
    if (child == 0) {
      work(order, shared, start, folder);
      std::fflush(stdout);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      ++shared.faults;
      const bool by_signal = WIFSIGNALED(status);
      std::printf("%s %llu: ended the process by %s %d\n", order.kind.c_str(),
                  static_cast<unsigned long long>(shared.next), by_signal ? "signal" : "exit code",
                  by_signal ? WTERMSIG(status) : WEXITSTATUS(status));
      keep(order, shared.next,
           order.kind == "scenes" || order.kind == "methods" ? scene_text(shared.next)
           : order.kind == "texts" || order.kind == "files"  ? "see its number"
                                                             : "");
      if (order.kind == "exrs") {
        std::error_code ignored;
        fs::copy_file(folder / "broken.exr", order.keep / ("exrs-" + std::to_string(shared.next) + ".exr"), ignored);
      }
      ++shared.next;
    }
  }
  fs::remove_all(folder);
  std::printf("%s %llu to %llu: %llu faults, %llu refused, the slowest %.1f s (%llu)\n", order.kind.c_str(),
              static_cast<unsigned long long>(order.first), static_cast<unsigned long long>(shared.next - 1),
              static_cast<unsigned long long>(shared.faults), static_cast<unsigned long long>(shared.refused),
              shared.slowest, static_cast<unsigned long long>(shared.slowest_case));
  return shared.faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace airlight::fuzz

int main(int argc, char** argv) {
  airlight::fuzz::Order order;
  order.kind = argc > 1 ? argv[1] : "";
  bool good = std::ranges::find(airlight::fuzz::kKinds, order.kind) != airlight::fuzz::kKinds.end();
  for (int i = 2; good && i < argc; i += 2) {
    const std::string name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : nullptr;
    good = value != nullptr;
    if (!good) {
      break;
    }
    if (name == "--count") {
      order.count = std::strtoull(value, nullptr, 10);
    } else if (name == "--first") {
      order.first = std::strtoull(value, nullptr, 10);
    } else if (name == "--seconds") {
      order.seconds = std::strtod(value, nullptr);
    } else if (name == "--tell") {
      order.tells = std::string(value) == "refused";
    } else if (name == "--keep") {
      order.keep = value;
    } else {
      good = false;
    }
  }
  if (!good) {
    std::fprintf(stderr,
                 "usage: airlight_fuzz texts|exrs|scenes|files|plates|methods [--count N] [--first SEED] [--seconds S] "
                 "[--keep DIR] "
                 "[--tell refused]\n");
    return 2;
  }
  return airlight::fuzz::run(order);
}
