// What is wrong with the keys of a mapping of the file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "format/form.hpp"
#include "io/fields.hpp"

namespace kinestat {

/// The mapping in messages: the file itself is "the mechanism".
std::string_view title_of(const FileValue& mapping);

/// The key that the mapping cannot do without, if it is the only one and has a name as its value.
std::string_view only_name_of(const FormShape& shape);

/// The value behind the key of that index; a needed one that is missing becomes an error of
/// `fields`, unless another key stands instead of it.
std::optional<FileValue> find_key(const FormShape& shape,
                                  std::size_t index,
                                  Fields& fields,
                                  const FileValue& mapping);

/// Complains of keys that do not belong together. `errors_before` counts the errors before the
/// mapping was read.
void check_rules(const FormShape& shape, const FileValue& mapping, int errors_before);

/// Leaves out of what is written the keys that another one stands instead of.
void leave_out_replaced(const FormShape& shape, FileText& written);

}  // namespace kinestat
