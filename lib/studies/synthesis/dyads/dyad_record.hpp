// What reports say of a dyad.
#pragma once

#include "record/record.hpp"
#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

const Record<Dyad>& dyad_record();

}  // namespace kinestat
