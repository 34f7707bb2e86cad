#include "fuzz/changed_tree.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "format/schema.hpp"
#include "report/json_values.hpp"

namespace kinestat::fuzz {

namespace {

constexpr std::array<std::string_view, 16> kNumbers = {"0",
                                                       "-1",
                                                       "1e-300",
                                                       "1e300",
                                                       "1e16",
                                                       "1e-16",
                                                       "1e60",
                                                       "-1e9",
                                                       ".nan",
                                                       ".inf",
                                                       "1/0",
                                                       "0/0",
                                                       "sqrt(-1)",
                                                       "2147483648",
                                                       "18446744073709551616",
                                                       "0.1+0.2-0.3"};
constexpr std::array<std::string_view, 12> kUnits = {
    "mm", "m", "deg", "rad", "N", "N*m", "rpm", "s", "kg", "W", "m/s", "%"};
constexpr std::array<std::string_view, 6> kFactors = {
    "-1", "1e-9", "1e9", "(1+1e-12)", "1000", "0.5"};
// Of the sections whose numbers a sweep may vary.
constexpr std::array<std::string_view, 7> kSwept = {
    "parameters", "couplings", "cables", "gears", "loads", "cases", "springs"};

// Where a value is; the pointers of a list of places hold until the tree is changed.
struct Place {
  YamlNode* parent;
  std::size_t index;

  YamlNode& node() const {
    return parent->kind == YamlKind::sequence ? parent->items[index] : parent->entries[index].value;
  }
};

bool is_number(const YamlNode& node) {
  return node.kind == YamlKind::scalar && !node.text.empty() &&
         std::string_view("0123456789.+-").find(node.text[0]) != std::string_view::npos &&
         std::ranges::any_of(node.text, [](unsigned char one) { return std::isdigit(one) != 0; });
}

template <typename Wanted>
void collect(YamlNode& node, const Wanted& is_wanted, std::vector<Place>& places) {
  const std::size_t count =
      node.kind == YamlKind::sequence ? node.items.size() : node.entries.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Place place{&node, i};
    if (is_wanted(place.node())) {
      places.push_back(place);
    }
    collect(place.node(), is_wanted, places);
  }
}

template <typename Wanted>
std::vector<Place> places_of(YamlNode& root, const Wanted& is_wanted) {
  std::vector<Place> places;
  collect(root, is_wanted, places);
  return places;
}

bool is_anything(const YamlNode& node) {
  return node.kind != YamlKind::null || node.text.empty();
}

bool is_word(const YamlNode& node) {
  return node.kind == YamlKind::scalar;
}

bool is_list(const YamlNode& node) {
  return node.kind == YamlKind::sequence && node.items.size() > 1;
}

bool is_mapping(const YamlNode& node) {
  return node.kind == YamlKind::mapping;
}

YamlNode scalar(std::string text) {
  YamlNode node;
  node.kind = YamlKind::scalar;
  node.text = std::move(text);
  return node;
}

// The keys and the values that the schema knows.
struct Words {
  std::vector<std::string> keys;
  std::vector<std::string> values;
};

void collect_words(const Json& schema, std::set<std::string>& keys, std::set<std::string>& values) {
  if (schema.is_object()) {
    if (const auto found = schema.find("properties"); found != schema.end() && found->is_object()) {
      for (const auto& item : found->items()) {
        keys.insert(item.key());
      }
    }
    for (const char* const name : {"enum", "examples"}) {
      if (const auto found = schema.find(name); found != schema.end() && found->is_array()) {
        for (const Json& one : *found) {
          if (!one.is_structured()) {
            values.insert(one.is_string() ? one.get<std::string>() : one.dump());
          }
        }
      }
    }
  }
  if (schema.is_structured()) {
    for (const Json& one : schema) {
      collect_words(one, keys, values);
    }
  }
}

const Words& words() {
  static const Words kWords = [] {
    std::set<std::string> keys;
    std::set<std::string> values;
    collect_words(Json::parse(mechanism_schema()), keys, values);
    return Words{std::vector(keys.begin(), keys.end()), std::vector(values.begin(), values.end())};
  }();
  return kWords;
}

using Change = void (*)(YamlNode& root, Choices& choices);

void put_number(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_number); !places.empty()) {
    choices.of(places).node() = scalar(std::string(choices.of(kNumbers)));
  }
}

