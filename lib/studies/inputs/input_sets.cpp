#include "studies/inputs/input_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense/smallest_singular_value.hpp"
#include "math/dense/span.hpp"
#include "math/elimination/echelon.hpp"
#include "studies/inputs/internal/cobasis_search.hpp"

namespace kinestat {

namespace {

constexpr std::uint64_t kMostCounted = 10'000'000;
constexpr std::size_t kMostRanked = 100'000;
constexpr double kMostRankingWork = 4e8;  // of which a set takes the cube of its magnitudes

// Magnitudes that occur in solutions of the echelon form together, and these solutions.
struct Part {
  std::vector<int> magnitudes;
  std::vector<int> solutions;
};

int root_of(std::vector<int>& parents, int i) {
  while (parents[static_cast<std::size_t>(i)] != i) {
    i = parents[static_cast<std::size_t>(i)] =
        parents[static_cast<std::size_t>(parents[static_cast<std::size_t>(i)])];
  }
  return i;
}

// The connected components of the matroid: those of the graph that joins a solution of the reduced
// form with the magnitudes that it has. In the order of their first magnitudes.
std::vector<Part> find_parts(const MatX& echelon) {
  const auto solutions = static_cast<int>(echelon.rows());
  std::vector<int> parents(static_cast<std::size_t>(solutions));
  std::iota(parents.begin(), parents.end(), 0);
  for (Eigen::Index m = 0; m < echelon.cols(); ++m) {
    int first = -1;
    for (int s = 0; s < solutions; ++s) {
      if (echelon(s, m) == 0.0) {
        continue;
      }
      if (first >= 0) {
        parents[static_cast<std::size_t>(root_of(parents, s))] = root_of(parents, first);
      }
      first = s;
    }
  }
  std::vector<Part> parts;
  std::vector<int> part_of(static_cast<std::size_t>(solutions), -1);
  for (Eigen::Index m = 0; m < echelon.cols(); ++m) {
    for (int s = 0; s < solutions; ++s) {
      if (echelon(s, m) == 0.0) {
        continue;
      }
      int& part = part_of[static_cast<std::size_t>(root_of(parents, s))];
      if (part < 0) {
        part = static_cast<int>(parts.size());
        parts.emplace_back();
      }
      parts[static_cast<std::size_t>(part)].magnitudes.push_back(static_cast<int>(m));
      break;
    }
  }
  for (int s = 0; s < solutions; ++s) {
    const int part = part_of[static_cast<std::size_t>(root_of(parents, s))];
    if (part >= 0) {
      parts[static_cast<std::size_t>(part)].solutions.push_back(s);
    }
  }
  return parts;
}

bool has(const std::vector<int>& list, int item) {
  return std::ranges::find(list, item) != list.end();
}

// What differs by rounding alone is equal, so that the order does not depend on it.
bool is_better(const InputSet& a, const InputSet& b) {
  const double larger = std::max(a.conditioning, b.conditioning);
  const bool is_same = std::abs(a.conditioning - b.conditioning) <= kReportsAgree * larger;
  return is_same ? a.magnitudes < b.magnitudes : a.conditioning > b.conditioning;
}

// The sets of one part; its rows of the echelon form are made orthonormal first.
class GroupSearch {
 public:
  GroupSearch(const MatX& echelon, const Part& part, const InputChoice& choice)
      : choice_(choice),
        rows_(orthonormal_range(echelon(part.solutions, part.magnitudes).transpose()).transpose()) {
    group_.magnitudes = part.magnitudes;
    group_.needed = static_cast<int>(part.solutions.size());
    const double work = std::pow(group_.needed, 3);
    most_ranked_ = std::min(static_cast<double>(kMostRanked), kMostRankingWork / work);
  }

  InputGroup run() {
    std::vector<int> required;
    std::vector<int> allowed;
    for (std::size_t i = 0; i < group_.magnitudes.size(); ++i) {
      const int magnitude = group_.magnitudes[i];
      if (has(choice_.required, magnitude)) {
        required.push_back(static_cast<int>(i));
      } else if (choice_.among.empty() || has(choice_.among, magnitude)) {
        allowed.push_back(static_cast<int>(i));
      }
    }
    CobasisSearch search(rows_, std::move(required), std::move(allowed));
    group_.is_complete = search.run([this](const std::vector<int>& columns) {
      note(columns);
      return group_.count < kMostCounted;
    });
    keep_best();
    return std::move(group_);
  }

 private:
  void note(const std::vector<int>& columns) {
    ++group_.count;
    if (choice_.listed == 0 || static_cast<double>(group_.count) > most_ranked_) {
      return;
    }
    InputSet set;
    set.conditioning = smallest_singular_value(rows_(Eigen::all, columns));
    for (const int c : columns) {
      set.magnitudes.push_back(group_.magnitudes[static_cast<std::size_t>(c)]);
    }
    std::ranges::sort(set.magnitudes);
    group_.best.push_back(std::move(set));
  }

  void keep_best() {
    std::ranges::sort(group_.best, is_better);
    group_.best.resize(std::min(group_.best.size(), choice_.listed));
  }

  const InputChoice& choice_;
  MatX rows_;
  InputGroup group_;
  double most_ranked_ = 0.0;
};

}  // namespace

std::uint64_t InputSets::count() const {
  std::uint64_t product = 1;
  for (const InputGroup& group : groups) {
    if (group.count != 0 && product > kMostSets / group.count) {
      product = kMostSets;
    } else {
      product *= group.count;
    }
  }
  return product;
}

bool InputSets::is_complete() const {
  return count() < kMostSets &&
         std::ranges::all_of(groups, [](const InputGroup& group) { return group.is_complete; });
}

InputSets find_input_sets(const MatX& solutions, const InputChoice& choice) {
  InputSets result;
  result.needed = static_cast<int>(solutions.cols());
  for (Eigen::Index m = 0; m < solutions.rows(); ++m) {
    if (solutions.cols() == 0 || solutions.row(m).isZero(0.0)) {
      result.always_zero.push_back(static_cast<int>(m));
    }
  }
  const MatX echelon = find_echelon(solutions.transpose()).matrix;
  for (const Part& part : find_parts(echelon)) {
    result.groups.push_back(GroupSearch(echelon, part, choice).run());
  }
  return result;
}

double conditioning_of(const MatX& solutions, std::span<const int> magnitudes) {
  const MatX rows = orthonormal_range(solutions);
  return smallest_singular_value(
      rows(std::vector<int>(magnitudes.begin(), magnitudes.end()), Eigen::all));
}

}  // namespace kinestat
