#include <string>
#include <string_view>
#include <sys/resource.h>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/yaml_tree.hpp"
#include "yaml_text.hpp"

namespace kinestat {
namespace {

TEST(Limits, AdmitTheDepthTheyName) {
  const std::string text = "a: " + std::string(63, '[') + std::string(63, ']');

  EXPECT_EQ(complaints(text), "");
}

TEST(Limits, RefuseBracketsThatAreTooDeep) {
  const std::string text = "a: " + std::string(64, '[') + std::string(64, ']');

  EXPECT_EQ(complaints(text), "E0210 1:67+1 more than 64 levels of nesting\n");
}

TEST(Limits, RefuseBlocksThatAreTooDeep) {
  std::string text;
  for (std::size_t i = 0; i < 65; ++i) {
    text += std::string(i, ' ') + "a:\n";
  }

  EXPECT_EQ(complaints(text), "E0210 65:65+1 more than 64 levels of nesting\n");
}

TEST(Limits, RefuseListsOfListsThatAreTooDeep) {
  std::string text = "a:\n";
  for (int i = 0; i < 100000; ++i) {
    text += "- ";
  }

  EXPECT_EQ(complaints(text), "E0210 2:127+1 more than 64 levels of nesting\n");
}

TEST(Limits, CountTheDepthOfAliases) {
  const std::string text = "a: &x " + std::string(40, '[') + std::string(40, ']') +
                           "\nb: " + std::string(30, '[') + "*x" + std::string(30, ']') + "\n";

  EXPECT_EQ(complaints(text), "E0210 2:34+2 more than 64 levels of nesting\n");
}

TEST(Limits, OfDepthCanBeRaisedToFourHundred) {
  const auto nested = [](std::size_t depth) {
    return "a: " + std::string(depth - 1, '[') + std::string(depth - 1, ']');
  };

  EXPECT_EQ(complaints(nested(400), {.depth = 100000}), "");
  EXPECT_EQ(complaints(nested(401), {.depth = 100000}),
            "E0210 1:403+1 more than 400 levels of nesting\n");
}

TEST(Limits, RefuseTooManyValues) {
  EXPECT_EQ(complaints("a: [1, 2]\n", {.nodes = 4}), "");
  EXPECT_EQ(complaints("a: [1, 2, 3]\n", {.nodes = 4}),
            "E0210 1:11+1 more than 4 values in the file, aliases expanded\n");
}

TEST(Limits, RefuseTwoHundredThousandAndOneValues) {
  std::string text = "a:\n";  // the root and the list are two values more
  for (int i = 0; i < 199999; ++i) {
    text += "- 1\n";
  }

  EXPECT_EQ(complaints(text),
            "E0210 200000:3+1 more than 200000 values in the file, aliases expanded\n");
}

TEST(Limits, RefuseALongValue) {
  EXPECT_EQ(complaints("a: 12345678\n", {.scalar = 8}), "");
  EXPECT_EQ(complaints("a: 123456789\n", {.scalar = 8}),
            "E0210 1:4+9 value is 9 bytes long, the limit is 8\n");
}

TEST(Limits, RefuseALongKey) {
  EXPECT_EQ(complaints("123456789: a\n", {.scalar = 8}),
            "E0210 1:1+9 value is 9 bytes long, the limit is 8\n");
}

TEST(Limits, RefuseAValueOfTenMegabytes) {
  const std::string text = "a: '" + std::string(10000000, 'x') + "'\n";

  EXPECT_EQ(complaints(text),
            "E0210 1:4+10000002 value is 10000000 bytes long, the limit is 65536\n");
}

TEST(Limits, RefuseAliasesThatRepeatMuchText) {
  std::string text = "a: &x " + std::string(1000, 'x') + "\nb:\n";
  for (int i = 0; i < 20; ++i) {
    text += "- *x\n";
  }

  EXPECT_EQ(complaints(text, {.bytes = 20000}), "");
  EXPECT_EQ(complaints(text, {.bytes = 19999}),
            "E0210 22:3+2 aliases repeat more than 19999 bytes of text\n");
}

struct Cost {
  double seconds = 0.0;  // of the processor, for a busy machine must not look like a slow reader
  long kilobytes = 0;
};

double processor_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Time and the growth of the largest memory the process has had, while a text is refused.
Cost cost_of_refusal(const std::string& text, std::string_view code) {
  rusage before = {};
  ::getrusage(RUSAGE_SELF, &before);
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, {}, found);
  rusage after = {};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_FALSE(root.has_value());
  EXPECT_EQ(found.items().empty() ? "" : found.items()[0].code, code);
  return {.seconds = processor_seconds(after) - processor_seconds(before),
          .kilobytes = after.ru_maxrss - before.ru_maxrss};
}

TEST(Limits, StopABombOfAliasesBeforeItGoesOff) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 40; ++i) {
    text += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i, i - 1);
  }

  const Cost cost = cost_of_refusal(text, "E0210");

  EXPECT_LT(cost.seconds, 0.010);
  EXPECT_LT(cost.kilobytes, 20000);
}

class Bomb : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Bomb, IsRefusedInASecondAndInBoundedMemory) {
  const auto& [sign, code] = GetParam();
  std::string text;
  while (text.size() < 1000000) {
    text += sign;
  }

  const Cost cost = cost_of_refusal(text, code);

  EXPECT_LT(cost.seconds, 1.0);
  EXPECT_LT(cost.kilobytes, 64000);
}

INSTANTIATE_TEST_SUITE_P(MillionBytes,
                         Bomb,
                         testing::Values(std::pair("[", "E0210"),
                                         std::pair("{", "E0210"),
                                         std::pair("a: [", "E0210"),
                                         std::pair("- ", "E0210"),
                                         std::pair("? ", "E0210"),
                                         std::pair("[a,", "E0210"),
                                         std::pair("]", "E0204"),
                                         std::pair("'", "E0210"),
                                         std::pair("&a ", "E0204")),
                         [](const auto& row) { return "Sign" + std::to_string(row.index); });

}  // namespace
}  // namespace kinestat
