// Places in a report: JSON Pointers, and patterns of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// The place of a key below another place, escaped by RFC 6901: '~' as "~0", '/' as "~1".
std::string place_below(const std::string& place, std::string_view key);

/// Goes from a place to that below it.
void append_key(std::string& place, std::string_view key);

/// The keys on the way to a place, as they are escaped in it.
std::vector<std::string_view> keys_of(std::string_view place);

/// Whether a place is that of the pattern or below it; '*' in the pattern is any one key:
/// "/cases/*/ratio".
bool is_within(std::string_view place, std::string_view pattern);

}  // namespace kinestat
