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

// What all groups may take together, some seconds.
struct Allowance {
  std::uint64_t counted = 10'000'000;   // sets
  std::uint64_t work = 4'000'000'000;   // entries of the search
  std::uint64_t ranked = 1'000'000;     // sets, of one group a tenth
  std::uint64_t ranking = 400'000'000;  // of which a set takes the cube of its magnitudes

  // For one of so many groups that are still to be searched: what it leaves is for the others.
  Allowance share(std::size_t groups) const {
    return {counted / groups,
            work / groups,
            std::min<std::uint64_t>(ranked / groups, 100'000),
            ranking / groups};
  }
};

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
  GroupSearch(const MatX& echelon,
              const Part& part,
              const InputChoice& choice,
              const Allowance& most)
      : choice_(choice),
        most_(most),
        rows_(orthonormal_range(echelon(part.solutions, part.magnitudes).transpose()).transpose()) {
    group_.magnitudes = part.magnitudes;
    group_.needed = static_cast<int>(part.solutions.size());
    const auto needed = static_cast<std::uint64_t>(group_.needed);
    ranking_of_a_set_ = needed * needed * needed;
  }

  // Takes from the allowance of all what it takes.
  InputGroup run(Allowance& left) {
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
    group_.is_complete = search.run(most_.work, [this](const std::vector<int>& columns) {
      note(columns);
      return group_.count < most_.counted;
    });
    left.counted -= std::min(left.counted, group_.count);
    left.work -= std::min(left.work, search.work());
    left.ranked -= group_.best.size();
    left.ranking -= group_.best.size() * ranking_of_a_set_;
    keep_best();
    return std::move(group_);
  }

 private:
  void note(const std::vector<int>& columns) {
    ++group_.count;
    const std::uint64_t ranked = group_.best.size() + 1;
    if (choice_.listed == 0 || ranked > most_.ranked ||
        ranked * ranking_of_a_set_ > most_.ranking) {
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
  Allowance most_;
  MatX rows_;
  InputGroup group_;
  std::uint64_t ranking_of_a_set_ = 0;
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
  const std::vector<Part> parts = find_parts(echelon);
  Allowance left;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Allowance most = left.share(parts.size() - i);
    result.groups.push_back(GroupSearch(echelon, parts[i], choice, most).run(left));
  }
  return result;
}

double conditioning_of(const MatX& solutions, std::span<const int> magnitudes) {
  const MatX rows = orthonormal_range(solutions);
  return smallest_singular_value(
      rows(std::vector<int>(magnitudes.begin(), magnitudes.end()), Eigen::all));
}

}  // namespace kinestat
