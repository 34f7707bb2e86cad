// Gives every file of the named folders to the fuzz target, in order; none may take a second of the
// processor.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// Of the processor, for a busy machine must not look like a slow program.
constexpr double kLongest = 1.0;  // [s]

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
  const std::clock_t begin = std::clock();
  LLVMFuzzerTestOneInput(data.data(), data.size());
  return static_cast<double>(std::clock() - begin) < kLongest * CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::size_t count = 0;
    for (const std::string& folder : std::vector<std::string>(argv + 1, argv + argc)) {
      for (const std::filesystem::path& path : files_of(folder)) {
        ++count;
        if (!replay(path)) {
          std::fputs("took more than a second of the processor\n", stderr);
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
