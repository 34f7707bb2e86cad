#include "io/work_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

class SharedFolders : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = std::filesystem::temp_directory_path() / "kinestat-XXXXXX";
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    path_ = pattern;
    std::ofstream(piece()) << "torn";
  }

  void TearDown() override { std::filesystem::remove_all(path_); }

  std::string piece() const { return path_ + "/.kinestat-piece-0123456789abcdef.tmp"; }

  std::string path_;
};

TEST_F(SharedFolders, AreClearedOfTornPiecesByWhoComesAlone) {
  const std::string other = path_ + "/.kinestat-0123456789abcdef.tmp";
  std::ofstream(other) << "of another command";
  const SharedFolder alone(path_);
  EXPECT_FALSE(std::filesystem::exists(piece()));
  EXPECT_TRUE(std::filesystem::exists(other));
}

TEST_F(SharedFolders, KeepWhatOthersMayBeWriting) {
  {
    const SharedFolder first(path_);
    std::ofstream(piece()) << "on its way";
    const SharedFolder second(path_);
    EXPECT_TRUE(std::filesystem::exists(piece()));
  }
  const SharedFolder third(path_);
  EXPECT_FALSE(std::filesystem::exists(piece()));
}

TEST_F(SharedFolders, NeedNotBeThere) {
  const SharedFolder nowhere(path_ + "/nowhere");
  EXPECT_TRUE(std::filesystem::exists(piece()));
}

}  // namespace
}  // namespace kinestat
