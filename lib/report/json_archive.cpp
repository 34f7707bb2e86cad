#include "report/json_archive.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "report/json_values.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// Whether a text stands in JSON as it is.
bool is_plain(std::string_view text) {
  return std::ranges::all_of(text,
                             [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

}  // namespace

std::string JsonArchive::take() {
  out_ += '\n';
  return std::move(out_);
}

bool JsonArchive::begin(const Property& property) {
  key_ = property.key;
  return property.is_in_reports;
}

void JsonArchive::end(const Property& /*property*/) {}

void JsonArchive::element(std::string_view name, std::string_view /*status*/) {
  key_ = name;
}

void JsonArchive::begin_object() {
  open(false);
}

void JsonArchive::end_object() {
  close();
}

void JsonArchive::begin_map() {
  open(false);
}

void JsonArchive::end_map() {
  close();
}

void JsonArchive::begin_list() {
  open(true);
}

void JsonArchive::end_list() {
  close();
}

void JsonArchive::quantity(const std::optional<double>& si, QuantityKind kind) {
  number(si ? std::optional(in_.of(kind, *si)) : std::nullopt, {});
}

void JsonArchive::number(const std::optional<double>& value, std::string_view /*unit*/) {
  start();
  out_ += value && std::isfinite(*value) ? format_exact(*value) : "null";
}

void JsonArchive::whole(std::int64_t value) {
  start();
  fmt::format_to(std::back_inserter(out_), "{}", value);
}

void JsonArchive::text(std::string_view value) {
  start();
  append(value);
}

void JsonArchive::flag(bool value) {
  start();
  out_ += value ? "true" : "false";
}

void JsonArchive::null() {
  start();
  out_ += "null";
}

void JsonArchive::open(bool is_list) {
  start();
  out_ += is_list ? '[' : '{';
  open_.push_back({.is_list = is_list});
}

void JsonArchive::close() {
  const Open closed = open_.back();
  open_.pop_back();
  if (!closed.is_empty) {
    break_line();
  }
  out_ += closed.is_list ? ']' : '}';
}

void JsonArchive::start() {
  if (open_.empty()) {
    return;
  }
  out_ += std::exchange(open_.back().is_empty, false) ? "" : ",";
  break_line();
  if (!open_.back().is_list) {
    append(key_);
    out_ += layout_ == JsonLayout::indented ? ": " : ":";
  }
}

void JsonArchive::break_line() {
  if (layout_ == JsonLayout::indented) {
    out_ += '\n';
    out_.append(2 * open_.size(), ' ');
  }
}

void JsonArchive::append(std::string_view text) {
  if (is_plain(text)) {
    out_ += '"';
    out_ += text;
    out_ += '"';
  } else {
    out_ += Json(text).dump(-1, ' ', layout_ == JsonLayout::ascii_line);
  }
}

}  // namespace kinestat
