#include "format/mapping_check.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/field_values.hpp"

namespace kinestat {

namespace {

bool has(const FileValue& mapping, std::string_view key) {
  return mapping.node.find(key) != nullptr;
}

// The hint with the two bodies that the mapping names in place of TAIL and HEAD, and the form of a
// point in place of […].
std::string hint_with_names(std::string_view hint, const FileValue& mapping) {
  std::string text(hint);
  const auto replace = [&](std::string_view word, std::string_view by) {
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + by.size())) {
      text.replace(at, word.size(), by);
    }
  };
  const YamlNode* bodies = mapping.node.find("bodies");
  if (bodies != nullptr && bodies->items.size() == 2 && text.find("TAIL") != std::string::npos) {
    replace("TAIL", bodies->items[0].text);
    replace("HEAD", bodies->items[1].text);
    replace("[…]", mapping.space == Space::planar ? "[x, y]" : "[x, y, z]");
  }
  return text;
}

bool is_in_place_of(const FormRule& rule) {
  return rule.kind == FormRule::Kind::instead || rule.kind == FormRule::Kind::spares;
}

bool has_any_of(const FormRule& rule, const FileValue& mapping) {
  return std::ranges::any_of(rule.others, [&](const auto& key) { return has(mapping, key); });
}

// Whether a key that stands instead of this one is there.
bool is_replaced(const FormShape& shape, std::string_view key, const FileValue& mapping) {
  return std::ranges::any_of(shape.rules, [&](const FormRule& rule) {
    const bool spares =
        is_in_place_of(rule) || (rule.kind == FormRule::Kind::alone && !has_any_of(rule, mapping));
    return spares && has(mapping, rule.key) &&
           std::ranges::find(rule.others, key) != rule.others.end();
  });
}

// Whether a key is there that needs this one.
bool is_called_for(const FormShape& shape, std::string_view key, const FileValue& mapping) {
  return std::ranges::any_of(shape.rules, [&](const FormRule& rule) {
    return rule.kind == FormRule::Kind::needed_beside && rule.key == key &&
           has(mapping, rule.others.front());
  });
}

// "'drive: NAME', an actuator", or "for example 'to: 360 deg'".
std::string what_to_add(const FormKey& key, std::optional<Space> space) {
  if (key.shape->kind == FormKind::number && !key.examples.empty()) {
    return fmt::format("for example '{}: {}'", key.key, key.examples.front());
  }
  const std::string remark =
      key.shape->remark.empty() ? "" : fmt::format(", {}", key.shape->remark);
  return fmt::format(
      "'{}: {}'{}", key.key, sketch_of(key.shape, space.value_or(Space::spatial)), remark);
}

// Most keys that are missing may be: only of the others it is worked out what to add.
void complain_of_missing(const FormShape& shape,
                         const FormKey& key,
                         Fields& fields,
                         const FileValue& mapping) {
  const bool is_needed = (key.is_needed && !is_replaced(shape, key.key, mapping)) ||
                         is_called_for(shape, key.key, mapping);
  if (!is_needed) {
    return;
  }
  if (!key.absence.code.empty()) {
    mapping.found.error(key.absence.code,
                        mapping.where,
                        std::string(key.absence.message),
                        std::string(key.missing));
    return;
  }
  (void)fields.require(
      key.key, key.missing.empty() ? what_to_add(key, mapping.space) : std::string(key.missing));
}

// "'trace' of 'motion'"; every key has one, and few are told.
std::string title_of_key(std::string_view key, std::string_view mapping) {
  std::string title;
  title.reserve(key.size() + mapping.size() + 6);
  title.append(1, '\'').append(key).append(1, '\'');
  if (!mapping.empty()) {
    title.append(std::string_view(" of ")).append(mapping);
  }
  return title;
}

void check_instead(const FormRule& rule, const FileValue& mapping) {
  for (const std::string_view key : rule.others) {
    if (has(mapping, rule.key) && has(mapping, key)) {
      mapping.found.error("E0302",
                          place_of_key(mapping.node, key),
                          fmt::format(fmt::runtime(rule.message), mapping.what, key, rule.key),
                          std::string(rule.hint));
    }
  }
}

bool is_true(const FileValue& mapping, std::string_view key) {
  const YamlNode* flag = mapping.node.find(key);
  return flag != nullptr && is_truth_value(*flag) && flag->text == "true";
}

