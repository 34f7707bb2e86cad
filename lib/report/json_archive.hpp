// A record as JSON text.
#pragma once

#include <string>
#include <vector>

#include "record/record.hpp"
#include "report/in_units.hpp"

namespace kinestat {

enum class JsonLayout {
  indented,   ///< a key or item a line, indented by two
  line,       ///< all on one line
  ascii_line  ///< the same with nothing but ASCII
};

/// Writes one value, in the units of the file. Numbers are finite and never -0; null where there is
/// no value.
class JsonArchive : public Archive {
 public:
  JsonArchive(const FileUnits& units, JsonLayout layout) : in_(units), layout_(layout) {}

  /// What was written, with a line feed at its end; once.
  std::string take();

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
  // An object, a map or a list that is not closed yet.
  struct Open {
    bool is_list = false;
    bool is_empty = true;
  };

  void open(bool is_list);
  void close();
  void start();  // a value: what stands before it
  void break_line();
  void append(std::string_view text);  // as a JSON string

  InUnits in_;
  JsonLayout layout_;
  std::string out_;
  std::string key_;  // of the next value
  std::vector<Open> open_;
};

/// What a view shows, by its record.
template <class View>
std::string json_text(const Record<View>& record,
                      const View& view,
                      const FileUnits& units,
                      JsonLayout layout) {
  JsonArchive archive(units, layout);
  record.write(view, archive);
  return archive.take();
}

}  // namespace kinestat
