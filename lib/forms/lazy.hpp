// A value that is made when it is first asked for.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

namespace kinestat {

/// Of all sections that can be written a file has a few: the others are never made. Copies share
/// the value.
template <class T>
class Lazy {
 public:
  Lazy() requires std::default_initializable<T>
  = default;  ///< of `T()`

  Lazy(T value) : state_(std::make_shared<State>(nullptr)) { state_->value = std::move(value); }

  template <std::invocable Make>
  explicit Lazy(Make make) : state_(std::make_shared<State>(std::move(make))) {}

  const T& operator*() const {
    if constexpr (std::default_initializable<T>) {
      static const T nothing;
      if (state_ == nullptr) {
        return nothing;
      }
    }
    if (state_->make != nullptr) {
      std::call_once(state_->is_made, [this] { state_->value.emplace(state_->make()); });
    }
    return *state_->value;
  }

  const T* operator->() const { return &**this; }

  operator const T&() const { return **this; }

 private:
  struct State {
    template <class Make>
    explicit State(Make given) : make(std::move(given)) {}

    std::function<T()> make;  ///< empty: the value was given
    std::once_flag is_made;
    std::optional<T> value;
  };

  std::shared_ptr<State> state_;
};

template <std::invocable Make>
Lazy(Make) -> Lazy<std::remove_cvref_t<std::invoke_result_t<Make>>>;

}  // namespace kinestat
