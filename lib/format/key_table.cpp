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
#include "couplings/mechanics.hpp"
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

// Axes of turning and normals along z, what slides along x; of two axes the first along x. In the
// plane normals are along y.
CouplingGeometry usual_geometry(const CouplingKind& kind, Space space) {
  const Axis z = {.direction = Vec3::UnitZ(), .keyword = 'z'};
  const Axis y = {.direction = Vec3::UnitY(), .keyword = 'y'};
  const Axis x = {.direction = Vec3::UnitX(), .keyword = 'x'};
  const bool has_normal = takes(kind, CouplingKey::normal);
  CouplingGeometry geometry;
  geometry.axis = takes(kind, CouplingKey::turning_axis) ? z
                  : !has_normal                          ? x
                  : space == Space::planar               ? y
                                                         : z;
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

std::string line_of_kind(std::string_view head, const CouplingKind& kind, Space space) {
  const CouplingScrews screws = coupling_screws(kind.type, space, usual_geometry(kind, space));
  const bool is_listed = takes(kind, CouplingKey::freedoms);
  return kind_line(head,
                   is_listed ? "as listed" : names_of(screws.freedoms),
                   is_listed      ? "as listed"
                   : kind.engages ? "of its own name"
                                  : names_of(screws.constraints));
}

void add_kind(const CouplingKind& kind, KeyTable& table) {
  const Space space = kind.is_in_space ? Space::spatial : Space::planar;
  table.add_line(line_of_kind(kind.word, kind, space));
  table.add_lines(kind.meaning, 18);
}

// Along what the forces and the couples of a kind point as the mechanism moves.
struct ActionDirections {
  std::string_view along;
  std::vector<std::string_view> forces = {};
  std::vector<std::string_view> couples = {};
  std::vector<std::string_view> both = {};

  void add(const CouplingKind& kind, bool has_force, bool has_couple) {
    if (has_force || has_couple) {
      (has_force && has_couple ? both : has_force ? forces : couples).push_back(kind.word);
    }
  }

  std::string text() const {
    std::string text;
    const auto add_list = [&](std::string_view head, const std::vector<std::string_view>& kinds) {
      if (!kinds.empty()) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "; ", head, fmt::join(kinds, ", "));
      }
    };
    add_list("forces of", forces);
    add_list("couples of", couples);
    add_list("all of", both);
    return text;
  }
};

constexpr std::string_view kAcrossBothAxes = "across both axes";
constexpr std::string_view kAlongCable = "along the cable";

std::string_view along_text(Follows body) {
  switch (body) {
    case Follows::world:
      return "along the world axes";
    case Follows::tail:
      return "as the first body turns";
    case Follows::head:
      return "as the second body turns";
    case Follows::carrier:
      return "as the carrier turns";
    case Follows::contact:
      break;
  }
  return "along the normal";
}

std::string_view along_text(const CarriedParts& carried, bool is_couple) {
  return carried.are_found_anew ? kAlongCable
         : is_couple && carried.couple_is_across_turns
             ? kAcrossBothAxes
             : along_text((is_couple ? carried.couples : carried.forces).direction);
}

const FormShape& shape_of_section(std::string_view section) {
  const FormShape& file = file_sections().shape();
  const auto at = std::ranges::find(file.keys, section, &FormKey::key);
  KINESTAT_EXPECTS(at != file.keys.end());
  return at->shape;
}

// Where a key stands: "gears, members", and of couplings in which types.
struct KeyPlace {
  std::string path;
  std::vector<std::string> types;
};

// Pages of couplings tell the types themselves.
std::vector<FormKey> keys_beside_type(const FormShape& shape) {
  std::vector<FormKey> keys = keys_of(shape);
  std::erase_if(keys, [](const FormKey& one) { return one.key == "type"; });
  return keys;
}

// A key with one meaning.
struct KeyPlaces {
  FormKey key;
  std::vector<std::string> sections;
  std::vector<KeyPlace> places;
};

std::string place_text(const KeyPlace& place) {
  const bool has_all = place.types.empty() || place.types.size() == coupling_kinds().size();
  return has_all ? place.path
                 : fmt::format("{} of type {}", place.path, fmt::join(place.types, ", "));
}

class KeySearch {
 public:
  explicit KeySearch(std::string_view key) : key_(key) {}

  std::vector<KeyPlaces> run() {
    for (const FormKey& section : file_sections().shape().keys) {
      section_ = section.key;
      if (section.key == key_) {
        note(section, "sections of a file", "");
      }
      look_into(section.shape, std::string(section.key), "");
    }
    return std::move(found_);
  }

 private:
  void look_into(const FormShape& shape, const std::string& path, std::string_view type) {
    for (const FormKey& key : shape.keys) {
      if (key.key == key_) {
        note(key, path, type);
      }
      look_into(key.shape, fmt::format("{}, {}", path, key.key), type);
    }
    for (std::size_t i = 0; i < shape.items.size(); ++i) {
      const bool is_type = shape.kind == FormKind::by_word;
      look_into(shape.items[i], path, is_type ? shape.words[i].text : type);
    }
  }

  void note(const FormKey& key, const std::string& path, std::string_view type) {
    const auto is_same = [&](const KeyPlaces& one) {
      return one.key.meaning == key.meaning && form_text(one.key.shape) == form_text(key.shape);
    };
    KeyPlaces& same = found_or_new(found_, is_same);
    same.key = key;
    add_new(same.sections, std::string(section_));
    KeyPlace& place =
        found_or_new(same.places, [&](const KeyPlace& one) { return one.path == path; });
    place.path = path;
    if (!type.empty()) {
      add_new(place.types, std::string(type));
    }
  }

