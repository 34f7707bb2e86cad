#include "io/atomic_file.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr const char* kSignature = "{\"kinestat\"";

// A folder of its own for each test, removed afterwards.
class WriteFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "/kinestat-write-XXXXXX";
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  OutputFile output(const std::string& name, const std::string& content) const {
    return {.path = path(name), .content = content, .signature = kSignature};
  }

  std::string make_file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  std::string text_of(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      result.insert(entry.path().filename());
    }
    return result;
  }

  // The one diagnostic of a writing that must fail.
  Diagnostic refusal(const std::vector<OutputFile>& files,
                     Overwrite overwrite = Overwrite::own_only) const {
    Diagnostics found;
    EXPECT_FALSE(write_files(files, overwrite, {}, found));
    EXPECT_EQ(found.error_count(), 1);
    return found.items().empty() ? Diagnostic{} : found.items()[0];
  }

  bool write(const std::vector<OutputFile>& files,
             Overwrite overwrite = Overwrite::own_only) const {
    Diagnostics found;
    const bool is_done = write_files(files, overwrite, {}, found);
    EXPECT_EQ(is_done, !found.has_errors());
    return is_done;
  }

  std::string folder_;
};

using Names = std::set<std::string>;

TEST_F(WriteFiles, WritesEveryByteAndLeavesNothingElse) {
  const std::string bytes("a\0\r\n\xFF", 5);

  ASSERT_TRUE(write({output("a.json", bytes), output("b.csv", "b")}));

  EXPECT_EQ(text_of("a.json"), bytes);
  EXPECT_EQ(text_of("b.csv"), "b");
  EXPECT_EQ(names(), (Names{"a.json", "b.csv"}));
}

TEST_F(WriteFiles, WritesAnEmptyFile) {
  ASSERT_TRUE(write({output("a.csv", "")}));

  EXPECT_EQ(names(), Names{"a.csv"});
}

TEST_F(WriteFiles, AcceptsTheLongestNameOfTheSystem) {
  const std::string name(255, 'x');

  ASSERT_TRUE(write({output(name, "text")}));

  EXPECT_EQ(text_of(name), "text");
}

TEST_F(WriteFiles, ReplacesItsOwnReport) {
  make_file("a.json", "{\"kinestat\": {old and longer}}");

  ASSERT_TRUE(write({output("a.json", "new")}));

  EXPECT_EQ(text_of("a.json"), "new");
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WriteFiles, LeavesAForeignFileAsItIs) {
  make_file("a.json", "{\"other\": 1}");

  const Diagnostic item = refusal({output("a.json", "new")});

  EXPECT_EQ(item.code, "E0153");
  EXPECT_EQ(item.message, "'" + path("a.json") + "' exists and was not written by this program");
  EXPECT_NE(item.hint.find("--force"), std::string::npos);
  EXPECT_EQ(text_of("a.json"), "{\"other\": 1}");
}

TEST_F(WriteFiles, TakesAFileShorterThanTheSignatureForForeign) {
  make_file("a.json", "{\"kine");

  EXPECT_EQ(refusal({output("a.json", "new")}).code, "E0153");
}

TEST_F(WriteFiles, TakesEveryFileForForeignWithoutASignature) {
  make_file("a.svg", "");

  EXPECT_EQ(refusal({{.path = path("a.svg"), .content = "new", .signature = ""}}).code, "E0153");
}

TEST_F(WriteFiles, ReplacesAForeignFileWhenForced) {
  make_file("a.json", "{\"other\": 1}");

  ASSERT_TRUE(write({output("a.json", "new")}, Overwrite::force));

  EXPECT_EQ(text_of("a.json"), "new");
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WriteFiles, ReplacesNoInputByWhateverPath) {
  const std::string input = make_file("a.yaml", "input");
  std::filesystem::create_symlink(input, path("link.yaml"));

  for (const std::string& named : {path("a.yaml"), path("./a.yaml"), path("link.yaml")}) {
    const std::vector<std::string> inputs = {"-", path("absent.yaml"), named};
    Diagnostics found;
    EXPECT_FALSE(check_places(std::vector{output("a.yaml", "")}, Overwrite::force, inputs, found));
    EXPECT_FALSE(write_files(std::vector{output("b.json", ""), output("a.yaml", "new")},
                             Overwrite::force,
                             inputs,
                             found));
    ASSERT_EQ(found.error_count(), 2);
    EXPECT_EQ(found.items()[1].code, "E0153");
    EXPECT_EQ(found.items()[1].message,
              "'" + path("a.yaml") + "' is read by this command, and stays as it is");
  }
  const std::vector<std::string> inputs = {path("link.yaml")};
  Diagnostics found;
  EXPECT_FALSE(
      write_files(std::vector{output("link.yaml", "new")}, Overwrite::force, inputs, found));
  EXPECT_EQ(text_of("link.yaml"), "input");
  EXPECT_EQ(names(), (Names{"a.yaml", "link.yaml"}));
}

