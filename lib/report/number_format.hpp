// Numbers as text, the same bytes in every locale.
#pragma once

#include <string>

namespace kinestat {

/// The shortest decimal that reads back as the same double, with ".0" if it is whole; "0.0" for
/// both zeros. `value` must be finite.
std::string format_exact(double value);

/// Six significant digits for tables, without trailing zeros: "2.84689", "100", "-1.5e-07".
std::string format_short(double value);

}  // namespace kinestat