  template <class Item, class Is>
  static Item& found_or_new(std::vector<Item>& items, const Is& is) {
    const auto at = std::ranges::find_if(items, is);
    return at == items.end() ? items.emplace_back() : *at;
  }

  static void add_new(std::vector<std::string>& names, std::string name) {
    if (std::ranges::find(names, name) == names.end()) {
      names.push_back(std::move(name));
    }
  }

  std::string_view key_;
  std::string_view section_;
  std::vector<KeyPlaces> found_;
};

void collect_names(const FormShape& shape, std::vector<std::string>& names) {
  for (const FormKey& key : shape.keys) {
    if (std::ranges::find(names, key.key) == names.end()) {
      names.emplace_back(key.key);
    }
    collect_names(key.shape, names);
  }
  for (const FormShape& item : shape.items) {
    collect_names(item, names);
  }
}

}  // namespace

std::string key_table(std::string_view section) {
  KeyTable table;
  const FormShape& shape = shape_of_section(section);
  table.add(section == "couplings" ? keys_beside_type(shape) : keys_of(shape), 2);
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

std::string action_directions() {
  std::vector<ActionDirections> all = {{.along = along_text(Follows::world)},
                                       {.along = along_text(Follows::tail)},
                                       {.along = along_text(Follows::head)},
                                       {.along = along_text(Follows::carrier)},
                                       {.along = along_text(Follows::contact)},
                                       {.along = kAlongCable},
                                       {.along = kAcrossBothAxes}};
  for (const CouplingKind* kind : coupling_kinds()) {
    const auto bears = [&](bool is_couple) {
      const Space space = kind->is_in_space ? Space::spatial : Space::planar;
      const CouplingScrews screws =
          coupling_screws(kind->type, space, usual_geometry(*kind, space));
      return takes(*kind, CouplingKey::constraints) || (kind->engages && is_couple) ||
             std::ranges::find(screws.constraints, is_couple, &NamedWrench::is_couple) !=
                 screws.constraints.end();
    };
    const CarriedParts& carried = kind->mechanics->carried;
    const std::string_view of_forces = along_text(carried, false);
    const std::string_view of_couples = along_text(carried, true);
    for (ActionDirections& one : all) {
      one.add(
          *kind, one.along == of_forces && bears(false), one.along == of_couples && bears(true));
    }
  }
  std::string text;
  for (const ActionDirections& one : all) {
    text += page_lines(fmt::format("  {:<25}", one.along), one.text(), 27);
  }
  return text;
}

std::string sliding_kinds() {
  std::vector<std::string_view> words;
  for (const CouplingKind* kind : coupling_kinds()) {
    if (kind->friction == FrictionKind::sliding) {
      words.push_back(kind->word);
    }
  }
  return page_lines("", fmt::format("{}", fmt::join(words, ", ")), 0);
}

std::string coupling_page(const CouplingKind& kind, std::string_view example) {
  KeyTable table;
  table.add_lines(fmt::format("{}: {}", kind.word, kind.meaning), 0);
  table.add_line("");
  if (!kind.others.empty()) {
    table.add_lines(fmt::format("Elsewhere also {}.", fmt::join(kind.others, ", ")), 0);
    table.add_line("");
  }
  table.add_line(kind_line("", "freedoms", "actions"));
  if (kind.is_in_space) {
    table.add_line(line_of_kind("in space", kind, Space::spatial));
  }
  if (kind.is_in_plane) {
    table.add_line(line_of_kind("in the plane", kind, Space::planar));
  }
  table.add_line("");
  for (std::string_view rest = example; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    table.add_line(fmt::format("    {}", line));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
  table.add_line("");
  const FormShape& of_types = shape_of_section("couplings").items.front();
  table.add(keys_beside_type(of_types.items[static_cast<std::size_t>(kind.type)]), 2);
  table.add_line("\nNames and geometry of all types: help couplings. Signs: help signs.");
  return table.text();
}

std::vector<std::string> format_keys() {
  std::vector<std::string> names;
  collect_names(file_sections().shape(), names);
  return names;
}

std::string key_page(std::string_view key, const PageOf& page_of) {
  const std::vector<KeyPlaces> found = KeySearch(key).run();
  if (found.empty()) {
    return {};
  }
  KeyTable table;
  table.add_line(fmt::format("{}: a key of mechanism files", key));
  for (const KeyPlaces& one : found) {
    std::vector<std::string> places(one.places.size());
    std::ranges::transform(one.places, places.begin(), place_text);
    table.add_line("");
    table.add_lines(fmt::format("In {}:", fmt::join(places, "; in ")), 0);
    table.add({one.key}, 2);
  }
  std::vector<std::string> pages;
  for (const KeyPlaces& one : found) {
    for (const std::string& section : one.sections) {
      const std::string page = page_of(section);
      if (!page.empty() && std::ranges::find(pages, page) == pages.end()) {
        pages.push_back(page);
      }
    }
  }
  if (!pages.empty()) {
    table.add_line("");
    table.add_lines(fmt::format("See also: help {}.", fmt::join(pages, ", help ")), 0);
  }
  return table.text();
}

std::string section_table(const PageOf& page_of) {
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
