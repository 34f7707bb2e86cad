#include "forms/collections.hpp"

#include <utility>

#include "forms/parts.hpp"

namespace kinestat {

namespace {

const Name& name_in(const ElementMembers& members, const void* element) {
  const void* const name = members.name.of(element);
  return members.has_optional_name ? static_cast<const std::optional<Name>*>(name)->value()
                                   : *static_cast<const Name*>(name);
}

void set_name(const ElementMembers& members, void* element, Name given) {
  void* const name = members.name.of(element);
  if (members.has_optional_name) {
    *static_cast<std::optional<Name>*>(name) = std::move(given);
  } else {
    *static_cast<Name*>(name) = std::move(given);
  }
}

}  // namespace

AnyForm any_list_of(const AnyForm& item,
                    const ListOps& list,
                    const std::string& title,
                    const std::string& hint,
                    Count count) {
  const FormShape shape{
      .kind = FormKind::list, .least = count.least, .most = count.most, .items = {item.shape}};
  return {.shape = shape,
          .read =
              [shape, read = item.read, &list, title, hint](const FileValue& value, void* items) {
                if (!check_items(value, shape, hint)) {
                  return false;
                }
                bool is_good = true;
                list.reserve(items, value.node.items.size());
                for (std::size_t i = 0; i < value.node.items.size(); ++i) {
                  is_good = read(item_of(value, i, title), list.add(items)) && is_good;
                }
                return is_good;
              },
          .write =
              [write = item.write, &list](const void* items) {
                std::vector<FileText> texts;
                for (std::size_t i = 0; i < list.size(items); ++i) {
                  texts.push_back(write(list.item_of(items, i)));
                }
                return list_text(std::move(texts));
              }};
}

AnyForm any_one_or_more(const AnyForm& item,
                        const ListOps& list,
                        std::size_t least,
                        const std::string& hint) {
  const AnyForm of_several = any_list_of(item, list, "", hint, {.least = least});
  return {
      .shape = {.kind = FormKind::by_shape, .items = {item.shape, of_several.shape}},
      .read =
          [one = item.read, several = of_several.read, &list](const FileValue& value, void* items) {
            return value.node.kind == YamlKind::sequence ? several(value, items)
                                                         : one(value, list.add(items));
          },
      .write = of_several.write};
}

AnyForm any_by_name(const ElementMembers& members,
                    const AnyForm& value,
                    const ListOps& list,
                    FormShape shape,
                    const std::string& title) {
  shape.kind = FormKind::names;
  shape.items = {value.shape};
  return {.shape = shape,
          .read =
              [=, read = value.read, &list](const FileValue& names, void* elements) {
                if (!check_names(names, shape)) {
                  return false;
                }
                const int errors_before = names.found.error_count();
                list.reserve(elements, count_whole(names.node, shape.items.front()));
                for (const YamlEntry& entry : names.node.entries) {
                  Name given{.text = entry.key, .where = entry.key_where};
                  check_element_name(given, shape, names.found);
                  void* const element = list.add(elements);
                  void* const object = members.value ? members.value->of(element) : element;
                  if (read(element_of(names, entry, title), object)) {
                    set_name(members, element, std::move(given));
                  } else {
                    list.drop_last(elements);  // many bad ones need no room
                  }
                }
                return names.found.error_count() == errors_before;
              },
          .write =
              [=, write = value.write, &list](const void* elements) {
                FileText text{.kind = FileText::Kind::mapping};
                text.in_lines = is_mapping(shape.items.front());
                for (std::size_t i = 0; i < list.size(elements); ++i) {
                  const void* const element = list.item_of(elements, i);
                  text.entries.emplace_back(
                      element_key(name_in(members, element), shape),
                      write(members.value ? members.value->of(element) : element));
                }
                return text;
              }};
}

}  // namespace kinestat
