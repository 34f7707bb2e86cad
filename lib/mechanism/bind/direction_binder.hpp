// Directions of a coupling: present, in the space, and at the angle to each other that they need.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// What a direction is for: in the plane, an axis of turning is z, all others lie in the plane.
enum class DirectionRole { turning, in_plane };

/// Reads the directions of one coupling. Answers are empty iff an error was added.
template <class Scalar>
class DirectionBinder {
 public:
  DirectionBinder(const CouplingDescription& coupling,
                  Space space,
                  EvaluatorOf<Scalar>& evaluator,
                  Diagnostics& found)
      : coupling_(coupling), space_(space), evaluator_(evaluator), found_(found) {}

  /// The direction of a key. One that is absent is z for turning in the plane and for a coupling
  /// that is only counted; otherwise an error with `hint`.
  std::optional<AxisOf<Scalar>> bind(const std::optional<AxisDescription>& direction,
                                     std::string_view key,
                                     DirectionRole role,
                                     std::string_view hint);

  /// A direction that is there.
  std::optional<AxisOf<Scalar>> bind(const AxisDescription& direction, DirectionRole role);

  /// Whether the angle between two is a right one; else complains at `where`.
  bool check_perpendicular(const AxisOf<Scalar>& a,
                           const AxisOf<Scalar>& b,
                           SourceRange where,
                           std::string_view message,
                           std::string_view hint);

  /// "gear 'h'"
  std::string title() const;

  void refuse(SourceRange where, std::string message, std::string hint);

 private:
  bool check_in_plane(const AxisOf<Scalar>& axis, SourceRange where, DirectionRole role);

  const CouplingDescription& coupling_;
  Space space_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
};

}  // namespace kinestat
