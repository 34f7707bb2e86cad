#include "io/stored_chunk.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// What reading finds in a file of these bytes; tests that run side by side have one each.
RecordState state_of(const std::string& text, const std::string& plan, StoredChunk& record) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = (std::filesystem::path(testing::TempDir()) / (name + ".txt")).string();
  std::ofstream(path, std::ios::binary) << text;
  const RecordState state = RecordFile(path).read_record(plan, record);
  std::remove(path.c_str());
  return state;
}

// By `printf abc | xxhsum -H3`, likewise nothing and a thousand zero bytes, which take another way.
TEST(HashOf, IsThatOfTheProgramOfItsAuthors) {
  EXPECT_EQ(hash_of(""), "2d06800538d394c2");
  EXPECT_EQ(hash_of("abc"), "78af5f94892f3950");
  EXPECT_EQ(hash_of(std::string(1000, '\0')), "24c1ea6074dd588c");
}

TEST(StoredChunk, ComesBackAsItWasWritten) {
  const StoredChunk written{.index = 7, .note = "two rows", .body = "a,b\n1,2\n"};
  StoredChunk read;

  EXPECT_EQ(state_of(write_record(written, "plan"), "plan", read), RecordState::whole);
  EXPECT_EQ(read.index, 7U);
  EXPECT_EQ(read.note, "two rows");
  EXPECT_EQ(read.body, written.body);
}

TEST(StoredChunk, ShowsEveryByteThatChanged) {
  const std::string text =
      write_record({.index = 7, .note = "two rows", .body = "a,b\n1,2\n"}, "plan");
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    StoredChunk read;
    EXPECT_NE(state_of(changed, "plan", read), RecordState::whole) << "byte " << i;
  }
}

TEST(StoredChunk, SaysOfAnotherPlanAndOfAnEndThatComesEarly) {
  const std::string text = write_record({.index = 0, .note = "n", .body = "12345"}, "plan");
  StoredChunk read;

  EXPECT_EQ(state_of(text, "other", read), RecordState::foreign);
  EXPECT_EQ(state_of(text.substr(0, text.size() - 1), "plan", read), RecordState::truncated);
  EXPECT_EQ(state_of("", "plan", read), RecordState::end);
}

}  // namespace
}  // namespace kinestat
