#include "graph/hypergraph_form.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace kinestat {
namespace {

TEST(HypergraphForm, NumbersVerticesAsTheyOccur) {
  const auto form = canonical_form({{4, 7, 9}, {0, 7, 8}}, 2);

  EXPECT_EQ(form.word, (std::vector<Hyperedge>{{0, 2, 3}, {2, 4, 5}}));
}

TEST(HypergraphForm, KeepsTheFirstVertices) {
  EXPECT_NE(canonical_form({{0, 3, 4}}, 2).word, canonical_form({{1, 3, 4}}, 2).word);
  EXPECT_EQ(canonical_form({{0, 3, 4}}, 2).word, canonical_form({{0, 2, 5}}, 2).word);
}

// Seven points, seven lines of three, every two on one line: its group has 168 elements.
TEST(HypergraphForm, FindsTheGroupOfThePlaneOfSevenPoints) {
  const std::vector<Hyperedge> fano = {
      {0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {1, 3, 5}, {1, 4, 6}, {2, 3, 6}, {2, 4, 5}};

  EXPECT_EQ(canonical_form(fano, 0).automorphisms.size(), 168U);
}

TEST(HypergraphForm, TakesEdgesOfAnySize) {
  const auto form = canonical_form({{1, 2}, {0, 1, 2, 3}}, 0);

  EXPECT_EQ(form.word, (std::vector<Hyperedge>{{0, 1}, {0, 1, 2, 3}}));
  EXPECT_EQ(form.automorphisms.size(), 4U);
}

class HypergraphForms : public ::testing::TestWithParam<int> {
 protected:
  std::vector<Hyperedge> random_edges() {
    std::set<Hyperedge> edges;
    for (int i = 0; i < 4; ++i) {
      std::set<std::uint8_t> edge;
      while (edge.size() < 3) {
        edge.insert(static_cast<std::uint8_t>(random_.whole(0, kVertices - 1)));
      }
      edges.insert(Hyperedge(edge.begin(), edge.end()));
    }
    return {edges.begin(), edges.end()};
  }

  // The same with other names, but for the first `kept`, and in another order.
  std::vector<Hyperedge> renamed(std::vector<Hyperedge> edges, int kept) {
    std::vector<std::uint8_t> names(kVertices);
    std::iota(names.begin(), names.end(), std::uint8_t{0});
    for (int i = kVertices - 1; i > kept; --i) {
      std::swap(names[static_cast<std::size_t>(i)],
                names[static_cast<std::size_t>(random_.whole(kept, i))]);
    }
    for (Hyperedge& edge : edges) {
      std::ranges::transform(edge, edge.begin(), [&](std::uint8_t v) { return names[v]; });
      std::ranges::sort(edge);
    }
    std::rotate(edges.begin(),
                edges.begin() + random_.whole(0, static_cast<int>(edges.size()) - 1),
                edges.end());
    return edges;
  }

  static constexpr int kVertices = 9;
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(HypergraphForms, HangNeitherOnNamesNorOnOrder) {
  const auto edges = random_edges();
  const auto form = canonical_form(edges, 3);

  EXPECT_EQ(canonical_form(renamed(edges, 3), 3).word, form.word);
  EXPECT_EQ(canonical_form(form.word, 3).word, form.word);
}

TEST_P(HypergraphForms, HaveAutomorphismsThatKeepTheWord) {
  const auto form = canonical_form(random_edges(), 3);

  for (const VertexMap& map : form.automorphisms) {
    std::vector<Hyperedge> image = form.word;
    for (Hyperedge& edge : image) {
      std::ranges::transform(edge, edge.begin(), [&](std::uint8_t v) { return map[v]; });
      std::ranges::sort(edge);
    }
    std::ranges::sort(image);
    EXPECT_EQ(image, form.word);
    EXPECT_TRUE(std::equal(map.begin(), map.begin() + 3, VertexMap{0, 1, 2}.begin()));
  }
}

TEST_P(HypergraphForms, BeginWithForms) {
  auto word = canonical_form(random_edges(), 3).word;
  word.pop_back();

  EXPECT_EQ(canonical_form(word, 3).word, word);
}

INSTANTIATE_TEST_SUITE_P(Random, HypergraphForms, ::testing::Range(0, 40));

}  // namespace
}  // namespace kinestat
