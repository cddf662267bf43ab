#include "core/sequence/bounded_workers.h"

#include <utility>

namespace airlight::sequence {

BoundedWorkers::BoundedWorkers(unsigned threads, std::size_t waiting) : waiting_max_(waiting) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

BoundedWorkers::~BoundedWorkers() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    queue_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void BoundedWorkers::add(std::function<void()> work) {
  std::unique_lock lock(mutex_);
  // A free thread takes the work at once, whatever else waits.
  changed_.wait(lock, [&] { return failure_ || queue_.size() + in_hand_ < waiting_max_ + threads_.size(); });
  throw_failure();
  queue_.push_back(std::move(work));
  changed_.notify_all();
}

void BoundedWorkers::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return queue_.empty() && in_hand_ == 0; });
  throw_failure();
}

void BoundedWorkers::throw_failure() {
  if (failure_) std::rethrow_exception(failure_);
}

void BoundedWorkers::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return closing_ || !queue_.empty(); });
    if (queue_.empty()) return;
    std::function<void()> work = std::move(queue_.front());
    queue_.pop_front();
    ++in_hand_;
    lock.unlock();
    std::exception_ptr problem;
    try {
      work();
    } catch (...) {
      problem = std::current_exception();
    }
    work = nullptr;  // frees what the work holds before the next is let in
    lock.lock();
    --in_hand_;
    if (problem && !failure_) failure_ = problem;
    if (failure_) queue_.clear();
    changed_.notify_all();
  }
}

}  // namespace airlight::sequence
