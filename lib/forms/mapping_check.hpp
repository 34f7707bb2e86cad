// What is wrong with the keys of a mapping of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "forms/form.hpp"
#include "io/fields.hpp"

namespace kinestat {

/// The mapping in messages: the file itself is "the mechanism".
Title title_of(const FileValue& mapping);

/// A bit for what a key begins with; that of the keys that are looked for even where none begins
/// so.
std::uint64_t beginning_of(std::string_view key);
inline constexpr std::uint64_t kAnyBeginning = std::uint64_t{1} << 63U;

/// The keys of a mapping while it is read.
class MappingKeys {
 public:
  /// A value that is no mapping is an error. Keys that are `known` may stand beside those of the
  /// shape.
  MappingKeys(const FormShape& shape,
              const FileValue& mapping,
              const SharedList<std::string_view>& known);

  /// The bits of the keys that are there, and that of any.
  std::uint64_t beginnings() const { return beginnings_; }

  /// The value behind the key of that index; a needed one that is missing becomes an error of
  /// finish(), unless another key stands instead of it.
  std::optional<FileValue> find(std::size_t index);

  /// Says everything that is wrong with the keys, once all have been looked for.
  void finish();

 private:
  void complain_of_missing(const FormKey& key);

  const FormShape& shape_;
  const FileValue& mapping_;
  const SharedList<std::string_view>& known_;
  std::uint64_t beginnings_ = kAnyBeginning;
  std::size_t found_ = 0;
  Fields fields_;
};

/// Complains of keys that do not belong together. `errors_before` counts the errors before the
/// mapping was read.
void check_rules(const FormShape& shape, const FileValue& mapping, int errors_before);

/// Leaves out of what is written the keys that another one stands instead of.
void leave_out_replaced(const FormShape& shape, FileText& written);

}  // namespace kinestat
