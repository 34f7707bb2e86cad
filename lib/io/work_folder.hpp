// The folder in which a long run keeps what it has finished, locked against a second process.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"

namespace kinestat {

/// Holds the lock until it goes out of scope; the system frees it even if the process is killed.
class WorkFolder {
 public:
  /// Makes the folder if it is not there, and locks it; also removes temporaries that a killed
  /// process left in it. Empty iff an error was added: E0152, also if another process holds it.
  static std::optional<WorkFolder> open(const std::string& path, Diagnostics& found);

  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();

  const std::string& path() const { return path_; }

  /// The names of the files in it, the lock excepted, in order.
  std::vector<std::string> files() const;

  /// Removes all files in it, the lock excepted.
  void clear() const;

  /// Removes the folder with all that this class put into it; the lock ends.
  void remove();

 private:
  WorkFolder(std::string path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::string path_;
  int lock_ = -1;
};

/// Whether there is such a folder, so that it may hold something of an earlier run.
bool is_work_folder(const std::string& path);

}  // namespace kinestat
