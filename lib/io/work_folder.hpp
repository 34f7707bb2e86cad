// The folder in which a long run keeps what it has finished, locked against a second process.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"

namespace kinestat {

/// Holds the lock until it goes out of scope; the system frees it even if the process is killed.
class WorkFolder {
 public:
  /// Whether a file of this name is the run's own.
  using IsOwn = bool (*)(std::string_view name);

  /// Makes the folder if it is not there, and locks it; also removes temporaries that a killed
  /// process left in it. Empty iff an error was added: E0152, also if another process holds it, or
  /// E0153 if there is something else in it, which this class never touches.
  static std::optional<WorkFolder> open(const std::string& path, IsOwn is_own, Diagnostics& found);

  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();

  const std::string& path() const { return path_; }

  /// The names of the run's own files in it, in order.
  std::vector<std::string> files() const;

  /// Removes these files.
  void clear() const;

  /// Removes the folder with these files, unless there is something else in it; the lock ends.
  void remove();

 private:
  WorkFolder(std::string path, IsOwn is_own, int lock)
      : path_(std::move(path)), is_own_(is_own), lock_(lock) {}

  std::string path_;
  IsOwn is_own_;
  int lock_ = -1;
};

/// A folder in which several processes may keep what they have finished, each file by itself. Who
/// comes to it alone removes the temporaries of pieces that killed processes left; until it goes
/// out of scope others do not. On file systems that cannot lock a folder nothing is removed.
class SharedFolder {
 public:
  explicit SharedFolder(const std::string& path);

  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;
  SharedFolder(SharedFolder&&) = delete;
  SharedFolder& operator=(SharedFolder&&) = delete;
  ~SharedFolder();

 private:
  int lock_ = -1;
};

/// Whether there is such a folder, so that it may hold something of an earlier run.
bool is_work_folder(const std::string& path);

}  // namespace kinestat
