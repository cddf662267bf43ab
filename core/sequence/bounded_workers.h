#pragma once
// Threads that work off a short queue. Whoever fills the queue has to wait, so that it does not fill the memory.

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
  // At most `waiting` pieces of work wait while `threads` pieces are being done.
  BoundedWorkers(unsigned threads, std::size_t waiting);
  // Drops waiting work and finishes the work being done.
  ~BoundedWorkers();
  BoundedWorkers(const BoundedWorkers&) = delete;
  BoundedWorkers& operator=(const BoundedWorkers&) = delete;

  // Waits until there is room. Rethrows the exception of the first piece of work that failed; after it none is begun.
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
