// Transmissions that were found, with what is told of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "studies/transmissions/search.hpp"
#include "studies/transmissions/teeth_choice.hpp"

namespace kinestat {

/// What becomes of the ladder when the mechanism in teeth is solved gear by gear, and what the
/// search makes of the same teeth: the largest differences.
struct TransmissionCheck {
  double ratio = 0.0;       ///< relative
  double torque = 0.0;      ///< of elements, over the largest torque of the gear
  double efficiency = 0.0;  ///< absolute
  bool agrees = false;
};

struct TransmissionVariant {
  FoundTransmission found;
  std::vector<SetShafts> sets;
  int shafts = 0;
  std::vector<LadderGear> gears = {};
  std::vector<SetTeeth> teeth = {};  ///< by set
  std::string file = {};             ///< written for it; empty: none
  std::optional<TransmissionCheck> check = {};
};

/// Transmissions of one ladder, the best first.
struct LadderGroup {
  std::vector<TransmissionVariant> variants;
};

struct TransmissionAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  TransmissionTask task;
  std::uint64_t structure_count = 0;
  SearchStages stages;
  std::uint64_t ladder_count = 0;   ///< also of groups that are not listed
  std::vector<LadderGroup> groups;  ///< the best first
  std::vector<LadderFigures> all;   ///< of all that were found, likewise
};

/// A, B, … by the place of the element.
std::string element_letter(std::size_t element);

/// The letters of what is engaged.
std::string engaged_letters(std::uint8_t engaged);

/// "housing", "in", "out", "x3", …
std::string shaft_name(Shaft shaft);

/// How many were found, and the best ladder, in a sentence.
std::string transmission_sentence(const TransmissionAnalysis& analysis);

/// Stages and ladders with their transmissions, as text.
TextBlocks transmission_blocks(const TransmissionAnalysis& analysis);

FileReport make_transmission_report(const TransmissionAnalysis& analysis,
                                    const ReportForms& forms,
                                    const Diagnostics& found);

}  // namespace kinestat
