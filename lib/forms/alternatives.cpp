#include "forms/alternatives.hpp"

#include <algorithm>

#include <fmt/format.h>

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

AnyRead any_called(const AnyRead& read, std::string title) {
  return [read, title = std::move(title)](const FileValue& value, void* object) {
    FileValue renamed = value;
    const std::string_view key = value.key != nullptr ? value.key->key : "";
    renamed.what = Title(title, value.owner, key);
    return read(renamed, object);
  };
}

AnyRead any_only_if(const AnyRead& read,
                    std::function<bool(const YamlNode&)> fits,
                    std::string message,
                    std::string hint) {
  return [read, fits = std::move(fits), message = std::move(message), hint = std::move(hint)](
             const FileValue& value, void* object) {
    if (fits(value.node)) {
      return read(value, object);
    }
    value.found.error(
        "E0304", value.node.where, fmt::format(fmt::runtime(message), value.what), hint);
    return false;
  };
}

AnyForm any_by_shape(std::vector<AnyForm> forms, AnyChoice choose) {
  FormShape shape{.kind = FormKind::by_shape};
  for (const AnyForm& form : forms) {
    shape.items.push_back(form.shape);
  }
  const auto shared = std::make_shared<const std::vector<AnyForm>>(std::move(forms));
  return {.shape = shape,
          .read =
              [shared, shapes = shape.items](const FileValue& value, void* object) {
                return (*shared)[form_for(value.node, shapes)].read(value, object);
              },
          .write = [shared, choose = std::move(choose)](
                       const void* object) { return (*shared)[choose(object)].write(object); }};
}

}  // namespace kinestat
