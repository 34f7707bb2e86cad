#include "studies/transmissions/generic_train.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "math/sampling/counter_based_random.hpp"

namespace kinestat {

namespace {

using Residue = MersenneResidue;

constexpr std::uint64_t kSeed = 0x7472'6169'6e73'2121;
constexpr std::uint8_t kNoClass = 0xff;

Residue draw(std::uint64_t number) {
  return Residue(CounterBasedRandom(kSeed).at(0, number));
}

// w_0 + t w_1 - (1 + t) w_2 = 0, which says all that some stationary ratio does.
SetEquation<Residue> equation_with(Residue t) {
  return {Residue(1), t, -(Residue(1) + t)};
}

// Where the shafts are as points, with the housing at the origin: the null space of the equations.
class ShaftPoints {
 public:
  using Point = std::vector<Residue>;

  ShaftPoints(const TransmissionStructure& structure,
              std::span<const SetEquation<Residue>> equations)
      : points_(static_cast<std::size_t>(structure.shafts)) {
    const std::size_t shafts = points_.size();
    std::vector<Point> rows(structure.sets.size(), Point(shafts));
    for (std::size_t s = 0; s < rows.size(); ++s) {
      for (std::size_t i = 0; i < 3; ++i) {
        rows[s][structure.sets[s][i]] = equations[s][i];
      }
      rows[s][kHousing] = Residue(0);
    }
    eliminate(rows);
  }

  // From one shaft to the other, the first coordinate that is not zero made one.
  Point direction(const ShaftPair& pair) const {
    Point result = points_[pair[1]];
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] -= points_[pair[0]][i];
    }
    const auto first = std::ranges::find_if(result, [](Residue value) { return !value.is_zero(); });
    const Residue factor = first != result.end() ? first->inverse() : Residue(1);
    for (Residue& value : result) {
      value *= factor;
    }
    return result;
  }

 private:
  void eliminate(std::vector<Point>& rows) {
    const std::size_t shafts = points_.size();
    std::vector<std::size_t> row_of(shafts, rows.size());
    std::size_t done = 0;
    for (std::size_t column = 1; column < shafts && done < rows.size(); ++column) {
      const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(done),
                                      rows.end(),
                                      [&](const Point& row) { return !row[column].is_zero(); });
      if (pivot == rows.end()) {
        continue;
      }
      std::swap(rows[done], *pivot);
      const Residue factor = rows[done][column].inverse();
      for (Residue& value : rows[done]) {
        value *= factor;
      }
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const Residue multiple = rows[r][column];
        for (std::size_t j = 0; r != done && j < shafts; ++j) {
          rows[r][j] -= multiple * rows[done][j];
        }
      }
      row_of[column] = done++;
    }
    for (std::size_t shaft = 0; shaft < shafts; ++shaft) {
      for (std::size_t free = 1; free < shafts; ++free) {
        if (row_of[free] == rows.size()) {
          points_[shaft].push_back(row_of[shaft] == rows.size() ? Residue(shaft == free ? 1 : 0)
                                                                : -rows[row_of[shaft]][free]);
        }
      }
    }
  }

  std::vector<Point> points_;
};

// All inverses for the price of one (Montgomery).
void invert_all(std::vector<Residue>& values) {
  std::vector<Residue> before;
  Residue product(1);
  for (const Residue value : values) {
    before.push_back(product);
    product *= value.is_zero() ? Residue(1) : value;
  }
  Residue rest = product.inverse();
  for (std::size_t i = values.size(); i-- > 0;) {
    if (!values[i].is_zero()) {
      const Residue inverse = rest * before[i];
      rest *= values[i];
      values[i] = inverse;
    }
  }
}

// Equal values have equal numbers.
std::vector<std::uint32_t> numbered(const std::vector<Residue>& values) {
  std::vector<Residue> sorted = values;
  std::ranges::sort(sorted);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::uint32_t> numbers;
  for (const Residue value : values) {
    numbers.push_back(
        static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, value) - sorted.begin()));
  }
  return numbers;
}

}  // namespace

GenericTrain::GenericTrain(const TransmissionStructure& structure, int engaged)
    : structure_(structure), engaged_(engaged), minors_(structure) {
  find_classes();
  binomials_.resize(classes_.size() + 1);
  for (std::size_t n = 0; n < binomials_.size(); ++n) {
    for (std::size_t k = 0; k < kMostEngaged; ++k) {  // [n][k]: n over k + 1
      const std::size_t left = n == 0 ? 0 : binomials_[n - 1][k];
      const std::size_t right = n == 0 ? 0 : k == 0 ? 1 : binomials_[n - 1][k - 1];
      binomials_[n][k] = left + right;
    }
  }
  find_terms();
  decide_states();
}

