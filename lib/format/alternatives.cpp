#include "format/alternatives.hpp"

#include <algorithm>

namespace kinestat {

namespace {

YamlKind kind_of(const FormShape& shape) {
  switch (shape.kind) {
    case FormKind::vector:
    case FormKind::list:
      return YamlKind::sequence;
    case FormKind::names:
    case FormKind::mapping:
    case FormKind::variants:
    case FormKind::by_word:
      return YamlKind::mapping;
    default:
      return YamlKind::scalar;
  }
}

}  // namespace

std::size_t form_for(const YamlNode& node, const SharedList<Lazy<FormShape>>& shapes) {
  const auto at = std::ranges::find(shapes, node.kind, kind_of);
  return at != shapes.end() ? static_cast<std::size_t>(at - shapes.begin()) : 0;
}

}  // namespace kinestat
