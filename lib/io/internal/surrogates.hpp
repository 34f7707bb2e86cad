// Characters beyond 16 bits as JSON writes them with escapes: by two surrogates, "\ud83d\ude00".
#pragma once

#include <cstddef>
#include <vector>

#include "io/internal/yaml_text.hpp"

namespace kinestat {

/// The bytes of both escapes.
inline constexpr std::size_t kSurrogatesSize = 12;

/// Adds the offsets of all pairs in a text in double quotes, from its quote to its end.
void find_surrogates(const YamlText& text,
                     std::size_t begin,
                     std::size_t end,
                     std::vector<std::size_t>& offsets);

/// The character of the pair at the offset.
char32_t code_of_surrogates(const YamlText& text, std::size_t at);

}  // namespace kinestat
