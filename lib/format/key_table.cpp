#include "format/key_table.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/page_text.hpp"
#include "core/utf8.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "couplings/kinds.hpp"
#include "format/sections/sections.hpp"

namespace kinestat {

namespace {

std::string form_text(const FormShape& shape) {
  if (shape.kind == FormKind::flag) {
    return "true or false";
  }
  if (shape.kind != FormKind::by_shape) {
    return sketch_of(shape, Space::spatial);
  }
  std::string text;
  for (const FormShape& one : shape.items) {
    text += (text.empty() ? "" : " or ") + form_text(one);
  }
  return text;
}

// The keys behind a value, whatever lists, names and alternatives they stand in.
void collect_keys(const FormShape& shape, std::vector<FormKey>& keys) {
  for (const FormKey& key : shape.keys) {
    const bool is_there = std::ranges::any_of(
        keys, [&](const FormKey& one) { return one.key == key.key && one.meaning == key.meaning; });
    if (!is_there) {
      keys.push_back(key);
    }
  }
  for (const FormShape& item : shape.items) {
    collect_keys(item, keys);
  }
}

std::vector<FormKey> keys_of(const FormShape& shape) {
  std::vector<FormKey> keys;
  collect_keys(shape, keys);
  return keys;
}

// Of words and flags the form has them all.
std::string example_of(const FormKey& key) {
  const auto at =
      std::ranges::find_if(key.examples, [&](std::string_view one) { return one != key.usual; });
  const bool is_listed = key.shape->kind == FormKind::word || key.shape->kind == FormKind::flag ||
                         key.shape->kind == FormKind::constant;
  return is_listed || at == key.examples.end() ? "" : fmt::format("; e.g. {}", *at);
}

// "[x, y]; needed; e.g. [6, 5]", as far as there is room.
std::string facts_of(const FormKey& key, const std::string& page, std::size_t room) {
  const std::string need = key.is_needed        ? "; needed"
                           : !key.usual.empty() ? fmt::format("; default {}", key.usual)
                                                : "";
  const std::string rest = need + (page.empty() ? "" : "; help " + page);
  const std::string form = form_text(key.shape);
  for (const std::string& text : {form + rest + example_of(key), form + rest}) {
    if (columns_of(text) <= room) {
      return text;
    }
  }
  const bool is_word = key.shape->kind == FormKind::word;
  return (is_word ? "WORD" : form.starts_with('[') ? "[…]" : "{…}") + rest;
}

class KeyTable {
 public:
  void add(const std::vector<FormKey>& keys, std::size_t indent) {
    std::size_t longest = 0;
    for (const FormKey& key : keys) {
      longest = std::max(longest, columns_of(key.key));
    }
    for (const FormKey& key : keys) {
      told_.insert({std::string(key.key), std::string(key.meaning)});
    }
    for (const FormKey& key : keys) {
      add_entry(key, "", indent, longest);
      add_below(key, indent);
    }
  }

  void add_entry(const FormKey& key,
                 const std::string& page,
                 std::size_t indent,
                 std::size_t longest) {
    const std::size_t begin = indent + longest + 2;
    text_ += fmt::format("{:{}}{}{:{}}{}\n",
                         "",
                         indent,
                         key.key,
                         "",
                         begin - indent - columns_of(key.key),
                         facts_of(key, page, kPageWidth - begin));
    text_ += page_lines("", key.meaning.empty() ? key.shape->meaning : key.meaning, begin);
    for (const Word& word : key.shape->words) {
      text_ += page_lines("", fmt::format("{}: {}", word.text, word.meaning), begin);
    }
  }

  void add_line(const std::string& line) { text_ += line + "\n"; }

  void add_lines(std::string_view words, std::size_t indent) {
    text_ += page_lines("", words, indent);
  }

  const std::string& text() const { return text_; }

 private:
  // But for keys of which another place has told the same.
  void add_below(const FormKey& key, std::size_t indent) {
    std::vector<FormKey> below = keys_of(key.shape);
    std::erase_if(below, [&](const FormKey& one) {
      return told_.contains({std::string(one.key), std::string(one.meaning)});
    });
    add(below, indent + 2);
  }

  std::string text_;
  std::set<std::pair<std::string, std::string>> told_;  // keys with their meaning
};

// Axes of turning and normals along z, what slides along x; of two axes the first along x.
CouplingGeometry usual_geometry(const CouplingKind& kind) {
  const Axis z = {.direction = Vec3::UnitZ(), .keyword = 'z'};
  const Axis x = {.direction = Vec3::UnitX(), .keyword = 'x'};
  const bool turns = takes(kind, CouplingKey::turning_axis) || takes(kind, CouplingKey::normal);
  CouplingGeometry geometry;
  geometry.axis = turns ? z : x;
  geometry.second = takes(kind, CouplingKey::axes) ? z : x;
  return geometry;
}

template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string text;
  for (const Named& one : all) {
    text += (text.empty() ? "" : " ") + one.name;
  }
  return text.empty() ? "none" : text;
}

std::string kind_line(std::string_view type, std::string_view freedoms, std::string_view actions) {
  return fmt::format("  {:<18}{:<21}{}", type, freedoms, actions);
}

void add_kind(const CouplingKind& kind, KeyTable& table) {
  const CouplingScrews screws = coupling_screws(
      kind.type, kind.is_in_space ? Space::spatial : Space::planar, usual_geometry(kind));
  const bool is_listed = takes(kind, CouplingKey::freedoms);
  table.add_line(kind_line(kind.word,
                           is_listed ? "as listed" : names_of(screws.freedoms),
                           is_listed      ? "as listed"
                           : kind.engages ? "of its own name"
                                          : names_of(screws.constraints)));
  table.add_lines(kind.meaning, 18);
}

}  // namespace

std::string key_table(std::string_view section) {
  const FormShape& file = file_sections().shape();
  const auto at = std::ranges::find(file.keys, section, &FormKey::key);
  KINESTAT_EXPECTS(at != file.keys.end());
  KeyTable table;
  table.add(keys_of(at->shape), 2);
  return table.text();
}

std::string coupling_table() {
  KeyTable table;
  table.add_line(kind_line("type", "freedoms", "actions"));
  for (const CouplingKind* kind : coupling_kinds()) {
    add_kind(*kind, table);
  }
  return table.text();
}

std::string section_table(const std::function<std::string(std::string_view section)>& page_of) {
  const FormShape& file = file_sections().shape();
  KeyTable table;
  std::size_t longest = 0;
  for (const FormKey& key : file.keys) {
    longest = std::max(longest, columns_of(key.key));
  }
  for (const FormKey& key : file.keys) {
    table.add_entry(key, page_of(key.key), 2, longest);
  }
  for (const FormKey& own : file.beginnings) {
    table.add_entry(own, "", 2, longest);
  }
  return table.text();
}

}  // namespace kinestat
