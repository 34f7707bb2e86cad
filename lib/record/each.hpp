// The elements of maps and lists while a record is written.
#pragma once

#include <optional>
#include <string_view>

#include "record/archive.hpp"

namespace kinestat {

template <class View>
class Record;

/// Takes the elements of a map or the items of a list, one after the other.
template <class Item>
class Each {
 public:
  Each(Archive& to, const Record<Item>& record) : to_(to), record_(record) {}

  /// The element of that name; its status, if it is not that of the whole.
  void operator()(std::string_view name, const Item& item, std::string_view status = {}) const {
    to_.element(name, status);
    record_.write(item, to_);
  }

  /// One without a value.
  void operator()(std::string_view name, std::nullopt_t) const {
    to_.element(name, {});
    to_.null();
  }

  /// The next item of a list.
  void operator()(const Item& item) const { record_.write(item, to_); }

 private:
  Archive& to_;
  const Record<Item>& record_;
};

/// Takes numbers by name.
class EachNumber {
 public:
  explicit EachNumber(Archive& to) : to_(to) {}

  /// In SI; with the status of the element, if it is not that of the whole.
  void operator()(std::string_view name,
                  const std::optional<double>& si,
                  QuantityKind kind,
                  std::string_view status = {}) const {
    to_.element(name, status);
    to_.quantity(si, kind);
  }

 private:
  Archive& to_;
};

/// Takes names, one after the other.
class EachName {
 public:
  explicit EachName(Archive& to) : to_(to) {}

  void operator()(std::string_view name) const { to_.text(name); }

 private:
  Archive& to_;
};

}  // namespace kinestat
