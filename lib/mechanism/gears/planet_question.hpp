// Whether planets fit, asked for many values of parameters: assembles(planet), clears(planet).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/slots.hpp"

namespace kinestat {

/// Answered by teeth and count, and for `clears` by the layout, without binding a mechanism. What
/// it says is what the warnings say: `assembles` that equal planets can stand at equal angles (not
/// W0306), `clears` that neighbours do not touch (not W0307).
class PlanetQuestion {
 public:
  /// Why there is no answer, and what to type.
  struct Fault {
    std::string message;
    std::string hint;
  };

  /// `word` is one of condition_questions(), `of` a gear member that is a planet, or the body of
  /// one. The section `gears` must be right; copies the description.
  static std::variant<PlanetQuestion, Fault> make(std::string_view word,
                                                  std::string_view of,
                                                  const MechanismDescription& description);

  /// With the places of the names in its numbers.
  SlotAnswer with_slots(const SlotOf& slot_of) const;

 private:
  struct Train;

  bool is_of_assembly_ = true;
  std::shared_ptr<const Train> train_;
};

}  // namespace kinestat
