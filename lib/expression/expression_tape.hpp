// Expressions on a tape, so that they are evaluated for many states at a time.
#pragma once

#include <optional>
#include <span>

#include "expression/file_units.hpp"
#include "expression/quantity.hpp"
#include "expression/slots.hpp"
#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

/// A number of a tape with its dimension, which is the same in every state.
using TapeQuantity = BasicQuantity<TapeNumber>;

/// Records a quantity as SlotExpression evaluates it, with the same bits; a lane in which it has
/// none has no answer. For the rest see record_as.
std::optional<TapeQuantity> record_quantity(const SlotExpression& expression,
                                            std::span<const std::optional<TapeQuantity>> slots,
                                            LaneRecorder& recorder);

/// Records a number in SI as evaluate_as gives it, with the same bits; a lane in which evaluate_as
/// has an error has no answer. `slots` are the quantities at the places of names. Empty where the
/// expression does more than add, subtract, multiply and divide what varies, or one of its names
/// has no quantity. Not for a lead.
std::optional<TapeNumber> record_as(QuantityKind kind,
                                    const SlotExpression& expression,
                                    const FileUnits& units,
                                    std::span<const std::optional<TapeQuantity>> slots,
                                    LaneRecorder& recorder);

}  // namespace kinestat
