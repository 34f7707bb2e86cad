// Structures against nauty (McKay and Piperno), where it is installed: libnauty2-dev.
#include <gtest/gtest.h>

#ifdef KINESTAT_HAS_NAUTY

#include <algorithm>
#include <bit>
#include <set>
#include <vector>

extern "C" {
#include <nauty/nauty.h>
}

#include "studies/transmissions/structure.hpp"

namespace kinestat {
namespace {

using Sets = std::vector<SetShafts>;

// A graph of shafts and sets, each set joined to its three shafts.
struct ShaftGraph {
  std::vector<graph> canonical;
  double automorphisms = 0.0;
};

// Housing, input, output, the other shafts, and the sets have a colour each.
ShaftGraph canonise(int shafts, const Sets& sets) {
  const int n = shafts + static_cast<int>(sets.size());
  const int m = SETWORDSNEEDED(n);
  std::vector<graph> drawn(static_cast<std::size_t>(n * m));
  ShaftGraph result{.canonical = drawn};
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (const Shaft shaft : sets[s]) {
      ADDONEEDGE(drawn.data(), shaft, shafts + static_cast<int>(s), m);
    }
  }
  std::vector<int> labels(static_cast<std::size_t>(n));
  std::vector<int> cells(static_cast<std::size_t>(n), 1);
  std::vector<int> orbits(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    labels[static_cast<std::size_t>(i)] = i;
    const bool ends = i < 3 || i == shafts - 1 || i == n - 1;
    cells[static_cast<std::size_t>(i)] = ends ? 0 : 1;
  }
  DEFAULTOPTIONS_GRAPH(options);
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  statsblk stats{};
  densenauty(drawn.data(),
             labels.data(),
             cells.data(),
             orbits.data(),
             &options,
             &stats,
             m,
             n,
             result.canonical.data());
  result.automorphisms = stats.grpsize1;
  return result;
}

// Whether q of the sets stand on fewer than q + 2 shafts.
bool has_block(const Sets& sets) {
  for (unsigned choice = 1; choice < 1U << sets.size(); ++choice) {
    std::set<Shaft> shafts;
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if ((choice >> s & 1U) != 0) {
        shafts.insert(sets[s].begin(), sets[s].end());
      }
    }
    if (static_cast<int>(shafts.size()) < std::popcount(choice) + 2) {
      return true;
    }
  }
  return false;
}

// All ways to put sets one after the other on shafts, which are numbered as they are first touched;
// up to isomorphism all that there are, most of them many times.
class AllSets {
 public:
  AllSets(int sets, int shafts) : count_(static_cast<std::size_t>(sets)), shafts_(shafts) {
    extend(3);
  }

  std::set<std::vector<graph>> take() { return std::move(found_); }

 private:
  void extend(int touched) {
    if (sets_.size() == count_) {
      if (touched == shafts_ && !has_block(sets_)) {
        found_.insert(canonise(shafts_, sets_).canonical);
      }
      return;
    }
    for (int a = 0; a <= touched; ++a) {
      for (int b = a + 1; b <= std::max(a, touched - 1) + 1; ++b) {
        for (int c = b + 1; c <= std::max(b, touched - 1) + 1; ++c) {
          if (c < shafts_) {
            sets_.push_back({static_cast<Shaft>(a), static_cast<Shaft>(b), static_cast<Shaft>(c)});
            extend(std::max(touched, c + 1));
            sets_.pop_back();
          }
        }
      }
    }
  }

  std::size_t count_;
  int shafts_;
  Sets sets_;
  std::set<std::vector<graph>> found_;
};

struct Size {
  int sets;
  int engaged;
};

class StructuresByNauty : public ::testing::TestWithParam<Size> {};

TEST_P(StructuresByNauty, AreAsManyWithTheSameSymmetries) {
  const auto [sets, engaged] = GetParam();
  const int shafts = sets + engaged + 2;
  const std::set<std::vector<graph>> all = AllSets(sets, shafts).take();
  const std::vector<TransmissionStructure> structures = enumerate_structures(sets, engaged, 0);
  EXPECT_EQ(structures.size(), all.size());
  std::set<std::vector<graph>> named;
  for (const TransmissionStructure& structure : structures) {
    const ShaftGraph one = canonise(shafts, structure.sets);
    EXPECT_TRUE(all.contains(one.canonical));
    EXPECT_EQ(static_cast<double>(structure.automorphisms.size()), one.automorphisms);
    named.insert(one.canonical);
  }
  EXPECT_EQ(named.size(), structures.size());
}

INSTANTIATE_TEST_SUITE_P(Nauty,
                         StructuresByNauty,
                         ::testing::Values(Size{1, 1},
                                           Size{2, 1},
                                           Size{2, 2},
                                           Size{3, 1},
                                           Size{3, 2},
                                           Size{3, 3},
                                           Size{4, 2},
                                           Size{4, 3},
                                           Size{4, 4}),
                         [](const auto& test) {
                           return "Sets" + std::to_string(test.param.sets) + "Engaged" +
                                  std::to_string(test.param.engaged);
                         });

}  // namespace
}  // namespace kinestat

#else

TEST(StructuresByNauty, AreAsManyWithTheSameSymmetries) {
  GTEST_SKIP() << "nauty is not installed";
}

#endif
