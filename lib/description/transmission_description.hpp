// The mapping `transmission` of the section `synthesis`: what is asked of a planetary transmission.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// A closed range: the least and the largest value.
struct ValueRange {
  std::vector<Value> ends;
  SourceRange where;
};

/// Ratios of ring to sun that sets of a kind may have: a range, or values.
struct StationaryRange {
  std::optional<Value> from;
  std::optional<Value> to;
  std::vector<Value> values;
  SourceRange where;
};

/// How many sets: simple ones, and those with planets in pairs.
struct SetCounts {
  std::optional<Value> simple;
  std::optional<Value> double_planet;
  SourceRange where;
};

/// How many shift elements: in all, or clutches and brakes.
struct ElementCounts {
  std::optional<Value> all;
  std::optional<Value> clutches;
  std::optional<Value> brakes;
  SourceRange where;
};

struct WantedGears {
  std::optional<Value> forward;
  std::optional<Value> reverse;
  bool direct = false;
  std::optional<bool> one_change;  ///< usually true
  bool reverse_change = false;
};

struct WantedRatios {
  std::optional<ValueRange> first;
  std::optional<ValueRange> last;
  std::optional<ValueRange> spread;
  std::optional<ValueRange> step;
  std::optional<ValueRange> reverse;
  SourceRange where;
};

struct StationaryRatioRanges {
  std::optional<StationaryRange> simple;
  std::optional<StationaryRange> double_planet;
};

/// What teeth sets may have.
struct WantedTeeth {
  std::optional<ValueRange> sun;
  std::optional<ValueRange> ring;
  std::optional<Value> planet;  ///< the least
  std::vector<Value> planets;   ///< how many stand round the sun
  SourceRange where;
};

struct TransmissionLimitsDescription {
  std::optional<Value> element_torque;
  std::optional<Value> element_slip;
  std::optional<Value> shaft_speed;
  std::optional<Value> planet_speed;
  std::optional<Value> efficiency;
  std::optional<Value> rotating_clutches;
  std::optional<Value> hollow_shafts;
};

struct SetLosses {
  std::optional<Value> simple;
  std::optional<Value> double_planet;
};

/// The first and the last structure of a slice, by number.
struct StructureSlice {
  std::optional<Value> from;
  std::optional<Value> to;
  SourceRange where;
};

enum class SectionArrangement { any, coaxial, sideways };

enum class TransmissionOrder { efficiency, steps, torque, speed, elements };

/// As files and command lines have them.
inline constexpr std::array<std::string_view, 5> kTransmissionOrders = {
    "efficiency", "steps", "torque", "speed", "elements"};

/// What stands where the file says nothing.
inline constexpr double kUsualLeastStationaryRatio = 1.5;
inline constexpr double kUsualLargestStationaryRatio = 4.0;
inline constexpr double kUsualSimpleLoss = 0.02;
inline constexpr double kUsualDoublePlanetLoss = 0.03;

struct TransmissionDescription {
  SetCounts sets;
  ElementCounts elements;
  std::optional<Value> engaged;
  std::optional<Value> free_shafts;
  WantedGears gears;
  WantedRatios ratios;
  StationaryRatioRanges stationary_ratio;
  std::optional<WantedTeeth> teeth;
  TransmissionLimitsDescription limits;
  SetLosses losses;
  SectionArrangement layout = SectionArrangement::coaxial;
  TransmissionOrder rank = TransmissionOrder::efficiency;
  std::optional<StructureSlice> structures;
  SourceRange where;
};

}  // namespace kinestat
