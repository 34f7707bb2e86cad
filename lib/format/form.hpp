// How a value is written in a mechanism file: read from it, written to it, and told in the schema.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "format/file_text.hpp"
#include "format/form_shape.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// A value of the file while it is read.
struct FileValue {
  const YamlNode& node;
  std::string what;              ///< in messages: "'trace' of 'motion'"; empty: the file itself
  const FormKey* key = nullptr;  ///< behind which it stands, in a list too; null: none
  std::string_view owner;        ///< the mapping that has the key: "'motion'"
  SourceRange where;             ///< of a mapping: where it says that a key is missing
  SourceRange place;             ///< where it begins: a section at its key
  std::optional<Space> space;    ///< empty after an error: then nothing is read that needs it
  Diagnostics& found;
};

/// A function whose copies share what it holds.
template <class Signature>
class SharedFunction;

template <class Result, class Argument>
class SharedFunction<Result(Argument)> {
 public:
  template <class F>

  requires(!std::same_as<F, SharedFunction>) SharedFunction(F function)
      : function_(std::make_shared<const std::function<Result(Argument)>>(std::move(function))) {}

  Result operator()(Argument argument) const { return (*function_)(argument); }

 private:
  std::shared_ptr<const std::function<Result(Argument)>> function_;
};

/// `read` answers empty iff it added an error.
template <class T>
struct Form {
  FormShape shape;
  SharedFunction<std::optional<T>(const FileValue&)> read;
  SharedFunction<FileText(const T&)> write;
};

}  // namespace kinestat
