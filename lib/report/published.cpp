#include "report/published.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// One token of a JSON Pointer (RFC 6901): ~1 is '/', ~0 is '~'.
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

// Takes the first token off a pointer that begins with '/'.
std::string take_token(std::string_view& pointer) {
  pointer.remove_prefix(1);
  const std::size_t length = std::min(pointer.find('/'), pointer.size());
  const std::string token = unescaped(pointer.substr(0, length));
  pointer.remove_prefix(length);
  return token;
}

// Where a pointer leads, or how far it leads and what there is instead.
struct Target {
  const Json* value = nullptr;
  std::string problem;
  std::string hint;
};

Target missing(const Json& at, const std::string& token, const std::string& path) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : at.items()) {
    keys.push_back(key);
  }
  const std::string guess = did_you_mean(token, keys);
  return {.value = nullptr,
          .problem = fmt::format("'{}' has no '{}'", path.empty() ? "/" : path, token),
          .hint = keys.empty()
                      ? std::string()
                      : fmt::format(
                            "{}{}there are {}", guess, guess.empty() ? "" : " ", plain_list(keys))};
}

Target follow(const Json& report, std::string_view pointer) {
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

void miss(const PublishedValue& published, double value, Diagnostics& found) {
  found.error("E0901",
              published.is_where,
              fmt::format("published value {} is missed: {} is {}, off by {} (tolerance {}{}{})",
                          format_exact(published.is),
                          published.pointer.text,
                          format_exact(value),
                          format_short(value - published.is),
                          format_short(published.tolerance),
                          published.where.empty() ? "" : "; ",
                          published.where),
              "check the model against the source, and the source against its errata");
}

}  // namespace

WantedKeys keys_of(const std::vector<PublishedValue>& published) {
  WantedKeys keys;
  for (const PublishedValue& one : published) {
    std::string_view rest = one.pointer.text;
    WantedKeys* at = &keys;
    while (rest.starts_with('/')) {
      at = &at->with(take_token(rest));
    }
  }
  return keys;
}

void check_published(const Json& report,
                     const std::vector<PublishedValue>& published,
                     Diagnostics& found) {
  for (const PublishedValue& one : published) {
    const Target target = follow(report, one.pointer.text);
    if (target.value == nullptr) {
      found.error("E0902", one.pointer.where, target.problem, target.hint);
    } else if (!target.value->is_number()) {
      found.error(
          "E0902",
          one.pointer.where,
          fmt::format("'{}' is {}, not a number", one.pointer.text, kind_of_json(*target.value)),
          target.value->is_null() ? "the case has no answer there; see its status"
                                  : "let the pointer lead to a single number of the report");
    } else if (const double value = target.value->get<double>();
               !(std::abs(value - one.is) <= one.tolerance)) {
      miss(one, value, found);
    }
  }
}

}  // namespace kinestat