void check_unless_true(const FormRule& rule, const FileValue& mapping) {
  for (const std::string_view key : rule.others) {
    if (is_true(mapping, rule.key) && has(mapping, key)) {
      mapping.found.error("E0302",
                          place_of_key(mapping.node, key),
                          fmt::format(fmt::runtime(rule.message), mapping.what, key),
                          fmt::format(fmt::runtime(rule.hint), mapping.what, key));
    }
  }
}

void check_one_of(const FormRule& rule, const FileValue& mapping, int errors_before) {
  const auto count =
      std::ranges::count_if(rule.others, [&](const auto& key) { return has(mapping, key); });
  if (count != 1 && mapping.found.error_count() == errors_before) {
    mapping.found.error(count == 0 ? "E0303" : "E0302",
                        mapping.place,
                        fmt::format(fmt::runtime(rule.message), mapping.what),
                        std::string(rule.hint));
  }
}

// The code of what is wrong with the key for the sake of others; empty if nothing is.
std::string_view code_for_key(const FormRule& rule, const FileValue& mapping) {
  if (!has(mapping, rule.key)) {
    return {};
  }
  const bool has_any = has_any_of(rule, mapping);
  switch (rule.kind) {
    case FormRule::Kind::together:
      return has_any ? "" : "E0303";
    case FormRule::Kind::pointless:
      return has_any ? "" : "E0302";
    case FormRule::Kind::excludes:
      return has_any ? "E0302" : "";
    case FormRule::Kind::needs_true:
      return is_true(mapping, rule.key) && !is_true(mapping, rule.others.front()) ? "E0303" : "";
    default:
      return {};
  }
}

}  // namespace

std::string_view title_of(const FileValue& mapping) {
  return mapping.what.empty() ? std::string_view("the mechanism") : mapping.what;
}

std::string_view only_name_of(const FormShape& shape) {
  std::string_view only;
  for (const FormKey& key : shape.keys) {
    if (key.is_needed && (!only.empty() || key.shape->kind != FormKind::name)) {
      return {};
    }
    only = key.is_needed ? key.key : only;
  }
  return only;
}

std::optional<FileValue> find_key(const FormShape& shape,
                                  std::size_t index,
                                  Fields& fields,
                                  const FileValue& mapping) {
  const FormKey& key = shape.keys[index];
  const YamlNode* node = fields.find(key.key);
  if (node == nullptr) {
    complain_of_missing(shape, key, fields, mapping);
    return std::nullopt;
  }
  if (!mapping.space && depends_on_space(key.shape)) {
    return std::nullopt;
  }
  const bool is_section = mapping.what.empty();
  return FileValue{.node = *node,
                   .what = title_of_key(key.key, mapping.what),
                   .key = &key,
                   .owner = mapping.what,
                   .where = node->where,
                   .place = is_section ? place_of_key(mapping.node, key.key) : node->where,
                   .space = mapping.space,
                   .found = mapping.found};
}

void check_rules(const FormShape& shape, const FileValue& mapping, int errors_before) {
  const int keys_before = mapping.found.error_count();
  for (const FormRule& rule : shape.rules) {
    if (mapping.found.error_count() > keys_before) {
      return;  // the rest may follow from it
    }
    if (rule.message.empty()) {
      continue;
    }
    const std::string_view code = code_for_key(rule, mapping);
    if (!code.empty()) {
      mapping.found.error(code,
                          place_of_key(mapping.node, rule.key),
                          fmt::format(fmt::runtime(rule.message), mapping.what),
                          hint_with_names(rule.hint, mapping));
    } else if (rule.kind == FormRule::Kind::instead) {
      check_instead(rule, mapping);
    } else if (rule.kind == FormRule::Kind::unless_true) {
      check_unless_true(rule, mapping);
    } else if (rule.kind == FormRule::Kind::one_of) {
      check_one_of(rule, mapping, errors_before);
    } else if (rule.kind == FormRule::Kind::any_of && !has_any_of(rule, mapping)) {
      mapping.found.error("E0303",
                          mapping.where,
                          fmt::format(fmt::runtime(rule.message), mapping.what),
                          std::string(rule.hint));
    }
  }
}

void leave_out_replaced(const FormShape& shape, FileText& written) {
  for (const FormRule& rule : shape.rules) {
    const bool replaces = rule.kind == FormRule::Kind::instead &&
                          std::ranges::any_of(written.entries, [&](const auto& entry) {
                            return entry.first == rule.key;
                          });
    if (replaces) {
      std::erase_if(written.entries, [&](const auto& entry) {
        return std::ranges::find(rule.others, entry.first) != rule.others.end();
      });
    }
  }
}

}  // namespace kinestat
