// What holds of the gears of a structure for all stationary ratios: decided once, with drawn ones
// in a prime field.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/numbers/mersenne_residue.hpp"
#include "studies/transmissions/set_minors.hpp"
#include "studies/transmissions/structure.hpp"

namespace kinestat {

/// Pairs of shafts whose slips are one, up to a factor: as an element each makes the same gears.
/// Two pairs of one set lock it either way. None joins the housing to input or output.
using ElementClass = std::vector<ShaftPair>;

/// Classes that are engaged or that a layout has, as bits.
using ClassMask = std::uint64_t;

/// What becomes of a choice of engaged classes.
struct GenericState {
  bool is_gear = false;     ///< input and output turn; else locked, neutral or tie-up
  bool is_direct = false;   ///< ratio 1 whatever the sets are
  std::uint32_t ratio = 0;  ///< gears of one number have one ratio
  std::array<std::uint32_t, kMostGearSets>
      change{};  ///< by the set of which i0 changes: gears of one
                 ///< number have their ratio changed by one factor
};

class GenericTrain {
 public:
  GenericTrain(const TransmissionStructure& structure, int engaged);

  const TransmissionStructure& structure() const { return structure_; }

  const SetMinors& minors() const { return minors_; }

  const std::vector<ElementClass>& classes() const { return classes_; }

  int engaged() const { return engaged_; }

  /// The class of a pair, its lesser shaft first.
  std::size_t class_of(const ShaftPair& pair) const { return class_of_[pair[0]][pair[1]]; }

  /// The number of a state: the place of its classes, ascending, among all choices.
  std::size_t state_of(ClassMask engaged) const;

  std::span<const GenericState> states() const { return states_; }

  /// The terms of the speeds of input and output; their quotient is the ratio.
  std::span<const MinorTerm> input_terms(std::size_t state) const { return terms(2 * state); }

  std::span<const MinorTerm> output_terms(std::size_t state) const { return terms(2 * state + 1); }

  /// Where an automorphism of the structure takes each class.
  std::vector<std::uint8_t> class_map(const VertexMap& automorphism) const;

 private:
  void find_classes();
  void find_terms();
  void decide_states();
  std::span<const MinorTerm> terms(std::size_t number) const;
  std::vector<SetEquation<MersenneResidue>> drawn_equations() const;
  std::vector<MersenneResidue> ratios_with(
      std::span<const SetEquation<MersenneResidue>> equations) const;

  const TransmissionStructure& structure_;
  int engaged_;
  SetMinors minors_;
  std::vector<ElementClass> classes_;
  std::array<std::array<std::uint8_t, kMostShafts>, kMostShafts> class_of_{};
  std::vector<std::array<std::size_t, kMostEngaged>> binomials_;
  std::vector<MinorTerm> terms_;
  std::vector<std::uint32_t> first_terms_;  // of input and output of each state, and the end
  std::vector<GenericState> states_;
};

}  // namespace kinestat
