#include "report/json_archive.hpp"

#include <utility>

namespace kinestat {

bool JsonArchive::begin(const Property& property) {
  key_ = property.key;
  return property.is_in_reports;
}

void JsonArchive::end(const Property& /*property*/) {}

void JsonArchive::element(std::string_view name, std::string_view /*status*/) {
  key_ = name;
}

void JsonArchive::begin_object(std::size_t key_count) {
  open(object_of(key_count));
}

void JsonArchive::end_object() {
  close();
}

void JsonArchive::begin_map() {
  open(Json::object());
}

void JsonArchive::end_map() {
  close();
}

void JsonArchive::begin_list() {
  open(Json::array());
}

void JsonArchive::end_list() {
  close();
}

void JsonArchive::quantity(const std::optional<double>& si, QuantityKind kind) {
  put(si ? kinestat::number(in_.of(kind, *si)) : Json(nullptr));
}

void JsonArchive::number(const std::optional<double>& value, std::string_view /*unit*/) {
  put(kinestat::number(value));
}

void JsonArchive::whole(std::int64_t value) {
  put(value);
}

void JsonArchive::text(std::string_view value) {
  put(value);
}

void JsonArchive::flag(bool value) {
  put(value);
}

void JsonArchive::null() {
  put(nullptr);
}

void JsonArchive::open(Json value) {
  open_.push_back({.key = std::exchange(key_, {}), .value = std::move(value)});
}

void JsonArchive::close() {
  Open closed = std::move(open_.back());
  open_.pop_back();
  key_ = std::move(closed.key);
  put(std::move(closed.value));
}

void JsonArchive::put(Json value) {
  if (open_.empty()) {
    result_ = std::move(value);
  } else if (Json& into = open_.back().value; into.is_array()) {
    into.push_back(std::move(value));
  } else {
    appended(into, key_) = std::move(value);
  }
}

}  // namespace kinestat
