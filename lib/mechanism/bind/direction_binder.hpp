// The directions of a coupling, and whether they are given, in the plane and perpendicular.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// The role of a direction. In a planar mechanism, an axis of rotation is z, and all other
/// directions lie in the plane.
enum class DirectionRole { turning, in_plane };

/// Binds the directions of one coupling. Results are empty iff an error was added.
template <class Scalar>
class DirectionBinder {
 public:
  DirectionBinder(const CouplingDescription& coupling,
                  Space space,
                  EvaluatorOf<Scalar>& evaluator,
                  Diagnostics& found)
      : coupling_(coupling), space_(space), evaluator_(evaluator), found_(found) {}

  /// Binds the direction of a key. If it is absent, it is z for a rotation in the plane and for a
  /// coupling that is only counted; otherwise an error with `hint` is added.
  std::optional<AxisOf<Scalar>> bind(const std::optional<AxisDescription>& direction,
                                     std::string_view key,
                                     DirectionRole role,
                                     std::string_view hint);

  /// Binds a direction that is given.
  std::optional<AxisOf<Scalar>> bind(const AxisDescription& direction, DirectionRole role);

  /// Whether two directions are perpendicular; otherwise an error is added at `where`.
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
