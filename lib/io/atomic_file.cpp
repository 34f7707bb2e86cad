#include "io/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "io/internal/descriptor.hpp"
#include "io/internal/refuse_writing.hpp"
#include "io/internal/temporary_file.hpp"

namespace kinestat {

namespace {

bool begins_with(const std::string& path, std::string_view signature) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  std::string beginning(signature.size(), '\0');
  std::size_t size = 0;
  while (file.is_open() && size < beginning.size()) {
    const ssize_t count = ::read(file.value(), beginning.data() + size, beginning.size() - size);
    if (count <= 0) {
      break;
    }
    size += static_cast<std::size_t>(count);
  }
  return !signature.empty() && size == signature.size() && beginning == signature;
}

// Read through a symbolic link, because that is what the user sees as the file.
bool is_own(const OutputFile& file) {
  struct stat status = {};
  return ::stat(file.path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         begins_with(file.path, file.signature);
}

// By whatever path: a link is an input where it is named, and where it leads to.
bool is_input(const struct stat& status, InputPaths inputs) {
  return std::ranges::any_of(inputs, [&](const std::string& path) {
    struct stat named = {};
    struct stat meant = {};
    const auto is_it = [&](const struct stat& one) {
      return one.st_dev == status.st_dev && one.st_ino == status.st_ino;
    };
    return path != "-" && ((::lstat(path.c_str(), &named) == 0 && is_it(named)) ||
                           (::stat(path.c_str(), &meant) == 0 && is_it(meant)));
  });
}

// What stands at the target, if it may be replaced.
std::optional<Present> find_present(const OutputFile& file,
                                    Overwrite overwrite,
                                    InputPaths inputs,
                                    Diagnostics& found) {
  struct stat status = {};
  if (::lstat(file.path.c_str(), &status) != 0) {
    if (errno != ENOENT) {
      refuse_writing(file.path, errno, found);
      return {};
    }
    return Present::nothing;
  }
  if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) {
    refuse_writing(file.path,
                   S_ISDIR(status.st_mode) ? "it is a folder" : "it is not an ordinary file",
                   found);
    return {};
  }
  if (is_input(status, inputs)) {
    found.error("E0153",
                {},
                fmt::format("'{}' is read by this command, and stays as it is", file.path),
                "choose another name");
    return {};
  }
  if (overwrite == Overwrite::own_only && !is_own(file)) {
    found.error("E0153",
                {},
                fmt::format("'{}' exists and was not written by this program", file.path),
                "choose another name, or give --force to replace it");
    return {};
  }
  return Present::file;
}

// All complaints about the targets, before anything is written.
std::vector<TemporaryFile> plan_files(std::span<const OutputFile> files,
                                      Overwrite overwrite,
                                      InputPaths inputs,
                                      Diagnostics& found) {
  std::vector<TemporaryFile> plan;
  plan.reserve(files.size());
  for (const OutputFile& file : files) {
    if (const auto present = find_present(file, overwrite, inputs, found)) {
      plan.push_back(TemporaryFile(file.path, *present, file.scratch, file.survives_crash));
    }
  }
  return plan;
}

// True when all stand in their places, and the folders know it.
bool take_places(std::vector<TemporaryFile>& plan, Diagnostics& found) {
  for (TemporaryFile& file : plan) {
    if (const int error = file.take_place(); error != 0) {
      refuse_writing(file.target(), error, found);
      return false;
    }
  }
  for (const TemporaryFile& file : plan) {
    const int error = file.survives_crash() ? sync_folder(folder_of(file.target())) : 0;
    if (error != 0) {
      refuse_writing(file.target(), error, found);
      return false;
    }
  }
  return true;
}

}  // namespace

bool write_files(std::span<const OutputFile> files,
                 Overwrite overwrite,
                 InputPaths inputs,
                 Diagnostics& found) {
  std::vector<TemporaryFile> plan = plan_files(files, overwrite, inputs, found);
  if (plan.size() < files.size()) {
    return false;
  }
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (const int error = plan[i].write(files[i].content, files[i].next_piece); error != 0) {
      refuse_writing(plan[i].target(), error, found);
      return false;
    }
  }
  if (take_places(plan, found)) {
    return true;
  }
  // Backwards, in case two of them have one target.
  std::for_each(plan.rbegin(), plan.rend(), [](TemporaryFile& file) { file.give_back(); });
  return false;
}

bool check_places(std::span<const OutputFile> files,
                  Overwrite overwrite,
                  InputPaths inputs,
                  Diagnostics& found) {
  return plan_files(files, overwrite, inputs, found).size() == files.size();
}

namespace {

// What to do where there is no such folder. Who names it like a file may want one.
std::string hint_on_missing(const std::string& folder) {
  const std::string make = fmt::format("mkdir -p '{}'", folder);
  return std::filesystem::path(folder).has_extension()
             ? fmt::format("--out names a folder: {}; for one file write > '{}' in place of --out",
                           make,
                           folder)
             : make;
}

}  // namespace

bool check_output_folder(const std::string& folder, Diagnostics& found) {
  const std::string path = folder.empty() ? "." : folder;
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    const int error = errno;
    found.error("E0152",
                {},
                fmt::format("output folder '{}': {}", path, std::generic_category().message(error)),
                error == ENOENT ? hint_on_missing(path) : "");
    return false;
  }
  if (!S_ISDIR(status.st_mode)) {
    found.error("E0152",
                {},
                fmt::format("output folder '{}' is not a folder", path),
                "name a folder, or remove the file");
    return false;
  }
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    found.error("E0152",
                {},
                fmt::format("output folder '{}' may not be written to: {}",
                            path,
                            std::generic_category().message(errno)),
                "choose another folder");
    return false;
  }
  return true;
}

}  // namespace kinestat
