// What reports say of a linkage.
#pragma once

#include "record/record.hpp"
#include "studies/synthesis/synthesis.hpp"

namespace kinestat {

/// Its class, its cognates and the verdict on each drive.
const Record<LinkageCandidate>& linkage_record();

}  // namespace kinestat
