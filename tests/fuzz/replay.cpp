// Gives every file of the named folders to the fuzz target, in order; none may take a second of the
// processor. With --random SEED MINUTES FILE as many random inputs as fit, each of which is put
// into FILE first, so that it is there if the target does not come back.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// Of the processor, for a busy machine must not look like a slow program.
constexpr double kLongest = KINESTAT_LONGEST_SECONDS;

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

std::vector<std::uint8_t> random_bytes(std::mt19937_64& source) {
  constexpr std::array<std::size_t, 4> kSizes = {8, 12, 16, 24};
  std::vector<std::uint8_t> bytes(kSizes[source() % kSizes.size()]);
  std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(source() >> 56U); });
  return bytes;
}

int run_randomly(std::uint64_t seed, double minutes, const char* current) {
  std::mt19937_64 source(seed);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(60 * minutes);
  for (std::uint64_t runs = 1; std::chrono::steady_clock::now() < end; ++runs) {
    const std::vector<std::uint8_t> bytes = random_bytes(source);
    std::ofstream(current, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),  // NOLINT: bytes are bytes
               static_cast<std::streamsize>(bytes.size()));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    std::printf("%llu\n", static_cast<unsigned long long>(runs));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 5 && std::string_view(argv[1]) == "--random") {
      return run_randomly(std::stoull(argv[2]), std::stod(argv[3]), argv[4]);
    }
    std::size_t count = 0;
    for (const std::string& folder : std::vector<std::string>(argv + 1, argv + argc)) {
      for (const std::filesystem::path& path : files_of(folder)) {
        ++count;
        if (!replay(path)) {
          std::fprintf(stderr, "took more than %g s of the processor\n", kLongest);
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
