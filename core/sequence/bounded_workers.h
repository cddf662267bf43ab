#pragma once
// Threads that work off a short queue, so that whoever fills it is held back instead of filling the memory.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace airlight::sequence {

class BoundedWorkers {
 public:
  // At most `waiting` pieces of work wait while `threads` others are in hand.
  BoundedWorkers(unsigned threads, std::size_t waiting);
  // Drops what waits, lets what is in hand come to its end.
  ~BoundedWorkers();
  BoundedWorkers(const BoundedWorkers&) = delete;
  BoundedWorkers& operator=(const BoundedWorkers&) = delete;

  // Waits until there is room. Throws what the first piece of work to fail has thrown; from then on none is begun.
  void add(std::function<void()> work);

  // Returns when all work is done. Throws as add() does.
  void finish();

 private:
  void run();
  void throw_failure();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> queue_;
  std::size_t waiting_max_;
  std::size_t in_hand_ = 0;
  bool closing_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace airlight::sequence
