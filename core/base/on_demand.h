#pragma once
// A value that is made when it is first asked for, and then shared by all copies.

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace airlight {

template <class T>
class OnDemand {
 public:
  OnDemand() = default;
  explicit OnDemand(std::function<T()> make) : state_(std::make_shared<State>()) { state_->make = std::move(make); }

  // False: there is nothing to make.
  explicit operator bool() const { return state_ != nullptr; }

  // What making it throws is passed on, and the next call tries again.
  const T& get() const { return *shared(); }

  std::shared_ptr<const T> shared() const {
    std::call_once(state_->once, [this] {
      state_->value = std::make_shared<const T>(state_->make());
      state_->make = nullptr;
    });
    return state_->value;
  }

 private:
  struct State {
    std::once_flag once;
    std::function<T()> make;
    std::shared_ptr<const T> value;
  };
  std::shared_ptr<State> state_;
};

}  // namespace airlight
