// Numbers with what they count, in words.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// "1 body", "2 bodies".
std::string counted(int number, std::string_view one, std::string_view many);

/// "1 coupling", "2 couplings".
std::string counted(int number, std::string_view noun);

}  // namespace kinestat
