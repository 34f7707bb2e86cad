// A mapping of a mechanism file that is read into objects of any type.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "forms/any_member.hpp"
#include "forms/form.hpp"
#include "forms/member.hpp"

namespace kinestat {

/// What forms/mapping.hpp declares, without the type of the object.
class AnyMapping {
 public:
  const FormShape& shape() const { return shape_; }

  /// Reads the value as a mapping, in which other keys may be `known`, into an object. False iff an
  /// error was added.
  bool any_read(void* object,
                const FileValue& value,
                const SharedList<std::string_view>& known = {}) const;

  /// The same, without noting where the mapping stands, as it does in an object of another key.
  bool any_read_into(void* object,
                     const FileValue& value,
                     const SharedList<std::string_view>& known = {}) const;

  /// Without the keys that are as they would be if left out.
  FileText any_text(const void* object) const;

  /// The same; empty if all keys are left out.
  std::optional<FileText> any_text_if_any(const void* object) const;

  /// `key` stands instead of `others`.
  void instead(std::string_view key, SharedList<std::string_view> others, std::string_view hint);

  void rule(FormRule rule) { shape_.rules.push_back(std::move(rule)); }

  /// Keys that begin like this one are the user's own and pass unread.
  void own_keys(FormKey beginning) { shape_.beginnings.push_back(std::move(beginning)); }

  void example(std::string_view text) { shape_.examples.push_back(text); }  ///< another

  void may_be_empty() { shape_.may_be_empty = true; }  ///< nothing need stand behind its name

  void write_in_lines() { is_in_lines_ = true; }  ///< a line for each key

 protected:
  using ReadKey = std::function<void(const FileValue&, void*)>;
  using WriteKey = std::function<std::optional<FileText>(const void*)>;  ///< empty: left out

  /// `place`: the member that takes where the mapping stands; `usual`: an object of which the file
  /// says nothing.
  AnyMapping(std::string_view definition,
             std::string_view meaning,
             std::string_view example,
             std::optional<AnyMember> place,
             const void* (*usual)());

  AnyForm any_form() const;

  /// To be called once all keys and rules are declared.
  void close();

  void add(FormKey key, ReadKey read, WriteKey write);

  /// A key whose value is a member.
  void add_member(
      FormKey key, AnyMember member, const MemberOps& ops, const AnyRead& read, AnyWrite write);

  /// A key whose value has the keys of the object, or of the member.
  void add_group(FormKey key, const AnyMapping& part, std::optional<AnyMember> member);

  /// All keys of a mapping for the only item of a list, and behind `list_key` the list of several.
  void add_one_or_several(const AnyMapping& item,
                          AnyMember member,
                          const ListOps& items,
                          FormKey list_key,
                          const AnyForm& list);

  FormKey& last_key() { return shape_.keys.back(); }

  /// What else is done where the last key is there.
  void also_place(AnyMember place, bool of_value);
  void also_note(AnyMember is_there);
  void also_read(std::function<void(void*)> more);

  /// The last key is written of such objects alone.
  void write_only_if(std::function<bool(const void*)> is_so);

  void add_check(std::function<void(const void*, const FileValue&)> check) {
    checks_.push_back(std::move(check));
  }

 private:
  struct Step {
    ReadKey read;
    WriteKey write;
  };

  FormShape shape_;
  bool is_in_lines_ = false;
  std::vector<Step> steps_;                // of the keys
  std::vector<std::uint64_t> beginnings_;  // of the keys, as MappingKeys::beginnings
  std::vector<std::function<void(const void*, const FileValue&)>> checks_;
  std::optional<AnyMember> place_;
  const void* (*usual_)();
};

}  // namespace kinestat
