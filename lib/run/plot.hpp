// Single pictures of a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_options.hpp"
#include "studies/benchmark/interleaved_times.hpp"

namespace kinestat {

/// What a picture is written as.
enum class PictureForm { svg, dot, gnuplot };

struct PlotChoice {
  std::string picture;               ///< a name of the catalogue, or `kListPictures`
  std::string case_label;            ///< empty: all cases or, for pictures of one, the first
  std::vector<std::string> at = {};  ///< positions of the drive in which the mechanism is drawn
  std::optional<std::string> drive = {};  ///< the actuator that drives, before what the file says
  std::vector<std::string> report = {};   ///< of charts of a motion, before what the file says
  std::string over = {};  ///< the column over which charts of a motion stand; empty: the usual one
  PictureForm form = PictureForm::svg;
  std::string path;  ///< of the file to write; empty: standard output
  Overwrite overwrite = Overwrite::own_only;
};

/// Instead of a picture: a table of all pictures that says which ones the file has.
inline constexpr std::string_view kListPictures = "list";

/// The names of all pictures.
std::vector<std::string> picture_names();

/// A line for each picture: its name and what it shows.
std::string picture_help();

/// The picture of one file. An unknown picture, or a form that it does not have, is wrong use of
/// the command line; a file that lacks what it shows is E0909. `clock` is asked only for the
/// comparison of methods.
Outcome plot_file(const std::string& path,
                  const PlotChoice& choice,
                  const AnalyseOptions& options,
                  const Clock& clock);

}  // namespace kinestat
