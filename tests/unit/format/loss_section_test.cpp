#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto losses_of(const std::string& text) {
  return read_section(losses_section(), "'losses'", text);
}

TEST(LossSection, TakesTheCarrierModelByDefault) {
  const auto reading = losses_of("gear_external: 0.02\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->model, LossModel::carrier);
  EXPECT_EQ(reading.value->gear_external->form, LossForm::fraction);
  EXPECT_EQ(reading.value->gear_external->value.expression.text(), "0.02");
  EXPECT_FALSE(reading.value->gear_internal);
}

TEST(LossSection, ReadsEveryForm) {
  const auto reading = losses_of(
      "model: absolute\n"
      "gear_external: {loss: 0.02}\n"
      "gear_internal: {eta: 0.99}\n"
      "meshes: {h: 0.015, k: {k: 0.2}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->model, LossModel::absolute);
  EXPECT_EQ(reading.value->gear_external->form, LossForm::fraction);
  EXPECT_EQ(reading.value->gear_internal->form, LossForm::efficiency);
  ASSERT_EQ(reading.value->meshes.size(), 2U);
  EXPECT_EQ(reading.value->meshes[0].coupling.text, "h");
  EXPECT_EQ(reading.value->meshes[0].loss.value.expression.text(), "0.015");
  EXPECT_EQ(reading.value->meshes[1].loss.form, LossForm::teeth);
}

TEST(LossSection, RefusesAnotherModelAndUnknownKeys) {
  EXPECT_EQ(losses_of("model: carier\ngears: 0.02\nmeshes: [h]\n").complaints(),
            (Complaints{"1:8 E0305 'model' of 'losses' cannot be 'carier'",
                        "3:9 E0304 'meshes' of 'losses' must be a mapping of meshes to losses",
                        "2:1 E0302 'losses' has no key 'gears'"}));
}

TEST(LossSection, WantsOneFormOfALoss) {
  EXPECT_EQ(
      losses_of("meshes: {h: {}, k: {loss: 0.1, eta: 0.9}, l: {et: 0.9}, m: [1]}\n").complaints(),
      (Complaints{"1:13 E0303 the loss of mesh 'h' needs one of 'loss', 'eta' and 'k'",
                  "1:20 E0302 the loss of mesh 'k' needs one of 'loss', 'eta' and 'k'",
                  "1:47 E0302 the loss of mesh 'l' has no key 'et'",
                  "1:60 E0304 the loss of mesh 'm' is a list where a single value is "
                  "expected"}));
}

}  // namespace
}  // namespace kinestat
