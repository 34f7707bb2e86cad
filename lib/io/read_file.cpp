#include "io/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <limits>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "io/internal/descriptor.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kStandardInput = "-";

std::string shown(const std::string& path) {
  return path == kStandardInput ? "standard input" : fmt::format("'{}'", path);
}

void refuse_reading(const std::string& path, int error, Diagnostics& found) {
  found.error(
      "E0151",
      {},
      fmt::format("cannot read {}: {}", shown(path), std::generic_category().message(error)),
      error == ENOENT ? "check the path and the working folder" : "");
}

void refuse_size(const std::string& path,
                 std::string_view size,
                 const ReadLimits& limits,
                 Diagnostics& found) {
  found.error(
      "E0201",
      {},
      fmt::format("{} is {}, the limit is {} bytes", shown(path), size, limits.bytes),
      "check the file name; a mechanism file is a few kilobytes. --max-file-size 100M reads "
      "larger ones");
}

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) {
    return "a folder";
  }
  return S_ISFIFO(mode) || S_ISSOCK(mode) ? "a pipe or socket" : "a device";
}

bool is_regular(const std::string& path, const struct stat& status, Diagnostics& found) {
  if (S_ISREG(status.st_mode)) {
    return true;
  }
  found.error(
      "E0151",
      {},
      fmt::format("cannot read {}: it is {}, not a file", shown(path), kind_of(status.st_mode)),
      S_ISDIR(status.st_mode) ? "name the files in it" : "give '-' to read standard input");
  return false;
}

// All bytes up to one more than the limit, by which an excess is seen.
std::optional<std::string> read_bytes(int descriptor, std::size_t limit, int& error) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  std::string text;
  while (text.size() <= limit) {
    const std::size_t begin = text.size();
    text.resize(begin + std::min(kBlock, limit + 1 - begin));
    const ssize_t count = ::read(descriptor, text.data() + begin, text.size() - begin);
    if (count < 0 && errno != EINTR) {
      error = errno;
      return {};
    }
    text.resize(begin + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count == 0) {
      break;
    }
  }
  return text;
}

std::optional<SourceFile> read_open(int descriptor,
                                    const std::string& path,
                                    const ReadLimits& limits,
                                    Diagnostics& found) {
  int error = 0;
  std::optional<std::string> text = read_bytes(descriptor, limits.bytes, error);
  if (!text) {
    refuse_reading(path, error, found);
    return {};
  }
  if (text->size() > limits.bytes) {
    refuse_size(path, "too large", limits, found);
    return {};
  }
  return SourceFile{path, std::move(*text)};
}

}  // namespace

ReadLimits ReadLimits::for_size(std::size_t bytes) {
  const ReadLimits usual;
  const double nodes = static_cast<double>(bytes) / static_cast<double>(usual.bytes) * usual.nodes;
  ReadLimits limits;
  limits.bytes = bytes;
  limits.nodes =
      static_cast<int>(std::clamp<double>(nodes, usual.nodes, std::numeric_limits<int>::max()));
  return limits;
}

std::optional<SourceFile> read_file(const std::string& path,
                                    const ReadLimits& limits,
                                    Diagnostics& found) {
  if (path == kStandardInput) {
    return read_open(STDIN_FILENO, path, limits, found);
  }
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    refuse_reading(path, errno, found);
    return {};
  }
  // The first look keeps devices from being opened at all; the second is on what was opened.
  if (!is_regular(path, status, found)) {
    return {};
  }
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.is_open() || ::fstat(file.value(), &status) != 0) {
    refuse_reading(path, errno, found);
    return {};
  }
  if (!is_regular(path, status, found)) {
    return {};
  }
  if (static_cast<std::size_t>(status.st_size) > limits.bytes) {
    refuse_size(path, fmt::format("{} bytes", status.st_size), limits, found);
    return {};
  }
  return read_open(file.value(), path, limits, found);
}

}  // namespace kinestat
