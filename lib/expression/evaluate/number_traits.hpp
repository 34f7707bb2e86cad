// What a type of number beside double must know, so that expressions can be evaluated with it.
#pragma once

namespace kinestat {

/// A number carries more than its `value`, which is always the one that double arithmetic gives:
/// the value alone decides whether there is a result, so that errors do not depend on the type.
/// A carrier works out the rest; what it answers in `value` does not count. It has
///
///   number(literal, value)   a decimal as typed
///   pi()
///   to_si(count, unit)       a number counted in a unit, in SI
///   from_si(value, unit)     a number in SI, counted in a unit
///   apply(node, a, b)        the operation of a node: negate to power, or a function; `b` is `a`
///                            where there is one operand
template <class Number>
struct NumberTraits;

}  // namespace kinestat
