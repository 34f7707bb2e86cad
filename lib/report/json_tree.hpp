// A record as a tree of JSON, for what is looked up in it or put together.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "record/record.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Builds one value, in the units of the file. What is only to be written goes by json_text.
class JsonTree : public Archive {
 public:
  explicit JsonTree(const FileUnits& units) : in_(units) {}

  /// What was written; once.
  Json take();

  bool begin(const Property& property) override;
  void end(const Property& property) override;
  void element(std::string_view name, std::string_view status) override;
  void begin_object() override;
  void end_object() override;
  void begin_map() override;
  void end_map() override;
  void begin_list() override;
  void end_list() override;
  void quantity(const std::optional<double>& si, QuantityKind kind) override;
  void number(const std::optional<double>& value, std::string_view unit) override;
  void whole(std::int64_t value) override;
  void text(std::string_view value) override;
  void flag(bool value) override;
  void null() override;

 private:
  using Member = std::pair<std::string, Json>;

  // What is written and not closed yet.
  struct Open {
    std::string key;        // in what contains it
    std::size_t begin = 0;  // of its members
    bool is_list = false;
    Json::array_t items;  // of a list
  };

  void open(bool is_list);
  void close();

  template <class Value>
  void put(Value&& value) {
    if (!open_.empty() && open_.back().is_list) {
      open_.back().items.emplace_back(std::forward<Value>(value));
    } else {
      members_.emplace_back(key_, std::forward<Value>(value));
    }
  }

  InUnits in_;
  std::vector<Open> open_;
  std::vector<Member> members_;  // of all objects and maps that are open
  std::string key_;
};

/// What a view shows, by its record.
template <class View>
Json json_of(const Record<View>& record, const View& view, const FileUnits& units) {
  JsonTree archive(units);
  record.write(view, archive);
  return archive.take();
}

}  // namespace kinestat
