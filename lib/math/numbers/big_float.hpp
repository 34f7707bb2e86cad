// Decimal floating-point numbers of a hundred digits, for tasks whose data are typed as decimals.
#pragma once

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <string>

namespace kinestat {

using BigFloat = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<100>,
                                               boost::multiprecision::et_off>;

}  // namespace kinestat
