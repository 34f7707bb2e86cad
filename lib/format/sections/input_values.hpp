// Magnitudes of inputs, in the sections `shift` and `duty`.
#pragma once

#include <vector>

#include "description/shift_description.hpp"
#include "format/form.hpp"

namespace kinestat {

/// One value for every input, or a mapping of actuators to values.
Form<std::vector<InputValue>> input_values(const Form<Value>& number);

}  // namespace kinestat
