#include "io/work_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "io/internal/refuse_writing.hpp"
#include "io/internal/temporary_file.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kLockName = "lock";

std::string lock_path(const std::string& folder) {
  return fmt::format("{}/{}", folder, kLockName);
}

// Whether the descriptor is still the file of that path: who finishes a run removes the folder.
bool is_current(int descriptor, const std::string& path) {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

bool is_temporary(std::string_view name, std::string_view prefix = kTemporaryPrefix) {
  return name.starts_with(prefix) && name.ends_with(kTemporaryEnding);
}

// What stands in a folder, the lock excepted, in order; nothing if there is no folder.
std::vector<std::string> names_in(const std::string& path) {
  std::vector<std::string> names;
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir(path.c_str()), ::closedir);
  while (const dirent* entry = folder ? ::readdir(folder.get()) : nullptr) {
    const std::string name = entry->d_name;
    if (name != "." && name != ".." && name != kLockName) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

void remove_temporaries(const std::string& path, std::string_view prefix) {
  for (const std::string& name : names_in(path)) {
    if (is_temporary(name, prefix)) {
      ::unlink(fmt::format("{}/{}", path, name).c_str());
    }
  }
}

bool has_nothing_else(const std::string& path, WorkFolder::IsOwn is_own, Diagnostics& found) {
  const std::vector<std::string> names = names_in(path);
  const auto foreign = std::ranges::find_if(
      names, [&](const std::string& name) { return !is_own(name) && !is_temporary(name); });
  if (foreign == names.end()) {
    return true;
  }
  found.error("E0153",
              {},
              fmt::format("'{}/{}' exists and was not written by this program", path, *foreign),
              fmt::format("move it elsewhere, as '{}' is removed when the run has finished; or "
                          "choose another folder for --out",
                          path));
  return false;
}

}  // namespace

std::optional<WorkFolder> WorkFolder::open(const std::string& path,
                                           IsOwn is_own,
                                           Diagnostics& found) {
  if (!has_nothing_else(path, is_own, found)) {
    return std::nullopt;
  }
  constexpr int kAttempts = 16;
  for (int i = 0; i < kAttempts; ++i) {
    if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) {
      refuse_writing(path, errno, found);
      return std::nullopt;
    }
    const std::string lock = lock_path(path);
    const int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0) {
      if (errno == ENOENT) {
        continue;  // removed in between by the process that finished
      }
      refuse_writing(lock, errno, found);
      return std::nullopt;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      ::close(descriptor);
      if (error != EWOULDBLOCK) {
        refuse_writing(lock, error, found);
        return std::nullopt;
      }
      found.error("E0152",
                  {},
                  fmt::format("another process is at work on '{}'", path),
                  "wait until it has finished, or choose another folder for --out");
      return std::nullopt;
    }
    if (!is_current(descriptor, lock)) {
      ::close(descriptor);
      continue;
    }
    WorkFolder folder(path, is_own, descriptor);
    remove_temporaries(path, kTemporaryPrefix);
    return folder;
  }
  refuse_writing(path, EAGAIN, found);
  return std::nullopt;
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::move(other.path_)),
      is_own_(other.is_own_),
      lock_(std::exchange(other.lock_, -1)) {}

WorkFolder::~WorkFolder() {
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

std::vector<std::string> WorkFolder::files() const {
  std::vector<std::string> names = names_in(path_);
  std::erase_if(names, [&](const std::string& name) { return !is_own_(name); });
  return names;
}

void WorkFolder::clear() const {
  for (const std::string& name : files()) {
    ::unlink(fmt::format("{}/{}", path_, name).c_str());
  }
}

// The lock goes last, so that nobody takes a folder that is about to vanish for a free one.
void WorkFolder::remove() {
  clear();
  ::unlink(lock_path(path_).c_str());
  ::rmdir(path_.c_str());
  ::close(std::exchange(lock_, -1));
}

SharedFolder::SharedFolder(const std::string& path)
    : lock_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) == 0) {
    remove_temporaries(path, kPiecePrefix);
  }
  if (lock_ >= 0) {
    ::flock(lock_, LOCK_SH);
  }
}

SharedFolder::~SharedFolder() {
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

bool is_work_folder(const std::string& path) {
  struct stat status = {};
  return ::stat(lock_path(path).c_str(), &status) == 0;
}

}  // namespace kinestat
