#include "io/internal/temporary_file.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "io/internal/descriptor.hpp"

namespace kinestat {

namespace {

// Its length does not depend on the target's name, which may be as long as the system allows.
std::string random_name(bool survives_crash) {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}{}",
                     survives_crash ? kTemporaryPrefix : kPiecePrefix,
                     random(),
                     random(),
                     kTemporaryEnding);
}

int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    if (count == 0) {
      return ENOSPC;
    }
    content.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
  return 0;
}

int rename_with(const std::string& from, const std::string& to, unsigned flags) {
  return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0 ? 0 : errno;
}

}  // namespace

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) {
    return ".";
  }
  return slash == 0 ? "/" : path.substr(0, slash);
}

int sync_folder(const std::string& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot sync folders, and some folders may be written but not read.
  if (!opened.is_open()) {
    return errno == EACCES ? 0 : errno;
  }
  return ::fsync(opened.value()) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : target_(std::move(other.target_)),
      present_(other.present_),
      scratch_(std::move(other.scratch_)),
      survives_crash_(other.survives_crash_),
      path_(std::move(other.path_)),
      place_(std::exchange(other.place_, Place::nowhere)) {}

TemporaryFile::~TemporaryFile() {
  if (place_ == Place::beside || place_ == Place::exchanged) {  // new text, or the one replaced
    ::unlink(path_.c_str());
  }
}

int TemporaryFile::create() {
  constexpr int kAttempts = 16;
  for (int i = 0; i < kAttempts; ++i) {
    path_ = fmt::format(
        "{}/{}", scratch_.empty() ? folder_of(target_) : scratch_, random_name(survives_crash_));
    const int descriptor =
        ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor >= 0 || errno != EEXIST) {
      return descriptor;
    }
  }
  return -1;
}

int TemporaryFile::write(std::string_view content,
                         const std::function<bool(std::string&)>& next_piece) {
  Descriptor file(create());
  if (!file.is_open()) {
    return errno;
  }
  place_ = Place::beside;
  if (const int error = write_all(file.value(), content); error != 0) {
    return error;
  }
  std::string piece;
  while (next_piece && next_piece(piece)) {
    if (const int error = write_all(file.value(), piece); error != 0) {
      return error;
    }
  }
  return (!survives_crash_ || ::fsync(file.value()) == 0) && file.close() ? 0 : errno;
}

int TemporaryFile::take_place() {
  const bool is_file = present_ == Present::file;
  const int error = rename_with(path_, target_, is_file ? RENAME_EXCHANGE : RENAME_NOREPLACE);
  if (error == 0) {
    place_ = is_file ? Place::exchanged : Place::moved;
    return 0;
  }
  if (error != EINVAL && error != ENOSYS) {
    return error;
  }
  // A file system that knows plain renames only: what is replaced cannot be brought back.
  if (::rename(path_.c_str(), target_.c_str()) != 0) {
    return errno;
  }
  place_ = is_file ? Place::moved_for_good : Place::moved;
  return 0;
}

void TemporaryFile::give_back() {
  if (place_ == Place::exchanged && rename_with(path_, target_, RENAME_EXCHANGE) == 0) {
    place_ = Place::beside;
  } else if (place_ == Place::moved && ::unlink(target_.c_str()) == 0) {
    place_ = Place::nowhere;
  }
}

}  // namespace kinestat
