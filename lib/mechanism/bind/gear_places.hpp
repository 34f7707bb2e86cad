// The places of the gears of `gears` for other values of parameters.
#pragma once

#include <optional>
#include <vector>

#include "expression/parameters.hpp"
#include "expression/slots.hpp"
#include "mechanism/bind/slot_number.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Finds the layout of a train again for other teeth and modules, with the same bits as bind. The
/// structure of the train must not change.
class GearPlaces {
 public:
  /// `varies` says for each parameter of the table whether it varies. The description must outlive
  /// the result. Empty if more varies than teeth and modules, or if a clutch joins two axes, which
  /// might move apart.
  static std::optional<GearPlaces> make(const MechanismDescription& description,
                                        const ParameterTable& table,
                                        const std::vector<bool>& varies);

  /// Whether any number of teeth or module varies.
  bool moves() const { return !teeth_.empty() || !modules_.empty(); }

  /// Finds the layout for these parameters. False if a number has no value or teeth do not fit;
  /// bind then has an error.
  bool find(const Slots& slots, std::vector<Quantity>& scratch);

  /// The layout that was found last; at first that of the parameters of the table.
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
