#include "format/internal/worded_schema.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace kinestat {

namespace {

// How many of the schemas have the key, and how many say this of it.
struct Sharing {
  std::size_t having = 0;
  std::size_t saying = 0;
};

Sharing sharing_of(const std::vector<Json>& mappings, const std::string& key, const Json& value) {
  Sharing result;
  for (const Json& one : mappings) {
    const bool has_key = one.contains("properties") && one["properties"].contains(key);
    result.having += has_key ? 1 : 0;
    result.saying += has_key && one["properties"][key] == value ? 1 : 0;
  }
  return result;
}

// The key, with the first word for which it means something else than it did before.
std::string shared_name(const Json& shared,
                        const std::string& key,
                        const Json& value,
                        std::string_view word) {
  for (const auto& [name, one] : shared.items()) {
    if (one == value && (name == key || name.starts_with(key + "_"))) {
      return name;
    }
  }
  return shared.contains(key) ? fmt::format("{}_{}", key, word) : key;
}

bool is_reference(const Json& schema) {
  return schema.size() == 1 && schema.contains("$ref");
}

}  // namespace

Json has_word(std::string_view key, std::string_view word) {
  return {{"properties", {{std::string(key), {{"const", std::string(word)}}}}},
          {"required", Json::array({std::string(key)})}};
}

Json needed_by_all(const std::vector<Json>& mappings) {
  Json needed = Json::array();
  for (const Json& key : mappings.front()["required"]) {
    const bool is_in_all = std::ranges::all_of(mappings, [&key](const Json& one) {
      return std::ranges::find(one["required"], key) != one["required"].end();
    });
    if (is_in_all) {
      needed.push_back(key);
    }
  }
  return needed;
}

Json share_keys(const FormShape& shape,
                std::vector<Json>& mappings,
                const std::string& definition) {
  const std::vector<Json> whole = mappings;
  Json shared = Json::object();
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    for (auto& [key, value] : mappings[i]["properties"].items()) {
      if (!value.is_object() || is_reference(value) || sharing_of(whole, key, value).saying < 2) {
        continue;
      }
      const std::string name = shared_name(shared, key, value, shape.words[i].text);
      shared[name] = value;
      value = {{"$ref", fmt::format("#/definitions/{}/properties/{}", definition, name)}};
    }
  }
  return {{"$comment", "Keys of several types; the type says which it has."},
          {"properties", shared}};
}

void settle(Json& mapping, const Json& needed) {
  Json& own = mapping["required"];
  for (const Json& key : needed) {
    mapping["properties"][key.get<std::string>()] = true;
    own.erase(std::ranges::find(own, key));
  }
  if (own.empty()) {
    mapping.erase("required");
  }
}

Json worded_counts(const FormShape& shape, const std::vector<Json>& components) {
  std::map<std::string, int> takers;
  for (const FormShape& one : shape.items) {
    for (const FormKey& key : one.keys) {
      ++takers[std::string(key.key)];
    }
  }
  const std::string chooser(shape.items.front()->keys.front().key);
  Json schema = Json::object();
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i].is_null()) {
      continue;
    }
    Json own = Json::object();
    for (const auto& [key, value] : components[i]["properties"].items()) {
      const bool is_of_all =
          static_cast<int>(sharing_of(components, key, value).saying) == takers[key];
      (is_of_all ? schema["properties"] : own)[key] = value;
    }
    if (!own.empty()) {
      schema["allOf"].push_back(
          {{"if", has_word(chooser, shape.words[i].text)}, {"then", {{"properties", own}}}});
    }
  }
  return schema;
}

}  // namespace kinestat
