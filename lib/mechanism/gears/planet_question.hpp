// The conditions assembles(planet) and clears(planet), evaluated for many values of parameters.
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

/// A condition on equal planets. It depends on teeth and count, `clears` also on the layout, and
/// needs no bound mechanism. It agrees with the warnings: `assembles` means that the planets can be
/// placed at equal angles (no W0306), `clears` that neighbours do not touch (no W0307).
class PlanetQuestion {
 public:
  /// Why a question has no answer, and a hint what to type.
  struct Fault {
    std::string message;
    std::string hint;
  };

  /// `word` is one of condition_questions(), `of` a gear member that is a planet, or the body of
  /// one. The section `gears` must be right; copies the description.
  static std::variant<PlanetQuestion, Fault> make(std::string_view word,
                                                  std::string_view of,
                                                  const MechanismDescription& description);

  /// The question as a function of the slots of the parameters that its numbers use.
  SlotAnswer with_slots(const SlotOf& slot_of) const;

 private:
  struct Train;

  bool is_of_assembly_ = true;
  std::shared_ptr<const Train> train_;
};

}  // namespace kinestat
