#include "studies/transmissions/structure.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "studies/transmissions/roles.hpp"

namespace kinestat {
namespace {

// Counted by two programs: from canonical words, and from all labelled partitions.
struct StructureCounts {
  int sets;
  int engaged;
  std::uint64_t structures;
  std::uint64_t lines;     // with sets that share two shafts chosen anew on their common lever
  std::uint64_t labelled;  // partitions of labelled terminals
  std::uint64_t largest_group;
  std::uint64_t roles;  // up to the order of the sets alone
  std::uint64_t ends;   // and up to the exchange of sun and ring
};

class Structures : public ::testing::TestWithParam<StructureCounts> {
 protected:
  std::vector<TransmissionStructure> structures_ =
      enumerate_structures(GetParam().sets, GetParam().engaged, 0);
};

std::vector<SetAction> actions_of(const TransmissionStructure& structure) {
  std::vector<SetAction> actions;
  for (const VertexMap& automorphism : structure.automorphisms) {
    actions.emplace_back(structure, automorphism);
  }
  return actions;
}

// The levers: q sets on q + 2 shafts, such as two that share two, have these in one line.
std::vector<Hyperedge> lines_of(const TransmissionStructure& structure) {
  std::vector<std::pair<unsigned, Hyperedge>> lines;  // with their sets as bits
  for (unsigned choice = (1U << structure.sets.size()) - 1; choice > 0; --choice) {
    std::set<std::uint8_t> shafts;
    for (std::size_t s = 0; s < structure.sets.size(); ++s) {
      if ((choice >> s & 1U) != 0) {
        shafts.insert(structure.sets[s].begin(), structure.sets[s].end());
      }
    }
    if (static_cast<int>(shafts.size()) == std::popcount(choice) + 2) {
      lines.emplace_back(choice, Hyperedge(shafts.begin(), shafts.end()));
    }
  }
  std::vector<Hyperedge> whole;
  for (const auto& [choice, line] : lines) {
    if (std::ranges::none_of(lines, [choice = choice](const auto& other) {
          return other.first != choice && (other.first & choice) == choice;
        })) {
      whole.push_back(line);
    }
  }
  return whole;
}

// Which places are carriers, set by set.
std::vector<int> carriers_of(const RoleChoice& choice, int sets) {
  std::vector<int> carriers;
  for (int s = 0; s < sets; ++s) {
    carriers.push_back(set_roles(choice.roles_of(s)).carrier);
  }
  return carriers;
}

TEST_P(Structures, AreAsManyAsTwoProgramsCounted) {
  EXPECT_EQ(structures_.size(), GetParam().structures);
}

// Each structure stands for as many labelled ones as the group of all exchanges has elements for
// each of its own.
TEST_P(Structures, StandForAllLabelledOnes) {
  std::uint64_t exchanges = 1;
  for (int s = 1; s <= GetParam().sets; ++s) {
    exchanges *= 6 * static_cast<std::uint64_t>(s);
  }
  std::uint64_t labelled = 0;
  std::size_t largest = 0;
  for (const TransmissionStructure& one : structures_) {
    EXPECT_EQ(exchanges % one.automorphisms.size(), 0U);
    labelled += exchanges / one.automorphisms.size();
    largest = std::max(largest, one.automorphisms.size());
  }
  EXPECT_EQ(labelled, GetParam().labelled);
  EXPECT_EQ(largest, GetParam().largest_group);
}

TEST_P(Structures, HaveAsManyLevers) {
  std::set<std::vector<Hyperedge>> levers;
  for (const TransmissionStructure& one : structures_) {
    levers.insert(canonical_form(lines_of(one), 3).word);
  }
  EXPECT_EQ(levers.size(), GetParam().lines);
}

TEST_P(Structures, HaveAsManyRoles) {
  if (GetParam().engaged > kMostEngaged) {
    GTEST_SKIP() << "groups of tens of thousands";
  }
  std::uint64_t roles = 0;
  std::uint64_t ends = 0;
  const int sets = GetParam().sets;
  for (const TransmissionStructure& one : structures_) {
    const auto actions = actions_of(one);
    roles += least_role_choices(sets, 0, actions).size();
    std::set<std::vector<int>> seen;
    for (const RoleChoice& choice : least_role_choices(sets, 0, {})) {
      ends += seen.insert(carriers_of(choice, sets)).second ? 1 : 0;
      for (const SetAction& action : actions) {
        seen.insert(carriers_of(action.image(choice), sets));
      }
    }
  }
  EXPECT_EQ(roles, GetParam().roles);
  EXPECT_EQ(ends, GetParam().ends);
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         Structures,
                         ::testing::ValuesIn(std::vector<StructureCounts>{
                             {1, 0, 1, 1, 6, 1, 6, 3},
                             {1, 1, 3, 3, 18, 1, 18, 9},
                             {1, 2, 3, 3, 9, 2, 9, 6},
                             {1, 3, 1, 1, 1, 6, 1, 1},
                             {2, 0, 6, 1, 432, 1, 216, 54},
                             {2, 1, 21, 12, 1188, 2, 603, 159},
                             {2, 2, 22, 19, 876, 6, 447, 135},
                             {2, 3, 13, 13, 243, 8, 129, 52},
                             {2, 4, 4, 4, 27, 12, 15, 9},
                             {2, 5, 1, 1, 1, 72, 1, 1},
                             {3, 0, 55, 1, 64800, 2, 10854, 1373},
                             {3, 1, 170, 42, 168480, 6, 28464, 3762},
                             {3, 2, 203, 105, 144990, 8, 24702, 3636},
                             {3, 3, 133, 101, 56322, 12, 9739, 1740},
                             {3, 4, 59, 55, 11007, 72, 1982, 481},
                             {3, 5, 18, 18, 1107, 72, 220, 81},
                             {3, 6, 4, 4, 54, 144, 15, 9},
                             {3, 7, 1, 1, 1, 1296, 1, 1},
                             {4, 0, 626, 1, 17418240, 6, 729738, 46220},
                             {4, 1, 1800, 193, 42456960, 24, 1790100, 118152},
                             {4, 2, 2179, 611, 39009600, 24, 1656825, 119255},
                             {4, 3, 1557, 754, 18003384, 48, 772920, 64628},
                             {4, 4, 755, 517, 4650696, 72, 204090, 21424},
                             {4, 5, 276, 234, 704889, 384, 32539, 4711},
                             {4, 6, 79, 75, 63339, 1296, 3302, 726},
                             {4, 7, 19, 19, 3285, 1296, 241, 87},
                             {4, 8, 4, 4, 90, 2592, 15, 9},
                             {4, 9, 1, 1, 1, 31104, 1, 1}}),
                         [](const auto& test) {
                           return fmt::format(
                               "OfSets{}Engaged{}", test.param.sets, test.param.engaged);
                         });

// What falls out of [x(x-1)(x-2)]^(p+1) in falling factorials: all partitions in which the
// terminals of a set, and housing, input and output, lie apart. Of two sets those with a block are
// the ones on the same three shafts: six for each that one set has.
TEST(StructuresOfTwoSets, AndTheirBlocksAreAllPartitions) {
  const std::array<std::uint64_t, 6> all = {540, 1242, 882, 243, 27, 1};  // by engaged elements
  const std::array<std::uint64_t, 6> one_set = {18, 9, 1, 0, 0, 0};       // on as many shafts
  for (int engaged = 0; engaged < 6; ++engaged) {
    std::uint64_t labelled = 0;
    for (const TransmissionStructure& one : enumerate_structures(2, engaged, 0)) {
      labelled += 72 / one.automorphisms.size();
    }
    const auto at = static_cast<std::size_t>(engaged);
    EXPECT_EQ(labelled + 6 * one_set[at], all[at]) << engaged;
  }
}

TEST(StructuresOfThreeSets, WithAFreeShaftAreThoseWithOneElementFewer) {
  const auto with = enumerate_structures(3, 3, 1);
  const auto without = enumerate_structures(3, 2, 0);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].sets, without[i].sets);
    EXPECT_EQ(with[i].shafts, without[i].shafts + 1);
  }
}

}  // namespace
}  // namespace kinestat
