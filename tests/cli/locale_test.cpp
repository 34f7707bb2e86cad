// A program that uses the library may have set a global locale: no byte of an answer may change.

#include <filesystem>
#include <locale>
#include <string>

#include <gtest/gtest.h>

#include "run/analyse.hpp"
#include "run/graph.hpp"

namespace kinestat {
namespace {

// Numbers as in Brazil: 1.234.567,8.
class CommaAndGroups : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }

  char do_thousands_sep() const override { return '.'; }

  std::string do_grouping() const override { return "\3"; }
};

// A global locale for the time of a scope.
class GlobalLocale {
 public:
  explicit GlobalLocale(const std::locale& locale) : before_(std::locale::global(locale)) {}

  ~GlobalLocale() { std::locale::global(before_); }

  GlobalLocale(const GlobalLocale&) = delete;
  GlobalLocale& operator=(const GlobalLocale&) = delete;

 private:
  std::locale before_;
};

std::string path(const std::string& name) {
  return std::filesystem::path(KINESTAT_SOURCE_DIR) / name;
}

// Everything that the library says about a good file and a wrong one.
std::string answers() {
  const std::vector<std::string> good = {path("mechanisms/gears/simple_planetary.yaml")};
  std::string text;
  for (const StreamFormat format : {StreamFormat::table, StreamFormat::json, StreamFormat::csv}) {
    AnalyseOptions options;
    options.format = format;
    text += standard_output(analyse_files(good, options), {});
    text += standard_output(graph_files(good, Matrices::all, "", options), {});
  }
  return text + check_files({path("tests/cli/number_too_large/file.yaml")}, {}).err.plain() +
         check_files({path("tests/cli/angle_plus_length/file.yaml")}, {}).err.plain();
}

TEST(Answers, AreTheSameUnderAGlobalLocaleWithDecimalComma) {
  const std::string expected = answers();
  // Owned by the locale.
  const GlobalLocale locale(std::locale(std::locale::classic(), new CommaAndGroups));

  const std::string actual = answers();

  EXPECT_EQ(actual, expected);
  EXPECT_GT(expected.size(), 10000U);
}

}  // namespace
}  // namespace kinestat
