// What two reports may differ in and mean the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// Whether a quantity of a table counts: no key on its path is one that records mark as not
/// compared, and that none has as one that is.
bool is_compared_in_tables(std::string_view quantity);

/// The keys of JSON reports that records mark as not compared, each with what is below it, in
/// alphabetical order; a key that is compared elsewhere has that above it in front: "jump/at".
std::vector<std::string> ignored_keys();

}  // namespace kinestat
