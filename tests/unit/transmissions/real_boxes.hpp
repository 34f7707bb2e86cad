// Transmissions that are built, by their teeth.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studies/transmissions/gear_figures.hpp"
#include "studies/transmissions/roles.hpp"

namespace kinestat {

struct RealSet {
  SetKind kind;
  Shaft sun;
  Shaft carrier;
  Shaft ring;
  int sun_teeth;
  int ring_teeth;
};

/// Elements by their letters, A first; gears as letters with the exact ratio, forward gears in
/// their order and the reverse gear last.
struct RealBox {
  std::string name;
  int engaged;
  int free_shafts;
  std::vector<RealSet> sets;
  std::vector<ShaftPair> elements;
  std::vector<std::pair<std::string, double>> gears;
};

/// Simpson's A727, 41TE, 4HP14, 6HP26, 8HP70, 9G-Tronic, 10R80: published teeth and ratios.
const std::vector<RealBox>& real_boxes();

/// A box with the structure that it stands on.
class BoxTrain {
 public:
  explicit BoxTrain(const RealBox& box);

  const TransmissionStructure& structure() const { return structure_; }

  const TransmissionTrain& transmission() const { return transmission_; }

  std::uint8_t engaged(const std::string& letters) const;

 private:
  TransmissionStructure structure_;
  GenericTrain train_;
  TransmissionTrain transmission_;
};

}  // namespace kinestat
