// The kinds of numbers in a mechanism file; each may be an expression.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/value.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// A default as it would be written.
template <int kNumber>
std::string_view usual_number() {
  static const std::string text = std::to_string(kNumber);
  return text;
}

/// A number with its range: of a bare number, which the schema knows. What an expression comes to
/// is judged when it is bound.
Form<Value> number_form(std::string_view definition,
                        std::string_view meaning,
                        SharedList<std::string_view> examples,
                        NumberRange range = {});

/// The same without a unit and without parameters, known at once.
Form<double> plain_number(const Form<Value>& number);

/// A couple: one number about z in the plane, a vector in space.
Form<std::vector<Value>> couple();

Form<Value> bare_number();
Form<Value> teeth();
Form<Value> planet_count();
Form<Value> step_count();
Form<Value> point_count();
Form<Value> state_count();
Form<Value> seed();
Form<Value> digit_count();
Form<Value> at_least_one();
Form<Value> not_zero();
Form<Value> not_negative();
Form<Value> above_zero();
Form<Value> duration();
Form<Value> not_negative_whole();
Form<Value> fraction();
Form<Value> efficiency();
Form<Value> component();  ///< of a direction
Form<Value> length();
Form<Value> size();
Form<Value> non_negative_length();
Form<Value> pitch();
Form<Value> lead();
Form<Value> stiffness();
Form<Value> friction_moment();
Form<Value> viscous_couple();
Form<Value> viscous_force();
Form<Value> acute_angle();
Form<Value> angle();
Form<Value> mass();
Form<Value> moment_of_inertia();
Form<Value> product_of_inertia();  ///< or moment, as an entry of a tensor
Form<Value> force();
Form<Value> moment();
Form<Value> acceleration();
Form<Value> speed();
Form<Value> speed_change();
Form<Value> drawn_position();
Form<Value> increment();
Form<Value> input_speed();
Form<Value> input_load();
Form<Value> torque_limit();
Form<Value> speed_limit();
Form<Value> any_number();
Form<Value> action();

}  // namespace kinestat
