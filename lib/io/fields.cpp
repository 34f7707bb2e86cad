#include "io/fields.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "io/cut_value.hpp"
#include "io/synonyms.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostKeys = 40;  // that a mapping of the format has

}  // namespace

Fields::Fields(const YamlNode& node,
               SourceRange where,
               const Title& what,
               Diagnostics& found,
               std::string_view only)
    : where_(where), what_(what), found_(found) {
  if (node.kind == YamlKind::mapping) {
    node_ = &node;
  } else {
    found_.error("E0304",
                 node.where,
                 fmt::format("{} must be a mapping of keys to values", what_),
                 only.empty() || node.kind != YamlKind::scalar
                     ? "write {key: value, …} or indented lines 'key: value'"
                     : fmt::format("write {{{}: {}}}", only, node.text));
  }
}

const YamlNode* Fields::find(std::string_view key) {
  known_.push_back(key);
  return node_ == nullptr ? nullptr : node_->find(key);
}

const YamlNode* Fields::require(std::string_view key, std::string what_to_add) {
  const YamlNode* value = find(key);
  if (value == nullptr) {
    lacks(key, std::move(what_to_add));
  }
  return value;
}

void Fields::lacks(std::string_view key, std::string what_to_add) {
  if (node_ != nullptr) {
    missing_.push_back({.key = std::string(key), .what_to_add = std::move(what_to_add)});
  }
}

void Fields::ignore_prefix(std::string_view prefix) {
  ignored_prefix_ = prefix;
}

void Fields::finish() {
  if (node_ == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < node_->entries.size(); ++i) {
    const std::string& key = node_->entries[i].key;
    const bool is_ignored = !ignored_prefix_.empty() && key.starts_with(ignored_prefix_);
    if (!is_ignored && std::ranges::find(known_, key) == known_.end()) {
      refuse(i);
    }
  }
  for (const Missing& one : missing_) {
    found_.error("E0303",
                 where_,
                 fmt::format("{} lacks the key '{}'", what_, one.key),
                 fmt::format("add {}", one.what_to_add));
  }
}

// A key that has its value in it: "type:revolute", "coupling a", "coupling = a".
bool Fields::refuse_joined(const YamlEntry& entry, const std::vector<std::string>& known) {
  const std::size_t end = entry.key.find_first_of(" :=");
  const std::string key = entry.key.substr(0, end);
  const bool is_joined = end != std::string::npos && entry.value.kind == YamlKind::null &&
                         std::ranges::find(known, key) != known.end();
  const std::size_t begin = is_joined ? entry.key.find_first_not_of(" :=", end) : std::string::npos;
  if (begin == std::string::npos) {
    return false;
  }
  std::erase_if(missing_, [&](const Missing& one) { return one.key == key; });
  found_.error("E0302",
               entry.key_where,
               fmt::format("{} has no key '{}'", what_, entry.key),
               fmt::format("write '{}: {}', a colon and a space between key and value",
                           key,
                           entry.key.substr(begin)));
  return true;
}

void Fields::refuse(std::size_t index) {
  const YamlEntry& entry = node_->entries[index];
  const std::string whole =
      index == 0 ? std::string() : whole_entry(node_->entries[index - 1], entry);
  const std::string listed = listed_entry(node_->entries, index);
  std::vector<std::string> missing;
  for (const Missing& one : missing_) {
    missing.push_back(one.key);
  }
  std::vector<std::string> known;
  for (const std::string_view key : known_) {
    if (std::ranges::find(known, key) == known.end()) {
      known.emplace_back(key);
    }
  }
  if (refuse_joined(entry, known)) {
    return;
  }
  std::string guess = meant_name(entry.key, missing);
  std::erase_if(missing_, [&](const Missing& one) { return one.key == guess; });
  if (guess.empty()) {
    guess = meant_name(entry.key, known);
  }
  // An actuator says where something acts, a case how much.
  const std::string others =
      fmt::format("{}known keys are {}",
                  known == std::vector<std::string>{"coupling", "freedom"}
                      ? "values belong to a case: action: {NAME: 5 N*m}, motion: {NAME: 60 rpm}; "
                      : "",
                  plain_list(known, kMostKeys));
  const std::string foreign = foreign_character(entry.key);
  found_.error("E0302",
               entry.key_where,
               fmt::format("{} has no key '{}'{}{}",
                           what_,
                           entry.key,
                           foreign.empty() ? "" : ": it holds ",
                           foreign),
               !whole.empty()    ? fmt::format("put the value in quotes: {}", whole)
               : !listed.empty() ? fmt::format("write components in brackets: {}", listed)
               : guess.empty()   ? others
                                 : fmt::format("did you mean '{}'? {}", guess, others));
}

}  // namespace kinestat