// Points that coincide, parameters that cancel.
void put_equal_number(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_number); !places.empty()) {
    YamlNode& node = choices.of(places).node();
    node = YamlNode(choices.of(places).node());
  }
}

void scale_number(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_number); !places.empty()) {
    YamlNode& node = choices.of(places).node();
    node = scalar(fmt::format("{}*({})", choices.of(kFactors), node.text));
  }
}

void level_list(YamlNode& root, Choices& choices) {
  auto places = places_of(root, [](const YamlNode& node) {
    return is_list(node) && std::ranges::any_of(node.items, is_number);
  });
  if (!places.empty()) {
    std::vector<YamlNode>& items = choices.of(places).node().items;
    const std::array<YamlNode, 3> levels = {scalar("0"), scalar("1"), items[0]};
    std::ranges::fill(items, choices.of(levels));
  }
}

void put_unit(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_number); !places.empty()) {
    YamlNode& node = choices.of(places).node();
    const std::string number = node.text.substr(0, node.text.find_first_not_of("0123456789.+-eE"));
    node = scalar(fmt::format("{} {}", number, choices.of(kUnits)));
  }
}

void remove(YamlNode& root, Choices& choices) {
  auto places = places_of(root, is_anything);
  const auto [parent, index] = choices.of(places);
  if (parent->kind == YamlKind::sequence) {
    parent->items.erase(parent->items.begin() + static_cast<std::ptrdiff_t>(index));
  } else if (parent->entries[index].key != "kinestat") {
    parent->entries.erase(parent->entries.begin() + static_cast<std::ptrdiff_t>(index));
  }
}

// An item once more; a coupling, case or body under another name.
void double_item(YamlNode& root, Choices& choices) {
  auto places = places_of(root, is_anything);
  const auto [parent, index] = choices.of(places);
  if (parent->kind == YamlKind::sequence) {
    parent->items.insert(parent->items.begin() + static_cast<std::ptrdiff_t>(index),
                         YamlNode(parent->items[index]));
    return;
  }
  YamlEntry twin = parent->entries[index];
  twin.key += "_2";
  if (parent->find(twin.key) == nullptr) {
    parent->entries.push_back(std::move(twin));
  }
}

void reverse(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_list); !places.empty()) {
    std::ranges::reverse(choices.of(places).node().items);
  }
}

// Two values of one kind: bodies of couplings, points, names. Copies, because one may be in the
// other.
void exchange(YamlNode& root, Choices& choices) {
  auto places = places_of(root, is_anything);
  YamlNode& first = choices.of(places).node();
  auto alike = places_of(root, [&](const YamlNode& node) { return node.kind == first.kind; });
  YamlNode& second = choices.of(alike).node();
  const YamlNode one = first;
  const YamlNode other = second;
  const auto contains = [](YamlNode& outer, const YamlNode* inner) {
    const auto inside = places_of(outer, [](const YamlNode&) { return true; });
    return std::ranges::any_of(inside, [&](const Place& place) { return &place.node() == inner; });
  };
  const bool second_is_inside = contains(first, &second);
  if (!contains(second, &first)) {
    first = other;
  }
  if (!second_is_inside) {
    second = one;
  }
}

void put_word(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_word); !places.empty()) {
    choices.of(places).node() = scalar(choices.of(words().values));
  }
}

