#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "couplings/kinds.hpp"
#include "property/network_case.hpp"
#include "property/shard.hpp"
#include "support/random_network_catalogue.hpp"

namespace kinestat {
namespace {

// What the properties rest on: that the generator makes every kind of network and coupling. Each
// is counted by a word.
using Census = std::map<std::string, int>;

constexpr int kOften = 50;

template <class Count>
Census count_networks(int first, int last, const Count& count) {
  Census census;
  for (int seed = first; seed < last; ++seed) {
    count(make_random_network(static_cast<std::uint64_t>(seed)), census);
  }
  return census;
}

void count_types(const RandomNetwork& network, Census& census) {
  for (const NetworkCoupling& coupling : network.couplings) {
    const std::string space = network.space() == Space::planar ? "planar " : "spatial ";
    ++census[space + std::string(word_of(coupling.type))];
  }
}

std::vector<std::string> words_of_types(const std::string& space_word, Space space) {
  std::vector<std::string> words;
  for (const CouplingType type : types_of(space, Completeness::any)) {
    words.push_back(space_word + std::string(word_of(type)));
  }
  return words;
}

TEST(RandomNetwork, HasEveryTypeOfItsSpaceAmongTheSeeds) {
  const Census census = count_networks(0, kSeedCount, count_types);

  std::vector<std::string> expected = words_of_types("planar ", Space::planar);
  const std::vector<std::string> spatial = words_of_types("spatial ", Space::spatial);
  expected.insert(expected.end(), spatial.begin(), spatial.end());
  EXPECT_EQ(spatial.size(), 20U) << "all but the pin in a slot";
  EXPECT_EQ(census.size(), expected.size());
  for (const std::string& word : expected) {
    const auto at = census.find(word);
    EXPECT_GE(at == census.end() ? 0 : at->second, kOften) << word;
  }
}

bool has_listed(const NetworkCoupling& coupling, std::string_view word) {
  return coupling.find(word) != nullptr;
}

// The ways in which a coupling may be written.
void count_forms(const RandomNetwork& network, Census& census) {
  for (const NetworkCoupling& coupling : network.couplings) {
    const std::string type(word_of(coupling.type));
    for (const NetworkKey& key : coupling.keys) {
      ++census[type + " " + key.word];
      const auto* direction = std::get_if<NetworkDirection>(&key.value);
      if (direction != nullptr) {
        ++census[direction->keyword.empty() ? "vector" : "keyword"];
      }
    }
    census["no place"] += has_place(coupling) ? 0 : 1;
    census["both lists"] +=
        has_listed(coupling, "freedoms") && has_listed(coupling, "constraints") ? 1 : 0;
    if (coupling.passive) {
      ++census[coupling.passive->empty() ? "passive none" : "passive some"];
    }
  }
  for (const NetworkActuator& actuator : network.actuators) {
    const auto e = static_cast<std::size_t>(actuator.coupling);
    census["named actuator"] += network.couplings[e].is_named ? 1 : 0;
  }
  census["names world"] += network.names_world ? 1 : 0;
}

TEST(RandomNetwork, WritesCouplingsInEveryWayAmongTheSeeds) {
  Census census = count_networks(0, kSeedCount, count_forms);

  for (const char* word : {"vector",
                           "keyword",
                           "no place",
                           "both lists",
                           "passive none",
                           "passive some",
                           "named actuator",
                           "names world",
                           "helical pitch",
                           "helical lead",
                           "gear line_of_action",
                           "gear tangent",
                           "gear pressure_angle",
                           "gear helix_angle",
                           "gear contact",
                           "bevel_gear axis",
                           "bevel_gear screw",
                           "worm screw",
                           "rack axis",
                           "rack screw",
                           "screws freedoms",
                           "screws constraints"}) {
    EXPECT_GE(census[word], kOften) << word;
  }
}

TEST(RandomNetwork, IsOfEveryLayoutAndSizeAmongTheSeeds) {
  std::set<Layout> layouts;
  std::set<int> sizes;
  std::set<int> small_sizes;
  for (int seed = 0; seed < kSeedCount; ++seed) {
    const RandomNetwork network = make_random_network(static_cast<std::uint64_t>(seed));
    layouts.insert(network.layout);
    (seed < kFirstSmallSeed ? sizes : small_sizes).insert(network.body_count());
    EXPECT_TRUE(seed < kFirstSmallSeed || network.space() == Space::spatial);
  }

  EXPECT_EQ(layouts.size(), 6U);
  EXPECT_EQ(*sizes.begin(), 3);
  EXPECT_EQ(*sizes.rbegin(), 30);
  EXPECT_EQ(*small_sizes.begin(), 3);
  EXPECT_EQ(*small_sizes.rbegin(), 12);
}

void count_properties(const RandomNetwork& network, Census& census) {
  if (network.body_count() <= 12) {
    const NetworkCase in_numbers = make_network_case(bind_network(network));
    const int rank = find_rank(in_numbers.M_N).rank;
    census["redundant"] += rank < in_numbers.M_N.rows() ? 1 : 0;
    census["statically determined"] += rank == in_numbers.M_N.rows() ? 1 : 0;
    census["mobile"] += rank < in_numbers.M_N.cols() ? 1 : 0;
    census["immobile"] += rank == in_numbers.M_N.cols() ? 1 : 0;
  }
}

TEST(RandomNetwork, IsRedundantOrNotAndMobileOrNotAmongTheSeeds) {
  Census census = count_networks(0, kFirstSmallSeed, count_properties);
  Census small = count_networks(kFirstSmallSeed, kSeedCount, count_properties);

  for (const char* word : {"redundant", "statically determined", "mobile", "immobile"}) {
    EXPECT_GE(census[word], 30) << word;
    EXPECT_GE(small[word], 120) << word;
  }
}

}  // namespace
}  // namespace kinestat
