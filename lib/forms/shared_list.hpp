// A list whose copies share their items until one of them grows.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace kinestat {

/// Declarations are put together from others, which are copied at every level: so they share what
/// is in them. The items may be of a type that holds such a list itself.
template <class T>
class SharedList {
 public:
  SharedList() = default;

  SharedList(std::initializer_list<T> items) : items_(std::make_shared<std::vector<T>>(items)) {}

  const T* begin() const { return items_ == nullptr ? nullptr : items_->data(); }

  const T* end() const { return begin() + size(); }

  std::size_t size() const { return items_ == nullptr ? 0 : items_->size(); }

  bool empty() const { return size() == 0; }

  const T& front() const { return items_->front(); }

  const T& operator[](std::size_t index) const { return (*items_)[index]; }

  void push_back(T item) { own().push_back(std::move(item)); }

  /// To be changed; other copies stay as they are.
  T& back() { return own().back(); }

 private:
  std::vector<T>& own() {
    if (items_ == nullptr) {
      items_ = std::make_shared<std::vector<T>>();
    } else if (items_.use_count() > 1) {
      items_ = std::make_shared<std::vector<T>>(*items_);
    }
    return *items_;
  }

  std::shared_ptr<std::vector<T>> items_;
};

}  // namespace kinestat
