#include "format/internal/rule_schema.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace kinestat {

namespace {

Json has(std::string_view key) {
  return {{"required", Json::array({std::string(key)})}};
}

Json json_list(const SharedList<std::string_view>& keys) {
  Json list = Json::array();
  for (const std::string_view key : keys) {
    list.push_back(std::string(key));
  }
  return list;
}

Json is_true(std::string_view key) {
  Json condition = has(key);
  condition["properties"] = {{std::string(key), {{"const", true}}}};
  return condition;
}

Json refused(const SharedList<std::string_view>& keys) {
  Json properties = Json::object();
  for (const std::string_view key : keys) {
    properties[std::string(key)] = false;
  }
  return properties;
}

bool is_spared_by(const FormRule& rule) {
  return rule.kind == FormRule::Kind::instead || rule.kind == FormRule::Kind::spares ||
         rule.kind == FormRule::Kind::alone;
}

// The keys each of which makes that one needless.
std::vector<std::string_view> sparing_keys(const FormShape& shape, std::string_view key) {
  std::vector<std::string_view> sparing;
  for (const FormRule& rule : shape.rules) {
    if (is_spared_by(rule) && std::ranges::find(rule.others, key) != rule.others.end()) {
      sparing.push_back(rule.key);
    }
  }
  return sparing;
}

// What the key spares: what several spare is needed where none of them stands.
void add_spared(const FormShape& shape, const FormRule& rule, Json& schema) {
  Json alone = Json::array();
  for (const std::string_view other : rule.others) {
    const std::vector<std::string_view> sparing = sparing_keys(shape, other);
    if (sparing.size() == 1) {
      alone.push_back(std::string(other));
      continue;
    }
    Json any = Json::array({has(other)});
    for (const std::string_view key : sparing) {
      any.push_back(has(key));
    }
    schema["allOf"].push_back({{"anyOf", any}});
  }
  if (!alone.empty()) {
    schema["allOf"].push_back({{"if", {{"not", has(rule.key)}}}, {"then", {{"required", alone}}}});
  }
}

// Either the key, or what is needed of those that it replaces.
void add_instead(const FormShape& shape, const FormRule& rule, Json& schema) {
  Json refused = Json::object();
  Json needed = Json::array();
  for (const FormKey& key : shape.keys) {
    if (std::ranges::find(rule.others, key.key) != rule.others.end()) {
      refused[std::string(key.key)] = false;
      if (key.is_needed && sparing_keys(shape, key.key).size() == 1) {
        needed.push_back(std::string(key.key));
      }
    }
  }
  Json condition = {{"if", has(rule.key)}, {"then", {{"properties", refused}}}};
  if (!needed.empty()) {
    condition["else"] = {{"required", needed}};
  }
  schema["allOf"].push_back(condition);
}

void add_no_two_of(const FormRule& rule, Json& schema) {
  for (std::size_t i = 0; i + 1 < rule.others.size(); ++i) {
    Json refused = Json::object();
    for (std::size_t j = i + 1; j < rule.others.size(); ++j) {
      refused[std::string(rule.others[j])] = false;
    }
    schema["allOf"].push_back({{"if", has(rule.others[i])}, {"then", {{"properties", refused}}}});
  }
}

void add_needed_by_part(const FormRule& rule, Json& schema) {
  Json part = {{"type", "object"}, {"anyOf", Json::array()}};
  for (std::size_t i = 1; i < rule.others.size(); ++i) {
    part["anyOf"].push_back(has(rule.others[i]));
  }
  Json condition = has(rule.others.front());
  condition["properties"] = {{std::string(rule.others.front()), part}};
  schema["allOf"].push_back({{"if", condition}, {"then", has(rule.key)}});
}

void add_needed_unless_whole(const FormRule& rule, Json& schema) {
  const Json broken = {{"type", "number"}, {"not", {{"type", "integer"}}}};
  Json condition = has(rule.others.front());
  condition["properties"] = {{std::string(rule.others.front()), broken}};
  schema["allOf"].push_back({{"if", condition}, {"then", has(rule.key)}});
}

// Needed, unless the key stands without any of them.
Json all_unless_alone(const FormRule& rule) {
  Json alone = has(rule.key);
  for (const std::string_view other : rule.others) {
    alone["not"]["anyOf"].push_back(has(other));
  }
  return {{"if", alone}, {"else", {{"required", json_list(rule.others)}}}};
}

// The value at a path must have the last key: "positions/curvature/m". Lists are passed through.
Json at_path(const FormShape& shape, std::string_view path, const Json& demand) {
  if (shape.kind == FormKind::list) {
    return {{"items", at_path(shape.items.front(), path, demand)}};
  }
  const std::size_t slash = path.find('/');
  const std::string_view first = path.substr(0, slash);
  if (slash == std::string_view::npos) {
    return demand;
  }
  const auto key = std::ranges::find(shape.keys, first, &FormKey::key);
  Json inside = at_path(key->shape, path.substr(slash + 1), demand);
  inside["doNotSuggest"] = true;
  return {{"properties", {{std::string(first), inside}}}};
}

std::string_view last_of(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

// Whether a path with one slash is there.
Json has_path(std::string_view path) {
  const std::string first(path.substr(0, path.find('/')));
  return {{"properties", {{first, has(last_of(path))}}}, {"required", {first}}};
}

// Needed where none of the others is there, and refused where one is.
Json instead_of_any(const FormShape& shape, const FormRule& rule) {
  Json others = Json::array();
  for (const std::string_view other : rule.others) {
    others.push_back(has_path(other));
  }
  Json needed = has(last_of(rule.key));
  needed["errorMessage"] = std::string(rule.hint);
  const Json spare = {{"properties", {{std::string(last_of(rule.key)), false}}},
                      {"errorMessage", std::string(rule.hint)}};
  return {{"if", {{"anyOf", others}}},
          {"then", at_path(shape, rule.key, spare)},
          {"else", at_path(shape, rule.key, needed)}};
}

// All items have the key if one has it.
void add_all_or_none(const FormRule& rule, Json& schema) {
  schema["if"] = {{"contains", has(rule.key)}};
  schema["then"] = {{"items", has(rule.key)}};
  schema["then"]["items"]["errorMessage"] = std::string(rule.hint);
}

Json both_true(const FormRule& rule) {
  return {{"if", is_true(rule.key)},
          {"then",
           {{"properties",
             {{std::string(rule.others.front()), {{"const", true}, {"doNotSuggest", true}}}}}}}};
}

// Where `key` is, the others must be too, beside those of other rules.
void add_dependencies(std::string_view key,
                      const SharedList<std::string_view>& others,
                      Json& schema) {
  Json& needed = schema["dependencies"][std::string(key)];
  for (const std::string_view other : others) {
    needed.push_back(std::string(other));
  }
}

}  // namespace

void add_any_of(const SharedList<std::string_view>& keys, Json& schema) {
  Json alternatives = Json::array();
  for (const std::string_view key : keys) {
    Json alternative = has(key);
    alternative["errorMessage"] = fmt::format("One of these is needed: {}.", fmt::join(keys, ", "));
    alternatives.push_back(alternative);
  }
  // Beside those of another rule: one of each is needed.
  if (schema.contains("anyOf")) {
    schema["allOf"].push_back({{"anyOf", alternatives}});
  } else {
    schema["anyOf"] = alternatives;
  }
}

namespace {

void add_needed_beside(const FormRule& rule, Json& schema) {
  if (rule.others.size() == 1) {
    add_dependencies(rule.others.front(), {rule.key}, schema);
    return;
  }
  SharedList<std::string_view> alternatives = {rule.key};
  for (std::size_t i = 1; i < rule.others.size(); ++i) {
    alternatives.push_back(rule.others[i]);
  }
  add_any_of(alternatives, schema["dependencies"][std::string(rule.others.front())]);
}

}  // namespace

bool is_replaceable(const FormShape& shape, std::string_view key) {
  return !sparing_keys(shape, key).empty();
}

void add_rules(const FormShape& shape, Json& schema) {
  for (const FormRule& rule : shape.rules) {
    switch (rule.kind) {
      case FormRule::Kind::instead:
        add_instead(shape, rule, schema);
        break;
      case FormRule::Kind::any_of:
        add_any_of(rule.others, schema);
        break;
      case FormRule::Kind::needed_beside:
        add_needed_beside(rule, schema);
        break;
      case FormRule::Kind::needed_by_part:
        add_needed_by_part(rule, schema);
        break;
      case FormRule::Kind::one_of:
        add_any_of(rule.others, schema);
        add_no_two_of(rule, schema);
        break;
      case FormRule::Kind::spares:
        add_spared(shape, rule, schema);
        break;
      case FormRule::Kind::unless_true:
        schema["allOf"].push_back(
            {{"if", is_true(rule.key)}, {"then", {{"properties", refused(rule.others)}}}});
        break;
      case FormRule::Kind::needed_unless_whole:
        add_needed_unless_whole(rule, schema);
        break;
      case FormRule::Kind::excludes:
        schema["allOf"].push_back(
            {{"if", has(rule.key)}, {"then", {{"properties", refused(rule.others)}}}});
        break;
      case FormRule::Kind::needs_true:
        schema["allOf"].push_back(both_true(rule));
        break;
      case FormRule::Kind::all_or_none:
        add_all_or_none(rule, schema);
        break;
      case FormRule::Kind::instead_of_any:
        schema["allOf"].push_back(instead_of_any(shape, rule));
        break;
      case FormRule::Kind::alone:
        schema["allOf"].push_back(all_unless_alone(rule));
        break;
      case FormRule::Kind::together:
      case FormRule::Kind::pointless:
        add_dependencies(rule.key, rule.others, schema);
        break;
    }
  }
}

}  // namespace kinestat
