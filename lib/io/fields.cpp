#include "io/fields.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/text.hpp"

namespace kinestat {

namespace {

// What to add where a key is missing.
std::string example_of(std::string_view key) {
  struct Example {
    std::string_view key;
    std::string_view text;
  };

  constexpr auto kExamples = std::to_array<Example>({
      {"ground", "'ground: NAME', the body that stands still"},
      {"bodies", "'bodies: [NAME, NAME, …]'; of a coupling 'bodies: [TAIL, HEAD]'"},
      {"couplings", "'couplings:' and below it lines 'name: {type: …, bodies: […], …}'"},
      {"type", "for example 'type: revolute'"},
      {"coupling", "'coupling: NAME', the coupling that it drives"},
      {"value", "'value: /cases/…', a JSON Pointer into the report"},
      {"tolerance", "for example 'tolerance: 1e-3'"},
  });
  const auto at = std::ranges::find(kExamples, key, &Example::key);
  return at != kExamples.end() ? std::string(at->text) : fmt::format("'{}: …'", key);
}

}  // namespace

Fields::Fields(const YamlNode& node, SourceRange where, std::string what, Diagnostics& found)
    : where_(where), what_(std::move(what)), found_(found) {
  if (node.kind == YamlKind::mapping) {
    node_ = &node;
  } else {
    found_.error("E0304",
                 node.where,
                 fmt::format("{} must be a mapping of keys to values", what_),
                 "write {key: value, …} or indented lines 'key: value'");
  }
}

const YamlNode* Fields::find(std::string_view key) {
  known_.emplace_back(key);
  return node_ == nullptr ? nullptr : node_->find(key);
}

const YamlNode* Fields::require(std::string_view key) {
  const YamlNode* value = find(key);
  if (value == nullptr && node_ != nullptr) {
    missing_.emplace_back(key);
  }
  return value;
}

void Fields::ignore(std::string_view key) {
  ignored_.emplace_back(key);
}

void Fields::finish() {
  if (node_ == nullptr) {
    return;
  }
  for (const YamlEntry& entry : node_->entries) {
    if (std::ranges::find(known_, entry.key) == known_.end() &&
        std::ranges::find(ignored_, entry.key) == ignored_.end()) {
      refuse(entry);
    }
  }
  for (const std::string& key : missing_) {
    found_.error("E0303",
                 where_,
                 fmt::format("{} lacks the key '{}'", what_, key),
                 fmt::format("add {}", example_of(key)));
  }
}

void Fields::refuse(const YamlEntry& entry) {
  std::string guess = nearest_name(entry.key, missing_);
  std::erase(missing_, guess);
  if (guess.empty()) {
    guess = nearest_name(entry.key, known_);
  }
  const std::string others = fmt::format("known keys are {}", plain_list(known_, 24));
  found_.error("E0302",
               entry.key_where,
               fmt::format("{} has no key '{}'", what_, entry.key),
               guess.empty() ? others : fmt::format("did you mean '{}'? {}", guess, others));
}

}  // namespace kinestat
