#include "expression/expression_tape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "expression/evaluate.hpp"

namespace kinestat {

namespace {

constexpr Dimension kLengthDimension{1, 0, 0, 0};

// x and y are bare numbers, l is a length; c is a bare number that does not vary.
const std::vector<std::string> kNames = {"x", "y", "l", "c"};
const std::vector<Dimension> kDimensions = {{}, {}, kLengthDimension, {}};
constexpr double kConstant = 0.1;

SlotExpression slotted(const std::string& text) {
  auto parsed = parse_expression(text);
  return SlotExpression(std::get<Expression>(parsed), [](const std::string& name) {
    return static_cast<int>(std::ranges::find(kNames, name) - kNames.begin());
  });
}

// A tape of one expression.
class Taped {
 public:
  Taped(const std::string& text, QuantityKind kind, const FileUnits& units)
      : expression_(slotted(text)), kind_(kind), units_(units) {
    LaneRecorder recorder;
    std::vector<std::optional<TapeQuantity>> slots;
    for (std::size_t i = 0; i < 3; ++i) {
      slots.push_back(TapeQuantity{recorder.input(1.0), kDimensions[i]});
    }
    slots.push_back(TapeQuantity{recorder.constant(kConstant), {}});
    const auto number = record_as(kind, expression_, units, slots, recorder);
    if (number) {
      tape_ = recorder.make_tape(std::vector<TapeNumber>{*number});
    }
  }

  bool is_recorded() const { return tape_.has_value(); }

  // As evaluate_as has it, down to the bits and to where there is no value.
  void expect_same(const std::vector<double>& values) const {
    LaneTape::Workspace workspace = tape_->make_workspace(1);
    std::map<std::string, Quantity, std::less<>> table;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      table[kNames[i]] = {i < 3 ? values[i] : kConstant, kDimensions[i]};
      if (i < 3) {
        tape_->set_input(workspace, i, 0, values[i]);
      }
    }
    tape_->play(workspace);
    const auto expected = evaluate_as(
        kind_, expression_.expression(), units_, [&](std::string_view name) -> const Quantity* {
          const auto at = table.find(name);
          return at == table.end() ? nullptr : &at->second;
        });
    const double* number = std::get_if<double>(&expected);
    ASSERT_EQ(tape_->is_met(workspace, 0), number != nullptr);
    if (number != nullptr) {
      const double found = tape_->output(workspace, 0, 0);
      EXPECT_TRUE(found == *number &&
                  (found == 0.0 || std::signbit(found) == std::signbit(*number)))
          << found << " " << *number;
    }
  }

 private:
  SlotExpression expression_;
  QuantityKind kind_;
  const FileUnits& units_;
  std::optional<LaneTape> tape_;
};

TEST(TapedExpression, GivesTheBitsOfEvaluateAs) {
  FileUnits millimetres;
  ASSERT_FALSE(millimetres.set(QuantityKind::length, "mm").has_value());
  const double largest = std::numeric_limits<double>::max();
  const std::vector<std::vector<double>> states = {{1.0, 2.0, 0.003},
                                                   {0.1, 0.7, 1e-3},
                                                   {-3.3, 3.3, 0.25},
                                                   {0.0, 0.0, 0.0},
                                                   {1e-200, 1e-200, 1e-200},
                                                   {1e200, 1e200, 1e200},
                                                   {5.0, 0.0, 1.0},
                                                   {0.0, 5.0, 1.0},
                                                   {largest, largest, 1.0},
                                                   {1e-320, 3.0, 1e-320},
                                                   {1.5, -1.5, 2.0},
                                                   {7.0, 1e-308, 3.0},
                                                   {19.0, 15.0, 1.0},
                                                   {41.0, 22.0, 1e-9},
                                                   {0.1, 0.2, 1.0},
                                                   {0.3, 0.2, 1.0},
                                                   {100.1, 0.1, 1.0},
                                                   {100.1, 100.0, 1.0}};
  for (const char* text : {"x",
                           "-x",
                           "(x + y)/2",
                           "x*y",
                           "x/y",
                           "x - y",
                           "(x + y)/2*l",
                           "l*x/y",
                           "(x) mm",
                           "(x - y) mm + l",
                           "3*l - 2 mm",
                           "x*c + y*sin(30 deg)",
                           "l*cos(20 deg)*c",
                           "x*y/(x + y)",
                           "1/(x - y)",
                           "c/x*l",
                           "2",
                           "l/l*x",
                           "x + y - 0.3",
                           "x - 100 - y",
                           "x - y - c",
                           "(x - 100)*c/3 - y*c/3",
                           "0.3 - (y + x)"}) {
    SCOPED_TRACE(text);
    const Taped taped(text, QuantityKind::length, millimetres);
    ASSERT_TRUE(taped.is_recorded());
    for (const std::vector<double>& state : states) {
      SCOPED_TRACE(testing::PrintToString(state));
      taped.expect_same(state);
    }
  }
}

// Each sum asks how far the sums before it are off.
TEST(TapedExpression, OfManyTermsIsThatOfEvaluateAs) {
  const FileUnits units;
  std::string text = "0.1*x";
  for (int i = 0; i < 300; ++i) {
    text += i % 3 == 0 ? " - 0.7*y" : i % 3 == 1 ? " + 0.2*x" : " + 0.35*y";
  }
  const Taped taped(text, QuantityKind::length, units);
  ASSERT_TRUE(taped.is_recorded());
  taped.expect_same({0.1, 0.7, 1.0});
  taped.expect_same({3.0, -1e-3, 1.0});
}

TEST(TapedExpression, IsEmptyForWhatATapeCannotDo) {
  const FileUnits units;
  for (const char* text : {"sqrt(x)", "x^2", "x + l", "sin(x)", "mod(x, 3)", "(x) kg"}) {
    EXPECT_FALSE(Taped(text, QuantityKind::length, units).is_recorded()) << text;
  }
}

}  // namespace

}  // namespace kinestat
