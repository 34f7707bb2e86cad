#include "forms/any_mapping.hpp"

#include <algorithm>
#include <string>

#include "forms/mapping_check.hpp"

namespace kinestat {

AnyMapping::AnyMapping(std::string_view definition,
                       std::string_view meaning,
                       std::string_view example,
                       std::optional<AnyMember> place,
                       const void* (*usual)())
    : place_(place), usual_(usual) {
  shape_ = {.kind = FormKind::mapping, .definition = definition, .meaning = meaning};
  if (!example.empty()) {
    shape_.examples.push_back(example);
  }
}

bool AnyMapping::any_read(void* object,
                          const FileValue& value,
                          const SharedList<std::string_view>& known) const {
  if (place_) {
    *static_cast<SourceRange*>(place_->of(object)) = value.place;
  }
  return any_read_into(object, value, known);
}

bool AnyMapping::any_read_into(void* object,
                               const FileValue& value,
                               const SharedList<std::string_view>& known) const {
  const int errors_before = value.found.error_count();
  if (shape_.may_be_empty && value.node.kind == YamlKind::null) {
    return true;
  }
  MappingKeys keys(shape_, value, known);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if ((keys.beginnings() & beginnings_[i]) == 0) {
      continue;  // as most keys that a mapping may have
    }
    if (const auto behind = keys.find(i)) {
      steps_[i].read(*behind, object);
    }
  }
  keys.finish();
  if (value.node.kind == YamlKind::mapping) {
    check_rules(shape_, value, errors_before);
  }
  for (const auto& check : checks_) {
    if (value.found.error_count() == errors_before) {
      check(object, value);
    }
  }
  return value.found.error_count() == errors_before;
}

FileText AnyMapping::any_text(const void* object) const {
  FileText text{.kind = FileText::Kind::mapping, .in_lines = is_in_lines_};
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (auto behind = steps_[i].write(object)) {
      text.entries.emplace_back(shape_.keys[i].key, *std::move(behind));
    }
  }
  leave_out_replaced(shape_, text);
  return text;
}

std::optional<FileText> AnyMapping::any_text_if_any(const void* object) const {
  FileText written = any_text(object);
  return written.entries.empty() ? std::nullopt : std::optional(std::move(written));
}

void AnyMapping::instead(std::string_view key,
                         SharedList<std::string_view> others,
                         std::string_view hint) {
  rule({.kind = FormRule::Kind::instead,
        .key = key,
        .others = std::move(others),
        .message = "{} cannot have '{}' together with '{}'",
        .hint = hint});
}

AnyForm AnyMapping::any_form() const {
  return {.shape = shape_,
          .read = [this](const FileValue& value, void* object) { return any_read(object, value); },
          .write =
              [this](const void* object) {
                FileText written = any_text(object);
                return shape_.may_be_empty && written.entries.empty() ? FileText() : written;
              }};
}

void AnyMapping::close() {
  for (const FormKey& key : shape_.keys) {
    const bool may_be_needed =
        key.is_needed || std::ranges::any_of(shape_.rules, [&](const FormRule& rule) {
          return rule.kind == FormRule::Kind::needed_beside && rule.key == key.key;
        });
    beginnings_.push_back(may_be_needed ? kAnyBeginning : beginning_of(key.key));
  }
}

void AnyMapping::add(FormKey key, ReadKey read, WriteKey write) {
  shape_.keys.push_back(std::move(key));
  steps_.push_back({.read = std::move(read), .write = std::move(write)});
}

void AnyMapping::add_member(
    FormKey key, AnyMember member, const MemberOps& ops, const AnyRead& read, AnyWrite write) {
  const bool is_needed = key.is_needed;
  add(
      std::move(key),
      [member, &ops, read](const FileValue& value, void* object) {
        ops.read(read, value, member.of(object));
      },
      [member, &ops, write = std::move(write), is_needed, usual = usual_](
          const void* object) -> std::optional<FileText> {
        const void* const one = ops.present(member.of(object), member.of(usual()), is_needed);
        return one != nullptr ? std::optional(write(one)) : std::nullopt;
      });
}

void AnyMapping::add_group(FormKey key, const AnyMapping& part, std::optional<AnyMember> member) {
  key.shape = part.shape();
  add(
      std::move(key),
      [&part, member](const FileValue& value, void* object) {
        part.any_read_into(member ? member->of(object) : object, value);
      },
      [&part, member](const void* object) {
        return part.any_text_if_any(member ? member->of(object) : object);
      });
}

void AnyMapping::add_one_or_several(const AnyMapping& item,
                                    AnyMember member,
                                    const ListOps& items,
                                    FormKey list_key,
                                    const AnyForm& list) {
  for (std::size_t i = 0; i < item.steps_.size(); ++i) {
    add(
        item.shape_.keys[i],
        [&item, member, &items, i](const FileValue& value, void* object) {
          void* const all = member.of(object);
          void* const only = items.size(all) == 0 ? items.add(all) : items.item(all, 0);
          item.steps_[i].read(value, only);
        },
        [&item, member, &items, i](const void* object) {
          const void* const all = member.of(object);
          return items.size(all) == 1 ? item.steps_[i].write(items.item_of(all, 0)) : std::nullopt;
        });
  }
  list_key.shape = list.shape;
  add(
      std::move(list_key),
      [list, member](const FileValue& value, void* object) { list.read(value, member.of(object)); },
      [list, member, &items](const void* object) {
        const void* const all = member.of(object);
        return items.size(all) > 1 ? std::optional(list.write(all)) : std::nullopt;
      });
}

void AnyMapping::also_place(AnyMember place, bool of_value) {
  ReadKey& step = steps_.back().read;
  step = [place, of_value, read = std::move(step)](const FileValue& value, void* object) {
    *static_cast<SourceRange*>(place.of(object)) = of_value ? value.node.where : value.place;
    read(value, object);
  };
}

void AnyMapping::also_note(AnyMember is_there) {
  also_read([is_there](void* object) { *static_cast<bool*>(is_there.of(object)) = true; });
  WriteKey& step = steps_.back().write;
  step = [is_there, write = std::move(step)](const void* object) {
    auto text = write(object);
    return text || !*static_cast<const bool*>(is_there.of(object))
               ? text
               : std::optional(FileText{.kind = FileText::Kind::mapping});
  };
}

void AnyMapping::also_read(std::function<void(void*)> more) {
  ReadKey& step = steps_.back().read;
  step = [more = std::move(more), read = std::move(step)](const FileValue& value, void* object) {
    more(object);
    read(value, object);
  };
}

void AnyMapping::write_only_if(std::function<bool(const void*)> is_so) {
  WriteKey& step = steps_.back().write;
  step = [is_so = std::move(is_so), write = std::move(step)](const void* object) {
    return is_so(object) ? write(object) : std::nullopt;
  };
}

}  // namespace kinestat