// What is read through a link is not that link.
TEST_F(WriteFiles, ReplacesALinkToAnInput) {
  const std::vector<std::string> inputs = {make_file("a.yaml", "input")};
  std::filesystem::create_symlink(inputs.front(), path("link.json"));

  Diagnostics found;
  EXPECT_TRUE(
      write_files(std::vector{output("link.json", "new")}, Overwrite::force, inputs, found));

  EXPECT_EQ(text_of("a.yaml"), "input");
  EXPECT_EQ(text_of("link.json"), "new");
}

TEST_F(WriteFiles, WritesNoneWhenOneIsForeign) {
  make_file("b.json", "foreign");

  EXPECT_EQ(refusal({output("a.json", "new"), output("b.json", "new")}).code, "E0153");

  EXPECT_EQ(names(), Names{"b.json"});
}

TEST_F(WriteFiles, NamesEveryForeignFile) {
  make_file("a.json", "foreign");
  make_file("b.json", "foreign");
  Diagnostics found;

  write_files(
      std::vector{output("a.json", ""), output("b.json", "")}, Overwrite::own_only, {}, found);

  EXPECT_EQ(found.error_count(), 2);
}

TEST_F(WriteFiles, NeverReplacesAFolder) {
  std::filesystem::create_directory(path("a.json"));

  const Diagnostic item = refusal({output("a.json", "new")}, Overwrite::force);

  EXPECT_EQ(item.code, "E0152");
  EXPECT_NE(item.message.find("it is a folder"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_directory(path("a.json")));
}

TEST_F(WriteFiles, NeverReplacesAPipe) {
  ASSERT_EQ(::mkfifo(path("a.json").c_str(), 0600), 0);

  EXPECT_EQ(refusal({output("a.json", "new")}, Overwrite::force).code, "E0152");

  EXPECT_TRUE(std::filesystem::is_fifo(path("a.json")));
}

TEST_F(WriteFiles, RefusesASymbolicLinkToAForeignFile) {
  make_file("system", "foreign");
  std::filesystem::create_symlink("system", path("a.json"));

  EXPECT_EQ(refusal({output("a.json", "new")}).code, "E0153");

  EXPECT_TRUE(std::filesystem::is_symlink(path("a.json")));
  EXPECT_EQ(text_of("system"), "foreign");
}

TEST_F(WriteFiles, RefusesADanglingSymbolicLink) {
  std::filesystem::create_symlink("missing", path("a.json"));

  EXPECT_EQ(refusal({output("a.json", "new")}).code, "E0153");

  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WriteFiles, ReplacesASymbolicLinkButNotItsTargetWhenForced) {
  make_file("system", "foreign");
  std::filesystem::create_symlink("system", path("a.json"));

  ASSERT_TRUE(write({output("a.json", "new")}, Overwrite::force));

  EXPECT_FALSE(std::filesystem::is_symlink(path("a.json")));
  EXPECT_EQ(text_of("a.json"), "new");
  EXPECT_EQ(text_of("system"), "foreign");
}

TEST_F(WriteFiles, LeavesOtherNamesOfAReplacedFileAsTheyWere) {
  make_file("a.json", "{\"kinestat\": old}");
  std::filesystem::create_hard_link(path("a.json"), path("archive.json"));

  ASSERT_TRUE(write({output("a.json", "new")}));

  EXPECT_EQ(text_of("archive.json"), "{\"kinestat\": old}");
}

TEST_F(WriteFiles, SaysThatTheFolderIsMissing) {
  const Diagnostic item = refusal({output("missing/a.json", "new")});

  EXPECT_EQ(item.code, "E0152");
  EXPECT_NE(item.message.find("No such file or directory"), std::string::npos);
}

TEST_F(WriteFiles, SaysThatTheFolderIsAFile) {
  make_file("file", "text");

  const Diagnostic item = refusal({output("file/a.json", "new")});

  EXPECT_EQ(item.code, "E0152");
  EXPECT_NE(item.message.find("Not a directory"), std::string::npos);
  EXPECT_EQ(text_of("file"), "text");
}

TEST_F(WriteFiles, WritesNoneWhenALaterFolderIsMissing) {
  make_file("a.json", "{\"kinestat\": old}");

  EXPECT_EQ(refusal({output("a.json", "new"), output("missing/b.json", "new")}).code, "E0152");

  EXPECT_EQ(text_of("a.json"), "{\"kinestat\": old}");
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WriteFiles, BringsBackWhatWasReplacedWhenALaterPlaceIsTaken) {
  make_file("b.json", "{\"kinestat\": old}");

  // The second 'a.json' finds that a file has appeared since all targets were looked at.
  const Diagnostic item =
      refusal({output("a.json", "1"), output("b.json", "2"), output("a.json", "3")});

  EXPECT_EQ(item.code, "E0152");
  EXPECT_EQ(text_of("b.json"), "{\"kinestat\": old}");
  EXPECT_EQ(names(), Names{"b.json"});
}

// What a full disk does: the system takes a part of the text and refuses the rest.
TEST_F(WriteFiles, LeavesTheOldFileWhenTheTextDoesNotFit) {
  make_file("a.json", "{\"kinestat\": old}");
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1024;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);

  const Diagnostic item = refusal({output("a.json", std::string(5000, 'x'))});

  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(item.code, "E0152");
  EXPECT_NE(item.message.find("File too large"), std::string::npos);
  EXPECT_EQ(text_of("a.json"), "{\"kinestat\": old}");
  EXPECT_EQ(names(), Names{"a.json"});
}

