// Where the gears of `gears` stand for other values of parameters.
#pragma once

#include <optional>
#include <vector>

#include "expression/parameters.hpp"
#include "expression/slots.hpp"
#include "mechanism/bind/slot_number.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Finds the layout anew from teeth and modules, with the bits that bind gives; the structure of
/// the train stays.
class GearPlaces {
 public:
  /// `varies` is of each parameter of the table; the description must outlive it. Empty where more
  /// moves than teeth and modules, or a clutch joins two axes, which might part.
  static std::optional<GearPlaces> make(const MechanismDescription& description,
                                        const ParameterTable& table,
                                        const std::vector<bool>& varies);

  /// Whether anything moves.
  bool moves() const { return !teeth_.empty() || !modules_.empty(); }

  /// False where a number has no value, or teeth do not fit: then bind has an error.
  bool find(const Slots& slots, std::vector<Quantity>& scratch);

  /// What was found last; at first with the parameters of the table.
  const GearFrame& frame() const { return frame_; }

 private:
  struct Moving {
    std::size_t index = 0;  ///< of a member or a mesh
    SlotExpression value;
  };

  GearPlaces(const MechanismDescription& description, GearFrame frame, GearNumbers numbers)
      : description_(&description), frame_(std::move(frame)), numbers_(std::move(numbers)) {}

  void add_moving(const ParameterTable& table, const std::vector<bool>& varies);

  const MechanismDescription* description_;
  GearFrame frame_;
  GearNumbers numbers_;
  std::vector<Moving> teeth_;
  std::vector<Moving> modules_;
};

}  // namespace kinestat
