// The mechanism files of the library, as values of parameterised tests.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {

inline const std::filesystem::path kLibraryFolder =
    std::filesystem::path(KINESTAT_SOURCE_DIR) / "mechanisms";

/// Relative to the folder, in order; without the one that can only be counted, as its couplings
/// have no places and so no geometry, and without the synthesis tasks, which hold no mechanism.
inline std::vector<std::string> list_library_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kLibraryFolder)) {
    const std::string name = std::filesystem::relative(entry.path(), kLibraryFolder).string();
    if (entry.path().extension() == ".yaml" && name != "cables/surgical_instrument.yaml" &&
        !name.starts_with("synthesis/")) {
      files.push_back(name);
    }
  }
  std::ranges::sort(files);
  return files;
}

/// GoogleTest allows letters, digits and underscores.
inline std::string library_test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace kinestat
