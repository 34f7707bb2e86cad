// All pictures that there are: what each shows, what it is made of, and who draws it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"
#include "studies/benchmark/report/benchmark_report.hpp"
#include "studies/duty/efficiency_map.hpp"
#include "studies/motion/picture/animation.hpp"
#include "studies/motion/picture/placed_mechanism.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/sweep/report/sweep_table.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

class GearSections;

/// What pictures of one file are made of; null what the file does not have, or what nobody found.
struct PictureSource {
  const Analysis* analysis = nullptr;
  const MotionTable* motion = nullptr;
  const MovingMechanism* moving = nullptr;  ///< only beside `motion`
  const PlacedMechanism* placed = nullptr;  ///< instead of `analysis`, of a drawing in positions
  const SynthesisAnalysis* synthesis = nullptr;
  const TransmissionAnalysis* transmissions = nullptr;
  const std::vector<BenchmarkedCase>* benchmark = nullptr;
  const MotionTable* simulation = nullptr;  ///< of simulation_table
  const SweepTable* sweep = nullptr;
  const std::vector<EfficiencyMap>* maps = nullptr;  ///< only beside `analysis`
  /// Index into Analysis::cases: the case that a picture of one case shows; empty: the first that
  /// has what it needs. Pictures of all cases show that one alone.
  std::optional<std::size_t> which = {};
  std::optional<std::size_t> over = {};  ///< the column of `motion` over which charts stand
  std::string name = {};                 ///< of the mechanism or, without one, of its file
  GearSections* sections = nullptr;      ///< of `analysis`, where several pictures of it are drawn
};

/// What must be found for a picture.
enum class PictureNeed {
  analysis,
  motion,
  moving,
  placed,
  simulation,
  synthesis,
  transmissions,
  benchmark,
  sweep,
  maps  // the last
};

/// Whether the motion of the file is all that it shows.
constexpr bool is_of_motion(PictureNeed need) {
  return need == PictureNeed::motion || need == PictureNeed::moving;
}

/// Whether cases of the file decide what it shows.
constexpr bool is_of_cases(PictureNeed need) {
  using enum PictureNeed;
  return need != simulation && need != synthesis && need != transmissions && need != sweep;
}

/// Whether a picture is of the file, or of one of its cases.
enum class PictureScope { file, one_case };

/// A row of the catalogue. `why_not` says why there is no picture, "the file has no section
/// 'shift'", and is empty if there is one; only then the others may be called. Null where there is
/// no such text.
struct PictureKind {
  std::string_view name;      ///< "shift-matrix": the word of the command, and Picture::name
  std::string_view sentence;  ///< what it shows, in a few words
  PictureNeed need = PictureNeed::analysis;
  PictureScope scope = PictureScope::file;
  bool takes_positions = false;  ///< of a drive: may be drawn with what PictureNeed::placed finds
  bool takes_abscissa = false;   ///< a column of a motion over which it is drawn
  std::string (*why_not)(const PictureSource&) = nullptr;
  Picture (*draw)(const PictureSource&) = nullptr;
  /// The same in parts that fit a telephone and stand beside each other on a page.
  std::vector<Picture> (*draw_in_parts)(const PictureSource&) = nullptr;
  std::string (*gnuplot)(const PictureSource&) = nullptr;
  std::string (*dot)(const PictureSource&) = nullptr;
};

/// In the order in which a report shows them.
std::span<const PictureKind> picture_kinds();

/// Null if there is no such picture.
const PictureKind* find_picture_kind(std::string_view name);

/// Whether all that the picture needs is there.
bool has_picture(const PictureKind& kind, const PictureSource& source);

}  // namespace kinestat
