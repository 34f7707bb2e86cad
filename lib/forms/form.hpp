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
#include "forms/file_text.hpp"
#include "forms/form_shape.hpp"
#include "io/title.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

inline constexpr Title kNoTitle;

/// A value of the file while it is read.
struct FileValue {
  const YamlNode& node;
  Title what;                      ///< in messages: "'trace' of 'motion'"; empty: the file itself
  const FormKey* key = nullptr;    ///< behind which it stands, in a list too; null: none
  const Title* owner = &kNoTitle;  ///< the mapping that has the key: "'motion'"
  SourceRange where;               ///< of a mapping: where it says that a key is missing
  SourceRange place;               ///< where it begins: a section at its key
  std::optional<Space> space;      ///< empty after an error: then nothing is read that needs it
  Diagnostics& found;
};

/// A function whose copies share what it holds.
template <class Signature>
class SharedFunction;

template <class Result, class... Arguments>
class SharedFunction<Result(Arguments...)> {
 public:
  template <class F>

  requires(!std::same_as<F, SharedFunction>) SharedFunction(F function)
      : function_(
            std::make_shared<const std::function<Result(Arguments...)>>(std::move(function))) {}

  Result operator()(Arguments... arguments) const { return (*function_)(arguments...); }

 private:
  std::shared_ptr<const std::function<Result(Arguments...)>> function_;
};

/// Reads into an object of some type, as good as new; false iff it added an error.
using AnyRead = SharedFunction<bool(const FileValue&, void*)>;

/// Of an object of some type.
using AnyWrite = SharedFunction<FileText(const void*)>;

/// The form of a value of some type. What does not depend on the type is made of these, and so
/// compiled once.
struct AnyForm {
  FormShape shape;
  AnyRead read;
  AnyWrite write;
};

/// Answers empty iff it added an error.
template <class T>
class FormRead {
 public:
  FormRead(AnyRead any) : any_(std::move(any)) {}

  template <std::invocable<const FileValue&> F>

  requires(!std::same_as<F, FormRead>) FormRead(F read)
      : any_([read = std::move(read)](const FileValue& value, void* object) {
          auto one = read(value);
          if (one) {
            *static_cast<T*>(object) = *std::move(one);
          }
          return one.has_value();
        }) {}

  std::optional<T> operator()(const FileValue& value) const {
    std::optional<T> one(std::in_place);
    if (!any_(value, &*one)) {
      one.reset();
    }
    return one;
  }

  const AnyRead& any() const { return any_; }

 private:
  AnyRead any_;
};

template <class T>
class FormWrite {
 public:
  FormWrite(AnyWrite any) : any_(std::move(any)) {}

  template <std::invocable<const T&> F>

  requires(!std::same_as<F, FormWrite>) FormWrite(F write)
      : any_([write = std::move(write)](const void* object) {
          return write(*static_cast<const T*>(object));
        }) {}

  FileText operator()(const T& object) const { return any_(&object); }

  const AnyWrite& any() const { return any_; }

 private:
  AnyWrite any_;
};

template <class T>
struct Form {
  FormShape shape;
  FormRead<T> read;
  FormWrite<T> write;
};

/// The form of a T with its type forgotten.
template <class T>
AnyForm any_of(const Form<T>& form) {
  return {.shape = form.shape, .read = form.read.any(), .write = form.write.any()};
}

/// Of which it is known that it is a T's.
template <class T>
Form<T> form_of_a(AnyForm form) {
  return {
      .shape = std::move(form.shape), .read = std::move(form.read), .write = std::move(form.write)};
}

/// Which of several forms an object is written in.
using AnyChoice = std::function<std::size_t(const void*)>;

template <class T, std::invocable<const T&> Choose>
AnyChoice any_choice(Choose choose) {
  return [choose = std::move(choose)](const void* object) -> std::size_t {
    return choose(*static_cast<const T*>(object));
  };
}

}  // namespace kinestat
