// What speaks against a linkage.
#pragma once

#include <bitset>
#include <cstddef>
#include <string_view>

namespace kinestat {

/// What speaks against a linkage, worst first.
enum class Defect {
  none,
  digits,             ///< the positions leave a dyad no digits
  circuit,            ///< positions lie in circuits that no motion joins
  branch,             ///< a dead point of the input lies between positions
  order,              ///< the input passes the positions in another order
  grashof,            ///< of another class
  other_circuit,      ///< in another circuit than asked for
  full_turn,          ///< the input meets a dead point elsewhere
  centre_point,       ///< outside its area
  circle_point,       ///< outside its area
  transmission,       ///< below the limit on the way from the first to the last position
  full_transmission,  ///< below the limit elsewhere
  ratio,              ///< above the limit
  size                ///< above the limit
};

inline constexpr std::size_t kDefectCount = static_cast<std::size_t>(Defect::size) + 1;

/// The word in reports.
std::string_view word_of(Defect defect);

/// The key of `limits` that a defect after `order` breaks.
std::string_view limit_of(Defect defect);

/// Everything that speaks against one linkage. Of a linkage that does not pass the positions, what
/// is asked of the way through them is not judged.
class Defects {
 public:
  void add(Defect defect);

  bool has(Defect defect) const { return all_[static_cast<std::size_t>(defect)]; }

  bool is_empty() const { return all_.none(); }

  /// None, if there are none.
  Defect worst() const;

  /// Those that the limits of a task make: the linkage itself passes the positions.
  bool are_of_limits() const { return worst() == Defect::none || worst() > Defect::order; }

  std::size_t count() const { return all_.count(); }

 private:
  std::bitset<kDefectCount> all_;
};

}  // namespace kinestat
