// The forms in which a solution is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/types.hpp"
#include "record/shape.hpp"

namespace kinestat {

/// Walks a solution as its record tells it: keys in their order, values in SI. Whatever the form,
/// it takes key, unit and table from the shape and changes no number.
class Archive {
 public:
  Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  virtual ~Archive() = default;

  /// Begins a property of the object that is open. False: this form has no place for it, and its
  /// value must not be written.
  virtual bool begin(const Property& property) = 0;
  virtual void end(const Property& property) = 0;

  /// What follows, up to the next call or the end of the map, belongs to that name. An empty status
  /// is that of the whole.
  virtual void element(std::string_view name, std::string_view status) = 0;

  virtual void begin_object() = 0;
  virtual void end_object() = 0;
  virtual void begin_map() = 0;
  virtual void end_map() = 0;
  virtual void begin_list() = 0;
  virtual void end_list() = 0;

  /// In SI; empty: there is no value.
  virtual void quantity(const std::optional<double>& si, QuantityKind kind) = 0;
  /// In that unit, which is the file's; bare if that is empty.
  virtual void number(const std::optional<double>& value, std::string_view unit) = 0;
  virtual void whole(std::int64_t value) = 0;
  virtual void text(std::string_view value) = 0;
  virtual void flag(bool value) = 0;
  virtual void null() = 0;
};

}  // namespace kinestat
