// A record as JSON.
#pragma once

#include <string>
#include <vector>

#include "record/record.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Builds one value, in the units of the file.
class JsonArchive : public Archive {
 public:
  explicit JsonArchive(const FileUnits& units) : in_(units) {}

  /// What was written; once.
  Json take() { return std::move(result_); }

  bool begin(const Property& property) override;
  void end(const Property& property) override;
  void element(std::string_view name, std::string_view status) override;
  void begin_object(std::size_t key_count) override;
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
  struct Open {
    std::string key;  // in what contains it
    Json value;
  };

  void open(Json value);
  void close();
  void put(Json value);

  InUnits in_;
  std::vector<Open> open_;
  std::string key_;
  Json result_;
};

/// What a view shows, by its record.
template <class View>
Json json_of(const Record<View>& record, const View& view, const FileUnits& units) {
  JsonArchive archive(units);
  record.write(view, archive);
  return archive.take();
}

}  // namespace kinestat