class FileMode : public WriteFiles, public testing::WithParamInterface<mode_t> {};

TEST_P(FileMode, FollowsTheUmask) {
  const mode_t before = ::umask(GetParam());

  const bool is_done = write({output("a.json", "text")});

  ::umask(before);
  ASSERT_TRUE(is_done);
  struct stat status = {};
  ASSERT_EQ(::stat(path("a.json").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0666U & ~GetParam());
}

INSTANTIATE_TEST_SUITE_P(Umasks,
                         FileMode,
                         testing::Values(0U, 022U, 077U, 0777U),
                         [](const auto& row) { return "Octal" + std::to_string(row.index); });

TEST_F(WriteFiles, UsesNoOtherFolderForTemporaries) {
  ::setenv("TMPDIR", "/nowhere", 1);

  const bool is_done = write({output("a.json", "text")});

  ::unsetenv("TMPDIR");
  EXPECT_TRUE(is_done);
}

TEST_F(WriteFiles, WritesIntoTheWorkingFolder) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);

  const bool is_done = write({{.path = "a.json", .content = "text", .signature = kSignature}});

  std::filesystem::current_path(before);
  ASSERT_TRUE(is_done);
  EXPECT_EQ(text_of("a.json"), "text");
}

using OutputFolder = WriteFiles;

TEST_F(OutputFolder, IsAcceptedWhenItCanBeWrittenTo) {
  Diagnostics found;

  EXPECT_TRUE(check_output_folder(folder_, found));
  EXPECT_TRUE(check_output_folder("", found));

  EXPECT_FALSE(found.has_errors());
}

TEST_F(OutputFolder, IsToBeMadeWhenItIsMissing) {
  Diagnostics found;

  EXPECT_FALSE(check_output_folder(path("out"), found));

  ASSERT_EQ(found.error_count(), 1);
  EXPECT_EQ(found.items()[0].code, "E0152");
  EXPECT_EQ(found.items()[0].hint, "mkdir -p '" + path("out") + "'");
}

TEST_F(OutputFolder, IsNoFile) {
  Diagnostics found;

  EXPECT_FALSE(check_output_folder(make_file("out", ""), found));

  ASSERT_EQ(found.error_count(), 1);
  EXPECT_EQ(found.items()[0].code, "E0152");
  EXPECT_NE(found.items()[0].message.find("is not a folder"), std::string::npos);
}

TEST_F(OutputFolder, MustBeWritable) {
  ASSERT_EQ(::chmod(folder_.c_str(), 0555), 0);
  // Permissions bind root only after it has become somebody else.
  const bool is_root = ::geteuid() == 0;
  if (is_root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  Diagnostics found;

  const bool is_accepted = check_output_folder(folder_, found);
  const Diagnostic write_error = refusal({output("a.json", "text")});

  if (is_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_FALSE(is_accepted);
  ASSERT_EQ(found.error_count(), 1);
  EXPECT_EQ(found.items()[0].code, "E0152");
  EXPECT_NE(found.items()[0].message.find("Permission denied"), std::string::npos);
  EXPECT_EQ(write_error.code, "E0152");
}

}  // namespace
}  // namespace kinestat
