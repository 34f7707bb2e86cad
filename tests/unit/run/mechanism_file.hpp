// A four-bar linkage in a file of its own, removed with the object.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {

/// Writes the linkage with the given section `cases` into a fresh folder.
class MechanismFile {
 public:
  explicit MechanismFile(const std::string& cases) {
    std::string pattern = testing::TempDir() + "/kinestat-run-XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary folder");
    }
    folder_ = pattern;
    std::ofstream(path()) << "kinestat: 1\n"
                             "space: planar\n"
                             "ground: frame\n"
                             "bodies: [crank, coupler, rocker]\n"
                             "couplings:\n"
                             "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
                             "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}\n"
                             "  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}\n"
                             "  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}\n"
                             "actuators:\n"
                             "  drive: {coupling: a}\n"
                             "  load: {coupling: d}\n"
                             "cases:\n"
                          << cases;
  }

  ~MechanismFile() { std::filesystem::remove_all(folder_); }

  MechanismFile(const MechanismFile&) = delete;
  MechanismFile& operator=(const MechanismFile&) = delete;

  const std::string& folder() const { return folder_; }

  std::string path() const { return folder_ + "/four_bar.yaml"; }

 private:
  std::string folder_;
};

}  // namespace kinestat