// Of a name that stands in the file: references that go elsewhere.
void put_other_word_of_file(YamlNode& root, Choices& choices) {
  if (auto places = places_of(root, is_word); !places.empty()) {
    YamlNode& node = choices.of(places).node();
    node = YamlNode(choices.of(places).node());
  }
}

void put_key(YamlNode& root, Choices& choices) {
  auto places = places_of(root, is_mapping);
  const std::size_t which = choices.below(places.size() + 1);
  YamlNode& mapping = which == places.size() ? root : places[which].node();
  const std::string& key = choices.of(words().keys);
  if (mapping.find(key) == nullptr) {
    mapping.entries.push_back({key, {}, scalar(choices.of(words().values))});
  }
}

// The gentle ones twice: most files are to stay well-formed, so that there are numbers to compare.
constexpr std::array<Change, 18> kChanges = {put_equal_number,
                                             scale_number,
                                             level_list,
                                             reverse,
                                             exchange,
                                             put_other_word_of_file,
                                             put_equal_number,
                                             scale_number,
                                             level_list,
                                             reverse,
                                             exchange,
                                             scale_number,
                                             put_number,
                                             put_unit,
                                             remove,
                                             double_item,
                                             put_word,
                                             put_key};

void write(const YamlNode& node, std::string& text) {
  const auto quoted = [](const std::string& words) {
    return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  switch (node.kind) {
    case YamlKind::null:
      text += "null";
      return;
    case YamlKind::scalar:
      text += is_truth_value(node) ||
                      (!node.text.empty() && !node.quoted &&
                       node.text.find_first_not_of("0123456789.+-") == std::string::npos)
                  ? node.text
                  : quoted(node.text);
      return;
    case YamlKind::sequence:
      text += '[';
      for (const YamlNode& item : node.items) {
        write(item, text += &item == node.items.data() ? "" : ", ");
      }
      text += ']';
      return;
    case YamlKind::mapping:
      text += '{';
      for (const YamlEntry& entry : node.entries) {
        text += (&entry == node.entries.data() ? "" : ", ") + quoted(entry.key) + ": ";
        write(entry.value, text);
      }
      text += '}';
      return;
  }
}

}  // namespace

void change(YamlNode& root, Choices& choices) {
  if (!root.entries.empty()) {
    choices.of(kChanges)(root, choices);
  }
}

std::string written(const YamlNode& root) {
  std::string text;
  for (const YamlEntry& entry : root.entries) {
    text += entry.key + ": ";
    write(entry.value, text);
    text += '\n';
  }
  return text;
}

bool add_sweep(YamlNode& root, Choices& choices) {
  std::vector<Place> places;
  for (YamlEntry& entry : root.entries) {
    if (std::ranges::find(kSwept, entry.key) != kSwept.end()) {
      collect(entry.value, is_number, places);
    }
  }
  const YamlNode* const known = root.find("parameters");
  if (places.empty() || (known != nullptr && known->kind != YamlKind::mapping)) {
    return false;
  }
  YamlNode& node = choices.of(places).node();
  node = scalar(fmt::format("swept*({})", node.text));
  const auto mapping = [](std::string key, YamlNode value) {
    YamlNode made;
    made.kind = YamlKind::mapping;
    made.entries.push_back({std::move(key), {}, std::move(value)});
    return made;
  };
  const auto entry_of = [&](std::string_view key) -> YamlNode& {
    auto at = std::ranges::find(root.entries, key, &YamlEntry::key);
    if (at == root.entries.end()) {
      at = root.entries.insert(at, {std::string(key), {}, {}});
    }
    return at->value;
  };
  YamlNode& parameters = entry_of("parameters");
  parameters.kind = YamlKind::mapping;
  parameters.entries.push_back({"swept", {}, scalar("1")});
  YamlNode values;
  values.kind = YamlKind::sequence;
  values.items.push_back(scalar("1"));
  entry_of("sweep") = mapping("vary", mapping("swept", std::move(values)));
  return true;
}

}  // namespace kinestat::fuzz