void GenericTrain::find_classes() {
  const ShaftPoints points(structure_, drawn_equations());
  std::map<std::vector<Residue>, std::size_t> known;
  for (auto& row : class_of_) {
    row.fill(kNoClass);
  }
  for (int a = 0; a < structure_.shafts; ++a) {
    for (int b = a + 1; b < structure_.shafts; ++b) {
      const ShaftPair pair = {static_cast<Shaft>(a), static_cast<Shaft>(b)};
      if (a == kHousing && (b == kInput || b == kOutput)) {
        continue;
      }
      const auto [place, is_new] = known.emplace(points.direction(pair), classes_.size());
      if (is_new) {
        classes_.emplace_back();
      }
      classes_[place->second].push_back(pair);
      class_of_[pair[0]][pair[1]] = static_cast<std::uint8_t>(place->second);
    }
  }
}

std::vector<SetEquation<MersenneResidue>> GenericTrain::drawn_equations() const {
  std::vector<SetEquation<Residue>> equations;
  for (std::size_t s = 0; s < structure_.sets.size(); ++s) {
    equations.push_back(equation_with(draw(s)));
  }
  return equations;
}

std::size_t GenericTrain::state_of(ClassMask engaged) const {
  std::size_t number = 0;
  for (std::size_t k = 0; engaged != 0; ++k, engaged &= engaged - 1) {
    number += binomials_[static_cast<std::size_t>(std::countr_zero(engaged))][k];
  }
  return number;
}

void GenericTrain::find_terms() {
  std::array<std::size_t, kMostEngaged> chosen{};
  const auto count = static_cast<std::size_t>(engaged_);
  for (std::size_t i = 0; i < count; ++i) {
    chosen[i] = i;
  }
  first_terms_.push_back(0);
  while (chosen[count - 1] < classes_.size()) {
    std::array<ShaftPair, kMostEngaged> joined{};
    for (std::size_t i = 0; i < count; ++i) {
      joined[i] = classes_[chosen[i]].front();
    }
    states_.emplace_back();
    if (const auto merged =
            MergedShafts::merge(structure_.shafts, std::span(joined).first(count))) {
      for (const Shaft shaft : {kInput, kOutput}) {
        const auto terms = minors_.speed_terms(*merged, merged->of(shaft));
        terms_.insert(terms_.end(), terms.begin(), terms.end());
        first_terms_.push_back(static_cast<std::uint32_t>(terms_.size()));
      }
    } else {
      first_terms_.insert(first_terms_.end(), 2, static_cast<std::uint32_t>(terms_.size()));
    }
    std::size_t i = 0;  // the next choice: the first that may step on does, those before start anew
    while (i + 1 < count && chosen[i] + 1 == chosen[i + 1]) {
      chosen[i] = i;
      ++i;
    }
    ++chosen[i];
  }
}

std::span<const MinorTerm> GenericTrain::terms(std::size_t number) const {
  return std::span(terms_).subspan(first_terms_[number],
                                   first_terms_[number + 1] - first_terms_[number]);
}

// Zero where a state is no gear.
std::vector<Residue> GenericTrain::ratios_with(
    std::span<const SetEquation<Residue>> equations) const {
  std::vector<Residue> minors(minors_.count());
  minors_.evaluate<Residue>(equations, minors);
  std::vector<Residue> outputs;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    outputs.push_back(SetMinors::sum<Residue>(output_terms(i), minors));
  }
  invert_all(outputs);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    outputs[i] *= SetMinors::sum<Residue>(input_terms(i), minors);
  }
  return outputs;
}

void GenericTrain::decide_states() {
  std::vector<SetEquation<Residue>> equations = drawn_equations();
  const std::vector<Residue> ratios = ratios_with(equations);
  const std::vector<std::uint32_t> numbers = numbered(ratios);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].is_gear = !ratios[i].is_zero();
    states_[i].is_direct = ratios[i] == Residue(1);
    states_[i].ratio = numbers[i];
  }
  std::vector<Residue> inverses = ratios;
  invert_all(inverses);
  for (std::size_t s = 0; s < equations.size(); ++s) {
    const SetEquation<Residue> kept = std::exchange(equations[s], equation_with(draw(100 + s)));
    std::vector<Residue> changes = ratios_with(equations);
    equations[s] = kept;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      changes[i] *= inverses[i];
    }
    const std::vector<std::uint32_t> changed = numbered(changes);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      states_[i].change[s] = changed[i];
    }
  }
}

std::vector<std::uint8_t> GenericTrain::class_map(const VertexMap& automorphism) const {
  std::vector<std::uint8_t> map;
  for (const ElementClass& one : classes_) {
    const auto [a, b] = std::minmax({automorphism[one.front()[0]], automorphism[one.front()[1]]});
    map.push_back(class_of_[a][b]);
  }
  return map;
}

}  // namespace kinestat
