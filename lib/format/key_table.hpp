// The keys of a mechanism file as plain text, for pages of help.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "couplings/kind.hpp"

namespace kinestat {

/// The keys of a section and those below them: form, whether it is needed or what is usual, and an
/// example on one line, the meaning under it. Lines have at most 95 columns.
std::string key_table(std::string_view section);

/// The types of couplings: what each frees and bears, named by axes along those of the world, the
/// meaning under it.
std::string coupling_table();

/// Along what the actions of the types point as the mechanism moves.
std::string action_directions();

/// The types whose friction is that of surfaces that slide.
std::string sliding_kinds();

/// What one of them frees and bears, what else it is called, the example, and its keys.
std::string coupling_page(const CouplingKind& kind, std::string_view example);

/// The page of help of a section; empty if it has none.
using PageOf = std::function<std::string(std::string_view section)>;

/// The sections themselves.
std::string section_table(const PageOf& page_of);

/// Every key of the format once, in the order of a file.
std::vector<std::string> format_keys();

/// Where a key stands, and what it means there; empty if there is none of that name.
std::string key_page(std::string_view key, const PageOf& page_of);

}  // namespace kinestat
