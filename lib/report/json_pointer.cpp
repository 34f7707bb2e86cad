#include "report/json_pointer.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"

namespace kinestat {

namespace {

// Of one token: ~1 is '/', ~0 is '~'.
std::string unescaped(std::string_view token) {
  std::string text;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] == '~' && i + 1 < token.size()) {
      text += token[++i] == '1' ? '/' : '~';
    } else {
      text += token[i];
    }
  }
  return text;
}

PointerTarget missing(const Json& at, const std::string& token, const std::string& path) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : at.items()) {
    keys.push_back(key);
  }
  return {.value = nullptr,
          .problem = fmt::format("'{}' has no '{}'", path.empty() ? "/" : path, token),
          .hint = keys.empty() ? std::string()
                               : guess_before(token, keys, "there are " + plain_list(keys))};
}

}  // namespace

std::string take_token(std::string_view& pointer) {
  pointer.remove_prefix(1);
  const std::size_t length = std::min(pointer.find('/'), pointer.size());
  const std::string token = unescaped(pointer.substr(0, length));
  pointer.remove_prefix(length);
  return token;
}

PointerTarget follow_pointer(const Json& report, std::string_view pointer) {
  const Json* at = &report;
  std::string path;
  while (!pointer.empty()) {
    if (pointer.front() != '/') {
      return {.value = nullptr, .problem = "a pointer begins with '/'", .hint = {}};
    }
    const std::string token = take_token(pointer);
    const bool is_index = at->is_array() && !token.empty() && token.size() < 9 &&
                          token.find_first_not_of("0123456789") == std::string::npos;
    if (is_index && std::stoul(token) < at->size()) {
      at = &(*at)[std::stoul(token)];
    } else if (at->is_object() && at->contains(token)) {
      at = &(*at)[token];
    } else {
      return missing(*at, token, path);
    }
    path += "/" + token;
  }
  return {.value = at, .problem = {}, .hint = {}};
}

std::string_view kind_of_json(const Json& value) {
  return value.is_null()     ? "empty"
         : value.is_string() ? "a text"
         : value.is_array()  ? "a list"
                             : "a group of values";
}

}  // namespace kinestat
