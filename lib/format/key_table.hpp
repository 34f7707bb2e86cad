// The keys of a mechanism file as plain text, for pages of help.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace kinestat {

/// The keys of a section and those below them: form, whether it is needed or what is usual, and an
/// example on one line, the meaning under it. Lines have at most 95 columns.
std::string key_table(std::string_view section);

/// The types of couplings: what each frees and bears, named by axes along those of the world, the
/// meaning under it.
std::string coupling_table();

/// The sections themselves; `page_of` names the page of help of a section, if it has one.
std::string section_table(const std::function<std::string(std::string_view section)>& page_of);

}  // namespace kinestat
