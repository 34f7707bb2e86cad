// A value that is made when it is first asked for, from the object that keeps it.
#pragma once

#include <concepts>
#include <memory>
#include <mutex>
#include <optional>

namespace kinestat {

/// What follows from an object and is dear, so that it is made once and only where somebody asks.
/// Copies make their own: their object may be changed. Several threads may ask.
template <class T>
class MadeOnce {
 public:
  MadeOnce() : state_(std::make_unique<State>()) {}

  MadeOnce(const MadeOnce& /*other*/) : MadeOnce() {}

  MadeOnce& operator=(const MadeOnce& /*other*/) {
    state_ = std::make_unique<State>();
    return *this;
  }

  ~MadeOnce() = default;

  /// `make` must give the same value whoever asks.
  template <std::invocable Make>
  const T& get(const Make& make) const {
    std::call_once(state_->is_made, [&] { state_->value.emplace(make()); });
    return *state_->value;
  }

 private:
  struct State {
    std::once_flag is_made;
    std::optional<T> value;
  };

  std::unique_ptr<State> state_;
};

}  // namespace kinestat
