// A search that keeps what it has finished in a folder, to go on after an interruption and to share
// the work.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/work_folder.hpp"
#include "studies/transmissions/search.hpp"

namespace kinestat {

/// One file a structure, <stem>.structure-00000012.found, written whole. Several processes may work
/// in one folder: what two of them find of a structure has the same bytes. What killed ones left of
/// files that they were writing is removed by the next that comes alone.
class StoredSearch {
 public:
  /// What decides the result is the description, with its task ranked so, and the version.
  StoredSearch(std::string folder,
               std::string stem,
               const MechanismDescription& description,
               TransmissionRank rank);

  /// False iff an error was added: the folder is not there, or it holds what another task has
  /// found.
  bool prepare(Diagnostics& found);

  SearchStore store();

  /// Complains about what could not be written.
  void tell(Diagnostics& found) const;

 private:
  std::string path_of(std::size_t structure) const;
  std::optional<TransmissionSearch> find(std::size_t structure) const;
  void keep(std::size_t structure, const TransmissionSearch& search);

  std::string folder_;
  std::optional<SharedFolder> shared_;
  std::string stem_;
  std::string plan_;
  std::mutex mutex_;
  Diagnostics failures_;
};

}  // namespace kinestat
