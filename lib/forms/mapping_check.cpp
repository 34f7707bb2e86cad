#include "forms/mapping_check.hpp"

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
           has(mapping, rule.others.front()) &&
           std::none_of(rule.others.begin() + 1, rule.others.end(), [&](std::string_view other) {
             return has(mapping, other);
           });
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

// The key that the mapping cannot do without, if it is the only one and has a name as its value.
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

}  // namespace

std::uint64_t beginning_of(std::string_view key) {
  constexpr unsigned kBits = 63;
  return std::uint64_t{1} << (key.empty() ? 0U : static_cast<unsigned char>(key.front()) % kBits);
}

Title title_of(const FileValue& mapping) {
  return mapping.what.empty() ? Title("the mechanism") : mapping.what;
}

MappingKeys::MappingKeys(const FormShape& shape,
                         const FileValue& mapping,
                         const SharedList<std::string_view>& known)
    : shape_(shape),
      mapping_(mapping),
      known_(known),
      fields_(mapping.node, mapping.where, title_of(mapping), mapping.found, only_name_of(shape)) {
  for (const YamlEntry& entry : mapping.node.entries) {
    beginnings_ |= beginning_of(entry.key);
  }
}

std::optional<FileValue> MappingKeys::find(std::size_t index) {
  const FormKey& key = shape_.keys[index];
  const YamlNode* node = mapping_.node.find(key.key);
  if (node == nullptr) {
    complain_of_missing(key);
    return std::nullopt;
  }
  ++found_;
  if (!mapping_.space && depends_on_space(key.shape)) {
    return std::nullopt;
  }
  const bool is_section = mapping_.what.empty();
  return FileValue{
      .node = *node,
      .what = is_section ? Title("'{0}'", key.key) : Title("'{0}' of {1}", key.key, &mapping_.what),
      .key = &key,
      .owner = &mapping_.what,
      .where = node->where,
      .place = is_section ? place_of_key(mapping_.node, key.key) : node->where,
      .space = mapping_.space,
      .found = mapping_.found};
}

// Most keys that are missing may be: only of the others it is worked out what to add.
void MappingKeys::complain_of_missing(const FormKey& key) {
  const bool is_needed = (key.is_needed && !is_replaced(shape_, key.key, mapping_)) ||
                         is_called_for(shape_, key.key, mapping_);
  if (!is_needed) {
    return;
  }
  if (!key.absence.code.empty()) {
    mapping_.found.error(key.absence.code,
                         mapping_.where,
                         std::string(key.absence.message),
                         std::string(key.missing));
    return;
  }
  fields_.lacks(key.key,
                key.missing.empty() ? what_to_add(key, mapping_.space) : std::string(key.missing));
}

void MappingKeys::finish() {
  if (found_ == mapping_.node.entries.size() && !fields_.lacks_any()) {
    return;
  }
  for (const std::string_view key : known_) {
    (void)fields_.find(key);
  }
  for (const FormKey& key : shape_.keys) {
    (void)fields_.find(key.key);
  }
  for (const FormKey& own : shape_.beginnings) {
    fields_.ignore_prefix(own.key);
  }
  fields_.finish();
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
