#include "io/read_file.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// A folder of its own for each test, removed afterwards.
class ReadFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "/kinestat-read-XXXXXX";
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  std::string make_file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  // The one diagnostic of a read that must fail.
  Diagnostic refusal(const std::string& file, const ReadLimits& limits = {}) const {
    Diagnostics found;
    EXPECT_FALSE(read_file(file, limits, found).has_value());
    EXPECT_EQ(found.error_count(), 1);
    return found.items().empty() ? Diagnostic{} : found.items()[0];
  }

  std::string folder_;
};

// Standard input is another file as long as this lives.
class StandardInput {
 public:
  explicit StandardInput(int descriptor) : saved_(::dup(STDIN_FILENO)) {
    ::dup2(descriptor, STDIN_FILENO);
  }

  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

  ~StandardInput() {
    ::dup2(saved_, STDIN_FILENO);
    ::close(saved_);
  }

 private:
  int saved_ = -1;
};

TEST_F(ReadFile, KeepsThePathAndEveryByte) {
  const std::string text("a\0\r\n\xFF", 5);
  const std::string file = make_file("x.yaml", text);
  Diagnostics found;

  const auto source = read_file(file, {}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->path, file);
  EXPECT_EQ(source->text, text);
  EXPECT_FALSE(found.has_errors());
}

TEST_F(ReadFile, ReadsAnEmptyFile) {
  Diagnostics found;

  const auto source = read_file(make_file("x.yaml", ""), {}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->text, "");
}

TEST_F(ReadFile, AcceptsAnyBytesInAName) {
  const std::string file = make_file("-a %s\n\xFF.yaml", "text");
  Diagnostics found;

  const auto source = read_file(file, {}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->text, "text");
}

TEST_F(ReadFile, FollowsASymbolicLink) {
  make_file("x.yaml", "text");
  std::filesystem::create_symlink("x.yaml", path("link.yaml"));
  Diagnostics found;

  const auto source = read_file(path("link.yaml"), {}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->text, "text");
}

TEST_F(ReadFile, NamesAMissingFileAndTheReason) {
  const Diagnostic item = refusal(path("missing.yaml"));

  EXPECT_EQ(item.code, "E0151");
  EXPECT_EQ(item.where, SourceRange{});
  EXPECT_EQ(item.message, "cannot read '" + path("missing.yaml") + "': No such file or directory");
}

TEST_F(ReadFile, EscapesStrangeBytesInAMessage) {
  EXPECT_NE(refusal(path("a\nb\xFF")).message.find("a\\x0Ab\\xFF'"), std::string::npos);
}

TEST_F(ReadFile, RefusesAPathThroughAFile) {
  make_file("x.yaml", "");

  const Diagnostic item = refusal(path("x.yaml/y.yaml"));

  EXPECT_EQ(item.code, "E0151");
  EXPECT_NE(item.message.find("Not a directory"), std::string::npos);
}

TEST_F(ReadFile, RefusesTheEmptyPath) {
  EXPECT_EQ(refusal("").code, "E0151");
}

TEST_F(ReadFile, RefusesAFolder) {
  const Diagnostic item = refusal(folder_);

  EXPECT_EQ(item.code, "E0151");
  EXPECT_NE(item.message.find("it is a folder"), std::string::npos);
}

TEST_F(ReadFile, RefusesAPipeWithoutWaitingForAWriter) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);

  const Diagnostic item = refusal(path("pipe"));

  EXPECT_EQ(item.code, "E0151");
  EXPECT_NE(item.message.find("it is a pipe"), std::string::npos);
  EXPECT_EQ(item.hint, "give '-' to read standard input");
}

TEST_F(ReadFile, RefusesADevice) {
  const Diagnostic item = refusal("/dev/zero");

  EXPECT_EQ(item.code, "E0151");
  EXPECT_NE(item.message.find("it is a device"), std::string::npos);
}

TEST_F(ReadFile, SaysWhyAFileMayNotBeRead) {
  const std::string file = make_file("x.yaml", "text");
  ASSERT_EQ(::chmod(file.c_str(), 0), 0);
  ASSERT_EQ(::chmod(folder_.c_str(), 0755), 0);
  // Permissions bind root only after it has become somebody else.
  const bool is_root = ::geteuid() == 0;
  if (is_root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }

  const Diagnostic item = refusal(file);

  if (is_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(item.code, "E0151");
  EXPECT_NE(item.message.find("Permission denied"), std::string::npos);
}

TEST_F(ReadFile, AcceptsAFileAsLargeAsTheLimit) {
  Diagnostics found;

  const auto source = read_file(make_file("x.yaml", std::string(10, 'x')), {.bytes = 10}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->text.size(), 10U);
}

TEST_F(ReadFile, NamesSizeAndLimitOfALargeFile) {
  const std::string file = make_file("x.yaml", std::string(11, 'x'));

  const Diagnostic item = refusal(file, {.bytes = 10});

  EXPECT_EQ(item.code, "E0201");
  EXPECT_EQ(item.message, "'" + file + "' is 11 bytes, the limit is 10 bytes");
}

TEST_F(ReadFile, LimitsAFileToOneMebibyteByDefault) {
  const std::string file = make_file("x.yaml", "");
  std::filesystem::resize_file(file, 1024 * 1024 + 1);

  EXPECT_EQ(refusal(file).code, "E0201");
}

TEST_F(ReadFile, ReadsStandardInput) {
  const int file = ::open(make_file("x.yaml", "text").c_str(), O_RDONLY);
  const StandardInput input(file);
  ::close(file);
  Diagnostics found;

  const auto source = read_file("-", {}, found);

  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->path, "-");
  EXPECT_EQ(source->text, "text");
}

TEST_F(ReadFile, ReadsAPipeOnStandardInputToItsEnd) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(::pipe(ends), 0);
  const StandardInput input(ends[0]);
  const std::string text(300000, 'x');  // more than a pipe holds
  std::thread writer([&] {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = ::write(ends[1], text.data() + at, text.size() - at);
      at += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    ::close(ends[1]);
  });
  Diagnostics found;

  const auto source = read_file("-", {}, found);

  writer.join();
  ::close(ends[0]);
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(source->text, text);
}

TEST_F(ReadFile, StopsAtTheLimitOfEndlessStandardInput) {
  const int endless = ::open("/dev/zero", O_RDONLY);
  const StandardInput input(endless);
  ::close(endless);

  const Diagnostic item = refusal("-", {.bytes = 1000});

  EXPECT_EQ(item.code, "E0201");
  EXPECT_EQ(item.message, "standard input is too large, the limit is 1000 bytes");
}

TEST_F(ReadFile, SaysThatStandardInputIsAFolder) {
  const int folder = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY);
  const StandardInput input(folder);
  ::close(folder);

  const Diagnostic item = refusal("-");

  EXPECT_EQ(item.code, "E0151");
  EXPECT_EQ(item.message, "cannot read standard input: Is a directory");
}

}  // namespace
}  // namespace kinestat
