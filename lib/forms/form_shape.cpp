#include "forms/form_shape.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace kinestat {

namespace {

std::string needed_keys(const FormShape& shape, Space space) {
  std::string text;
  for (const FormKey& key : shape.keys) {
    if (key.is_needed) {
      text +=
          fmt::format("{}{}: {}", text.empty() ? "" : ", ", key.key, sketch_of(key.shape, space));
    }
  }
  return text.empty() ? "{…}" : "{" + text + "}";
}

std::string words_of(const FormShape& shape) {
  std::string text;
  for (const Word& word : shape.words) {
    text += fmt::format("{}{}", text.empty() ? "" : " or ", word.text);
  }
  return text;
}

}  // namespace

std::string sketch_of(const FormShape& shape, Space space) {
  if (!shape.sketch.empty()) {
    return std::string(shape.sketch);
  }
  const bool is_planar = space == Space::planar;
  switch (shape.kind) {
    case FormKind::number:
      return "VALUE";
    case FormKind::name:
      return "NAME";
    case FormKind::text:
    case FormKind::literal:
    case FormKind::constant:
      return "TEXT";
    case FormKind::word:
      return words_of(shape);
    case FormKind::flag:
      return "true";
    case FormKind::vector:
      return is_planar ? "[x, y]" : "[x, y, z]";
    case FormKind::couple:
      return is_planar ? "VALUE" : "[x, y, z]";
    case FormKind::list: {
      const std::string item = sketch_of(shape.items.front(), space);
      return shape.most == 1                       ? fmt::format("[{}]", item)
             : shape.least == 2 && shape.most == 2 ? fmt::format("[{0}, {0}]", item)
             : shape.least == 1                    ? fmt::format("[{}]", item)
                                                   : fmt::format("[{0}, {0}, …]", item);
    }
    case FormKind::names:
      return fmt::format("{{NAME: {}}}", sketch_of(shape.items.front(), space));
    case FormKind::mapping:
      return needed_keys(shape, space);
    case FormKind::variants:
    case FormKind::by_word:
    case FormKind::by_shape:
      return sketch_of(shape.items.front(), space);
  }
  return {};
}

bool is_mapping(const FormShape& shape) {
  return shape.kind == FormKind::mapping || shape.kind == FormKind::by_word;
}

bool depends_on_space(const FormShape& shape) {
  return shape.kind == FormKind::vector || shape.kind == FormKind::couple ||
         std::ranges::any_of(shape.items, depends_on_space) ||
         std::ranges::any_of(shape.keys,
                             [](const FormKey& key) { return depends_on_space(key.shape); });
}

}  // namespace kinestat
