#include "couplings/internal/catalogue_row.hpp"

#include <cmath>

#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

char letter(int i) {
  return static_cast<char>('x' + i);
}

template <class Screws>
void number_alike(Screws& screws) {
  const Screws original = screws;
  for (std::size_t i = 0; i < screws.size(); ++i) {
    int before = 0;
    int all = 0;
    for (std::size_t j = 0; j < original.size(); ++j) {
      const bool is_alike = original[j].name == original[i].name;
      all += is_alike ? 1 : 0;
      before += is_alike && j < i ? 1 : 0;
    }
    if (all > 1) {
      screws[i].name += std::to_string(before + 1);
    }
  }
}

}  // namespace

template <class Scalar>
std::pair<Vec3Of<Scalar>, Vec3Of<Scalar>> transverse_to(const Vec3Of<Scalar>& a) {
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(value_of(a[i])) < std::abs(value_of(a[k]))) {
      k = i;
    }
  }
  Vec3Of<Scalar> t = -a[k] * a;
  t[k] = t[k] + Scalar(1.0);
  const Vec3Of<Scalar> first = unit_along<Scalar>(t);
  return {first, a.cross(first)};
}

template <class Scalar>
void CatalogueRow<Scalar>::turn_freely(const Vector& at) {
  for (int i = is_planar_ ? 2 : 0; i < 3; ++i) {
    turn({'w', letter(i)}, Vector::Unit(i), at);
  }
}

template <class Scalar>
void CatalogueRow<Scalar>::bear_all_forces(const Vector& at) {
  for (int i = 0; i < (is_planar_ ? 2 : 3); ++i) {
    bear_force({'R', letter(i)}, Vector::Unit(i), at);
  }
}

template <class Scalar>
void CatalogueRow<Scalar>::bear_all_couples() {
  for (int i = is_planar_ ? 2 : 0; i < 3; ++i) {
    bear_couple({'T', letter(i)}, Vector::Unit(i));
  }
}

template <class Scalar>
void CatalogueRow<Scalar>::slide_across(const AxisOf<Scalar>& axis) {
  for (const auto& [name, direction] : across(axis)) {
    slide("v" + name, direction);
  }
}

template <class Scalar>
void CatalogueRow<Scalar>::bear_forces_across(const AxisOf<Scalar>& axis, const Vector& at) {
  for (const auto& [name, direction] : across(axis)) {
    bear_force("R" + name, direction, at);
  }
}

template <class Scalar>
void CatalogueRow<Scalar>::bear_couples_across(const AxisOf<Scalar>& axis) {
  for (const auto& [name, direction] : across(axis)) {
    bear_couple("T" + name, direction);
  }
}

template <class Scalar>
CouplingScrewsOf<Scalar> CatalogueRow<Scalar>::take() {
  number_alike(screws_.freedoms);
  number_alike(screws_.constraints);
  return std::move(screws_);
}

template <class Scalar>
std::vector<std::pair<std::string, Vec3Of<Scalar>>> CatalogueRow<Scalar>::across(
    const AxisOf<Scalar>& axis) const {
  std::vector<std::pair<std::string, Vector>> result;
  if (axis.keyword != 0) {
    for (int i = 0; i < (is_planar_ ? 2 : 3); ++i) {
      if (letter(i) != axis.keyword) {
        result.emplace_back(std::string(1, letter(i)), Vector::Unit(i));
      }
    }
  } else if (is_planar_) {
    result.emplace_back("", Vector::UnitZ().cross(axis.direction));
  } else {
    const auto [first, second] = transverse_to<Scalar>(axis.direction);
    result.emplace_back("1", first);
    result.emplace_back("2", second);
  }
  return result;
}

template std::pair<Vec3, Vec3> transverse_to<double>(const Vec3&);
template std::pair<Vec3Of<Dual>, Vec3Of<Dual>> transverse_to<Dual>(const Vec3Of<Dual>&);
template class CatalogueRow<double>;
template class CatalogueRow<Dual>;
template std::pair<Vec3Of<ExactInput>, Vec3Of<ExactInput>> transverse_to<ExactInput>(
    const Vec3Of<ExactInput>&);
template class CatalogueRow<ExactInput>;

}  // namespace kinestat
