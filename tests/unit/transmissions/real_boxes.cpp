#include "real_boxes.hpp"

#include <algorithm>

namespace kinestat {

namespace {

TransmissionStructure structure_of(const RealBox& box) {
  TransmissionStructure structure;
  structure.shafts = static_cast<int>(box.sets.size()) + box.engaged + 2;
  for (const RealSet& set : box.sets) {
    SetShafts shafts = {set.sun, set.carrier, set.ring};
    std::ranges::sort(shafts);
    structure.sets.push_back(shafts);
  }
  VertexMap identity;
  for (int i = 0; i < structure.shafts; ++i) {
    identity.push_back(static_cast<std::uint8_t>(i));
  }
  structure.automorphisms = {identity};
  return structure;
}

TransmissionTrain train_of(const RealBox& box,
                           const TransmissionStructure& structure,
                           const GenericTrain& train) {
  TransmissionTrain result;
  result.train = &train;
  result.elements = box.elements;
  std::uint32_t power = 1;
  for (std::size_t s = 0; s < box.sets.size(); ++s, power *= kRolesOfSet) {
    const RealSet& set = box.sets[s];
    for (int roles = 0; roles < kRolesOfSet; ++roles) {
      const SetRoles its = set_roles(roles);
      const SetShafts& shafts = structure.sets[s];
      if (shafts[its.sun] == set.sun && shafts[its.carrier] == set.carrier) {
        result.roles.roles += power * static_cast<std::uint32_t>(roles);
      }
    }
    result.roles.double_planet |= set.kind == SetKind::double_planet ? 1U << s : 0U;
    result.stationary_ratios[s] = static_cast<double>(set.ring_teeth) / set.sun_teeth;
  }
  return result;
}

}  // namespace

BoxTrain::BoxTrain(const RealBox& box)
    : structure_(structure_of(box)),
      train_(structure_, box.engaged),
      transmission_(train_of(box, structure_, train_)) {}

std::uint8_t BoxTrain::engaged(const std::string& letters) const {
  std::uint8_t bits = 0;
  for (const char letter : letters) {
    bits |= static_cast<std::uint8_t>(1U << (letter - 'A'));
  }
  return bits;
}

const std::vector<RealBox>& real_boxes() {
  using enum SetKind;
  static const std::vector<RealBox> boxes = {
      {.name = "Simpson_A727",
       .engaged = 2,
       .free_shafts = 0,
       .sets = {{simple, 5, 2, 3, 35, 73}, {simple, 5, 4, 2, 35, 73}},
       .elements = {{1, 3}, {1, 5}, {0, 5}, {0, 4}},
       .gears = {{"AD", 181.0 / 73.0}, {"AC", 108.0 / 73.0}, {"AB", 1.0}, {"BD", -73.0 / 35.0}}},
      {.name = "Chrysler_41TE",
       .engaged = 2,
       .free_shafts = 0,
       .sets = {{simple, 3, 4, 2, 28, 62}, {simple, 5, 2, 4, 38, 70}},
       .elements = {{1, 5}, {1, 4}, {1, 3}, {0, 3}, {0, 4}},
       .gears = {{"AE", 54.0 / 19.0},
                 {"AD", 269.0 / 171.0},
                 {"AB", 1.0},
                 {"BD", 31.0 / 45.0},
                 {"CE", -31.0 / 14.0}}},
      {.name = "ZF_4HP14",
       .engaged = 2,
       .free_shafts = 0,
       .sets = {{double_planet, 3, 5, 2, 34, 82}, {simple, 4, 5, 2, 29, 82}},
       .elements = {{1, 3}, {1, 4}, {1, 5}, {0, 4}, {0, 5}},
       .gears = {{"AE", 41.0 / 17.0},
                 {"AD", 861.0 / 629.0},
                 {"AB", 1.0},
                 {"CD", 82.0 / 111.0},
                 {"BE", -82.0 / 29.0}}},
      {.name = "ZF_6HP26",
       .engaged = 2,
       .free_shafts = 0,
       .sets = {{simple, 0, 3, 1, 37, 71},
                {double_planet, 4, 6, 2, 31, 85},
                {simple, 5, 6, 2, 38, 85}},
       .elements = {{3, 4}, {3, 5}, {0, 5}, {0, 6}, {1, 6}},
       .gears = {{"AD", 9180.0 / 2201.0},
                 {"AC", 211140.0 / 90241.0},
                 {"AB", 108.0 / 71.0},
                 {"AE", 9180.0 / 8033.0},
                 {"BE", 4590.0 / 5293.0},
                 {"CE", 85.0 / 123.0},
                 {"BD", -4590.0 / 1349.0}}},
      {.name = "ZF_8HP70",
       .engaged = 3,
       .free_shafts = 0,
       .sets = {{simple, 3, 5, 4, 48, 96},
                {simple, 3, 1, 6, 48, 96},
                {simple, 6, 7, 8, 69, 111},
                {simple, 8, 2, 5, 23, 85}},
       .elements = {{0, 3}, {0, 4}, {1, 8}, {2, 7}, {6, 8}},
       .gears = {{"ABC", 108.0 / 23.0},
                 {"ABE", 72.0 / 23.0},
                 {"BCE", 162.0 / 77.0},
                 {"BDE", 5.0 / 3.0},
                 {"BCD", 8826.0 / 6871.0},
                 {"CDE", 1.0},
                 {"ACD", 120.0 / 143.0},
                 {"ADE", 2.0 / 3.0},
                 {"ABD", -1744.0 / 529.0}}},
      {.name = "Mercedes_9G_Tronic",
       .engaged = 3,
       .free_shafts = 0,
       .sets = {{simple, 1, 3, 4, 46, 98},
                {simple, 5, 4, 6, 44, 100},
                {simple, 6, 2, 7, 37, 83},
                {simple, 6, 1, 8, 34, 86}},
       .elements = {{0, 5}, {0, 7}, {0, 3}, {2, 8}, {3, 6}, {1, 3}},
       .gears = {{"ABE", 13670.0 / 2553.0},
                 {"BEF", 120.0 / 37.0},
                 {"ABF", 250.0 / 111.0},
                 {"ABD", 3631.0 / 2220.0},
                 {"ADF", 1075.0 / 888.0},
                 {"DEF", 1.0},
                 {"ADE", 58781.0 / 67944.0},
                 {"CDE", 43.0 / 60.0},
                 {"ACD", 52675.0 / 87576.0},
                 {"ABC", -12250.0 / 2553.0}}},
      {.name = "Ford_10R80",
       .engaged = 4,
       .free_shafts = 1,
       .sets = {{simple, 4, 5, 3, 45, 95},
                {simple, 4, 1, 6, 51, 89},
                {simple, 6, 8, 7, 73, 119},
                {simple, 7, 2, 5, 23, 85}},
       .elements = {{0, 3}, {0, 4}, {6, 9}, {8, 9}, {1, 7}, {5, 9}},
       .gears = {{"ABDE", 108.0 / 23.0},
                 {"ABCD", 2403.0 / 805.0},
                 {"ACDE", 3024.0 / 1409.0},
                 {"ACDF", 743.0 / 420.0},
                 {"ACEF", 80244.0 / 52789.0},
                 {"ADEF", 9289296.0 / 7285081.0},
                 {"CDEF", 1.0},
                 {"BDEF", 615168.0 / 720653.0},
                 {"BCEF", 3204.0 / 4649.0},
                 {"BCDF", 89.0 / 140.0},
                 {"ABDF", -40851.0 / 8395.0}}}};
  return boxes;
}

}  // namespace kinestat
