#pragma once
// Rows of a picture over the machine's cores.

#include <algorithm>
#include <thread>
#include <vector>

namespace airlight {

// Calls work(first_row, end_row) once for each of a few strips that cover 0 to rows; strips do not overlap, and the
// result must not depend on where they are cut. Nothing may be thrown by `work`.
template <class Work>
void for_row_strips(int rows, const Work& work) {
  constexpr int kFewestRows = 16;  // a thread's start costs about as much as so many rows
  const int cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 64U));
  const int strips = std::clamp(rows / kFewestRows, 1, cores);
  std::vector<std::jthread> threads;
  for (int i = 1; i < strips; ++i) {
    threads.emplace_back([&work, rows, strips, i] { work(rows * i / strips, rows * (i + 1) / strips); });
  }
  work(0, rows / strips);
}

}  // namespace airlight
