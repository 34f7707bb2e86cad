// Mappings of which each has a key of its own: the first that it needs says which of them it is.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "forms/mapping.hpp"

namespace kinestat {

/// What is said where none of the first keys is there, or several are; {} is the mapping.
struct VariantTexts {
  std::string none;
  std::string none_hint;
  std::string both;
  std::string both_hint;
};

AnyForm any_mapping_of(std::vector<const AnyMapping*> mappings,
                       VariantTexts texts,
                       AnyChoice choose);

/// One of the mappings; `choose` says in which of them a value is written.
template <class T, std::invocable<const T&> Choose>
Form<T> one_mapping_of(std::initializer_list<const Mapping<T>*> mappings,
                       VariantTexts texts,
                       Choose choose) {
  return form_of_a<T>(any_mapping_of(
      {mappings.begin(), mappings.end()}, std::move(texts), any_choice<T>(std::move(choose))));
}

AnyForm only_any_of(std::vector<const AnyMapping*> mappings,
                    std::string message,
                    std::string hint,
                    AnyChoice choose);

/// One of the mappings, all of whose first keys count as known. Where there is not exactly one of
/// these, an error says so, and others of keys that none of the mappings has.
template <class T, std::invocable<const T&> Choose>
Form<T> only_one_of(std::initializer_list<const Mapping<T>*> mappings,
                    std::string message,
                    std::string hint,
                    Choose choose) {
  return form_of_a<T>(only_any_of({mappings.begin(), mappings.end()},
                                  std::move(message),
                                  std::move(hint),
                                  any_choice<T>(std::move(choose))));
}

}  // namespace kinestat
