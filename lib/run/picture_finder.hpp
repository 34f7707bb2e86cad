// What pictures of one file are made of, found as far as somebody asks for it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/catalogue/catalogue.hpp"
#include "run/plot.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

class PictureFinder {
 public:
  /// References must outlive it.
  PictureFinder(const std::string& path,
                const PlotChoice& choice,
                const AnalyseOptions& options,
                const Clock& clock)
      : path_(path), choice_(choice), options_(options), clock_(clock) {}

  /// Reads the file, with what the choice says of its motion. False iff an error was added.
  bool load(SourceFile& source, Diagnostics& found);

  const MechanismDescription& description() const { return *description_; }

  /// Looks for it once. False if it was not found, with an error the first time. What is wrong with
  /// one is no reason to leave out another.
  bool find(PictureNeed need, Diagnostics& found);

  /// Of what was found.
  PictureSource source() const;

  /// Why the file has no maps of efficiency; empty if it may have some.
  std::string why_no_maps() const;

 private:
  bool apply_to_motion(Diagnostics& found);
  bool solve(PictureNeed need, Diagnostics& found);
  std::optional<Mechanism> bind_mechanism(Diagnostics& found) const;
  bool has_motion(std::string_view instead, Diagnostics& found) const;
  bool find_analysis(Diagnostics& found);
  bool find_motion_of_file(Diagnostics& found);
  bool find_moving(Diagnostics& found);
  bool find_placed(Diagnostics& found);
  bool find_simulated(Diagnostics& found);
  bool find_sweep(Diagnostics& found);
  bool find_maps(Diagnostics& found);
  bool find_benchmark(Diagnostics& found);

  const std::string& path_;
  const PlotChoice& choice_;
  const AnalyseOptions& options_;
  const Clock& clock_;
  SourceFile file_;
  std::optional<MechanismDescription> description_;
  std::array<std::optional<bool>, static_cast<std::size_t>(PictureNeed::maps) + 1>
      is_found_;  ///< by PictureNeed
  std::optional<Analysis> analysis_;
  std::optional<FoundMotion> motion_;
  std::optional<MovingMechanism> moving_;
  std::optional<PlacedMechanism> placed_;
  std::optional<SynthesisAnalysis> synthesis_;
  std::optional<TransmissionAnalysis> transmissions_;
  std::optional<std::vector<BenchmarkedCase>> benchmark_;
  std::optional<MotionTable> simulation_;
  std::optional<SweepTable> sweep_;
  std::optional<std::vector<EfficiencyMap>> maps_;
};

}  // namespace kinestat
