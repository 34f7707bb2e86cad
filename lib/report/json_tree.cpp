#include "report/json_tree.hpp"

#include <iterator>
#include <span>

namespace kinestat {

namespace {

// Most lists are vectors, of three components or of twice three.
constexpr std::size_t kFewItems = 6;

// At once in its full size: growing, it would copy the values that it holds.
Json object_of(std::span<std::pair<std::string, Json>> members) {
  Json::object_t object;
  object.reserve(members.size());
  for (auto& [key, value] : members) {
    object.emplace_back(std::move(key), std::move(value));
  }
  return object;
}

}  // namespace

Json JsonTree::take() {
  return members_.empty() ? Json() : std::move(members_.back().second);
}

bool JsonTree::begin(const Property& property) {
  key_ = property.key;
  return property.is_in_reports;
}

void JsonTree::end(const Property& /*property*/) {}

void JsonTree::element(std::string_view name, std::string_view /*status*/) {
  key_ = name;
}

void JsonTree::begin_object() {
  open(false);
}

void JsonTree::end_object() {
  close();
}

void JsonTree::begin_map() {
  open(false);
}

void JsonTree::end_map() {
  close();
}

void JsonTree::begin_list() {
  open(true);
}

void JsonTree::end_list() {
  close();
}

void JsonTree::quantity(const std::optional<double>& si, QuantityKind kind) {
  put(si ? kinestat::number(in_.of(kind, *si)) : Json(nullptr));
}

void JsonTree::number(const std::optional<double>& value, std::string_view /*unit*/) {
  put(kinestat::number(value));
}

void JsonTree::whole(std::int64_t value) {
  put(value);
}

void JsonTree::text(std::string_view value) {
  put(value);
}

void JsonTree::flag(bool value) {
  put(value);
}

void JsonTree::null() {
  put(nullptr);
}

void JsonTree::open(bool is_list) {
  Open& opened = open_.emplace_back();
  opened.key = std::exchange(key_, {});
  opened.begin = members_.size();
  opened.is_list = is_list;
  opened.items.reserve(is_list ? kFewItems : 0);
}

void JsonTree::close() {
  Open closed = std::move(open_.back());
  open_.pop_back();
  key_ = std::move(closed.key);
  if (closed.is_list) {
    put(std::move(closed.items));
    return;
  }
  const auto begin = members_.begin() + static_cast<std::ptrdiff_t>(closed.begin);
  Json object = object_of(std::span(begin, members_.end()));
  members_.erase(begin, members_.end());
  put(std::move(object));
}

}  // namespace kinestat
