// The part `function` of the section `synthesis`.
#pragma once

#include "description/synthesis_description.hpp"
#include "forms/mapping.hpp"

namespace kinestat {

inline constexpr const char* kFunctionExample =
    "{input: {centre_point: [0, 0], angles: [0 deg, 40 deg, 80 deg]}, output: {centre_point: "
    "[100, 0], angles: [0 deg, 37 deg, 88 deg]}}";

const Mapping<FunctionDescription>& synthesis_function();

}  // namespace kinestat
