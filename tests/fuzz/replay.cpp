// Gives every file of the named folders to the fuzz target, in order; none may take a second.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest(1);

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

// Whether the target came back in time. A broken invariant ends the process.
bool replay(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);
  const Clock::time_point begin = Clock::now();
  LLVMFuzzerTestOneInput(data.data(), data.size());
  return Clock::now() - begin < kLongest;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::size_t count = 0;
    for (const std::string& folder : std::vector<std::string>(argv + 1, argv + argc)) {
      for (const std::filesystem::path& path : files_of(folder)) {
        ++count;
        if (!replay(path)) {
          std::fputs("took longer than a second\n", stderr);
          return 1;
        }
      }
    }
    return count > 0 ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
