#include "report/partial_archive.hpp"

#include <algorithm>
#include <utility>

namespace kinestat {

const WantedKeys* WantedKeys::find(std::string_view name) const {
  const auto found = std::ranges::find(below, name, &WantedKeys::key);
  return found == below.end() ? nullptr : &*found;
}

WantedKeys& WantedKeys::with(std::string name) {
  const auto found = std::ranges::find(below, name, &WantedKeys::key);
  return found == below.end() ? below.emplace_back(WantedKeys{.key = std::move(name), .below = {}})
                              : *found;
}

bool PartialArchive::begin(const Property& property) {
  if (within_.back() == nullptr || !JsonArchive::begin(property)) {
    return false;
  }
  const WantedKeys* inner = wanted_below(within_.back(), property.key);
  if (inner == nullptr) {
    null();
    return false;
  }
  within_.push_back(inner);
  return true;
}

void PartialArchive::end(const Property& property) {
  within_.pop_back();
  JsonArchive::end(property);
}

void PartialArchive::element(std::string_view name, std::string_view status) {
  within_.back() = wanted_below(within_[within_.size() - 2], name);
  JsonArchive::element(name, status);
}

void PartialArchive::begin_map() {
  within_.push_back(within_.back());
  JsonArchive::begin_map();
}

void PartialArchive::end_map() {
  within_.pop_back();
  JsonArchive::end_map();
}

void PartialArchive::begin_list() {
  within_.push_back(&all_);
  JsonArchive::begin_list();
}

void PartialArchive::end_list() {
  within_.pop_back();
  JsonArchive::end_list();
}

const WantedKeys* PartialArchive::wanted_below(const WantedKeys* keys,
                                               std::string_view name) const {
  return keys == &all_ || keys == nullptr ? keys : keys->find(name);
}

}  // namespace kinestat
