// Magnitudes of inputs, in the sections `shift` and `duty`.
#pragma once

#include <string_view>
#include <vector>

#include "description/shift_description.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// One value for every input, or a mapping of actuators to values.
Form<std::vector<InputValue>> input_values(const Form<Value>& number);

/// Likewise, for whatever the key is about; the schema says that it maps these `elements`.
Form<std::vector<InputValue>> values_for(std::string_view elements, const Form<Value>& number);

}  // namespace kinestat
