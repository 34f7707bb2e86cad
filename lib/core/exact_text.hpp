// Numbers as text from which the same number is read, for rows by the million.
#pragma once

#include <cstddef>
#include <string>

namespace kinestat {

/// No such text is longer than this; -2.2250738585072014e-308 has 24 characters.
inline constexpr std::size_t kLongestExact = 24;

/// Room for one that is being written, which takes more than it leaves.
inline constexpr std::size_t kRoomForExact = 40;

/// Writes the shortest decimal that reads back as the same double, with ".0" if it is whole; "0.0"
/// for both zeros. `value` must be finite; `text` has room for kRoomForExact. Where the text ends.
char* write_exact(double value, char* text);

/// Appends that text. It allocates nothing where there is room.
void append_exact(double value, std::string& text);

}  // namespace kinestat
