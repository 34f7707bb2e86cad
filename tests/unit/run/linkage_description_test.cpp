#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "format/mechanism_writer.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/synthesis/task/linkage_files.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

const Dyad kCrank{.circle_point = {0.1, 0.2}, .centre_point = {0.0, -0.5}, .length = 0.9};
const Dyad kOtherCrank{.circle_point = {0.7, 0.1}, .centre_point = {1.5, -0.4}, .length = 0.8};
const Dyad kSlider{.kind = DyadKind::slider,
                   .circle_point = {0.9, 0.3},
                   .centre_point = {1.2, 0.9},
                   .direction = {0.6, 0.8}};
const Dyad kOtherSlider{.kind = DyadKind::slider,
                        .circle_point = {-0.2, 0.4},
                        .centre_point = {0.1, 0.6},
                        .direction = {1.0, 0.0}};
const Dyad kGuide{.kind = DyadKind::inverted_slider,
                  .circle_point = {0.0, 0.3},
                  .centre_point = {1.1, 1.3},
                  .direction = {1.0, 0.0}};
const Dyad kOtherGuide{.kind = DyadKind::inverted_slider,
                       .circle_point = {0.2, 0.0},
                       .centre_point = {-0.4, 1.2},
                       .direction = {0.0, 1.0}};

struct LinkageCase {
  std::string name;
  Dyad one;
  Dyad other;
};

class LinkageDescription : public testing::TestWithParam<LinkageCase> {
 protected:
  LinkageDescription() {
    const std::vector<Dyad> dyads = {GetParam().one, GetParam().other};
    analysis_.file = "task.yaml";
    analysis_.description.synthesis.emplace();
    EXPECT_FALSE(analysis_.description.units.set(QuantityKind::length, "mm"));
    task_.positions = {finite_position({0.3, 0.4}, 0.5)};
    task_.linkages = rank_linkages(dyads, task_.positions, {});
  }

  SynthesisAnalysis analysis_;
  SynthesisTask task_;
};

TEST_P(LinkageDescription, HasTheDyadsDrawnInTheFirstPosition) {
  const LinkageCandidate& candidate = task_.linkages.at(0);
  const std::string text = mechanism_text(describe_linkage(analysis_, task_, candidate),
                                          linkage_comment(analysis_, task_, 0));

  auto reading = read_text(text, read_mechanism);
  ASSERT_EQ(reading.complaints(), Complaints{}) << text;
  const std::optional<Mechanism> mechanism = bind(*reading.value, reading.found);

  ASSERT_EQ(reading.complaints(), Complaints{}) << text;
  ASSERT_EQ(mechanism->topology.couplings.size(), 4U);
  for (const bool is_driver : {true, false}) {
    const Dyad& dyad = is_driver ? input_of(candidate.linkage, candidate.best_drive)
                                 : output_of(candidate.linkage, candidate.best_drive);
    const CouplingDescription& outer = reading.value->couplings.at(is_driver ? 0 : 3);
    const CouplingDescription& inner = reading.value->couplings.at(is_driver ? 1 : 2);
    EXPECT_EQ(outer.tail.text, "frame");
    EXPECT_EQ(outer.type == CouplingType::prismatic, dyad.kind == DyadKind::slider);
    EXPECT_EQ(inner.type == CouplingType::prismatic, dyad.kind == DyadKind::inverted_slider);
  }
}

TEST_P(LinkageDescription, StandsInMillimetresOfTheFixedFrame) {
  const Pose pose = pose_of(task_.positions[0]);
  const LinkageCandidate& candidate = task_.linkages.at(0);
  const Dyad& driver = input_of(candidate.linkage, candidate.best_drive);

  const MechanismDescription mechanism = describe_linkage(analysis_, task_, candidate);

  const Point expected =
      driver.kind == DyadKind::slider ? pose.place(driver.circle_point) : driver.centre_point;
  const auto& at = mechanism.couplings.at(0).at->point->coordinates;
  EXPECT_NEAR(std::stod(at[0].expression.text()), 1000.0 * expected.real(), 1e-9);
  EXPECT_NEAR(std::stod(at[1].expression.text()), 1000.0 * expected.imag(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfEveryType,
                         LinkageDescription,
                         testing::ValuesIn(std::vector<LinkageCase>{
                             {"FourBar", kCrank, kOtherCrank},
                             {"SliderCrank", kCrank, kSlider},
                             {"InvertedSliderCrank", kCrank, kGuide},
                             {"DoubleSlider", kSlider, kOtherSlider},
                             {"SliderInvertedSlider", kSlider, kGuide},
                             {"DoubleInvertedSlider", kGuide, kOtherGuide}}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace kinestat
