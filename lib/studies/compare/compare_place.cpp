#include "studies/compare/compare_place.hpp"

#include <algorithm>

namespace kinestat {

namespace {

// Cuts "/key" off the beginning and answers the key.
std::string_view take_key(std::string_view& place) {
  place.remove_prefix(1);
  const std::string_view key = place.substr(0, place.find('/'));
  place.remove_prefix(key.size());
  return key;
}

}  // namespace

std::string place_below(const std::string& place, std::string_view key) {
  std::string result = place;
  append_key(result, key);
  return result;
}

void append_key(std::string& place, std::string_view key) {
  place += '/';
  if (key.find_first_of("~/") == std::string_view::npos) {
    place += key;
    return;
  }
  for (const char c : key) {
    if (c == '~' || c == '/') {
      place += c == '~' ? "~0" : "~1";
    } else {
      place += c;
    }
  }
}

std::vector<std::string_view> keys_of(std::string_view place) {
  std::vector<std::string_view> keys;
  while (!place.empty()) {
    keys.push_back(take_key(place));
  }
  return keys;
}

bool is_within(std::string_view place, std::string_view pattern) {
  while (!pattern.empty()) {
    if (place.empty()) {
      return false;
    }
    const std::string_view wanted = take_key(pattern);
    if (const std::string_view key = take_key(place); wanted != "*" && wanted != key) {
      return false;
    }
  }
  return true;
}

}  // namespace kinestat
