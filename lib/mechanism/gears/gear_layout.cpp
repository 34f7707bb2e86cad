#include "mechanism/gears/gear_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

// The turn from one axis to its neighbour, seen from where both stand off.
template <class Scalar>
struct Turn {
  Scalar cosine = 1.0;
  Scalar sine = 0.0;
};

// In the triangle of the distances a and b from their centre and c between the axes; by the law
// of cosines, and Heron's formula for the sine, which loses no digits in a flat triangle.
template <class Scalar>
Turn<Scalar> turn_between(const Scalar& a, const Scalar& b, const Scalar& c) {
  using std::sqrt;
  const double size = std::max({value_of(a), value_of(b), value_of(c)});
  const auto is_flat = [&](const Scalar& x, const Scalar& y, const Scalar& longest) {
    return value_of(x) + value_of(y) - value_of(longest) <= kSameValue * size;
  };
  if (is_flat(a, b, c)) {
    return {.cosine = -1.0, .sine = 0.0};
  }
  if (is_flat(a, c, b) || is_flat(b, c, a)) {
    return {};
  }
  const Scalar area = sqrt((a + b + c) * (a + b - c) * (a - b + c) * (b - a + c));
  return {.cosine = (a * a + b * b - c * c) / (Scalar(2.0) * a * b),
          .sine = area / (Scalar(2.0) * a * b)};
}

template <class Scalar>
class LayoutFinder {
 public:
  LayoutFinder(GearTrain train, const GearNumbersOf<Scalar>& numbers) : numbers_(numbers) {
    layout_.train = std::move(train);
  }

  std::optional<GearLayoutOf<Scalar>> find() {
    ask_distances();
    for (std::size_t p = 0; p < layout_.train.axes.size(); ++p) {
      if (!place(p)) {
        return std::nullopt;
      }
    }
    for (std::size_t m = 0; m < layout_.meshes.size(); ++m) {
      finish_mesh(m);
    }
    return std::move(layout_);
  }

 private:
  const Scalar& teeth(int member) const { return numbers_.teeth[at(member)]; }

  Scalar sum_of_teeth(std::size_t mesh) const {
    return teeth(layout_.train.first[mesh]) + teeth(layout_.train.second[mesh]);
  }

  void ask_distances() {
    using std::abs;
    layout_.meshes.resize(layout_.train.first.size());
    for (std::size_t m = 0; m < layout_.meshes.size(); ++m) {
      if (numbers_.module[m]) {
        layout_.meshes[m].asked = abs(sum_of_teeth(m)) * *numbers_.module[m] / Scalar(2.0);
      }
    }
  }

  // From the axis from which an axis stands off.
  std::optional<Scalar> distance_of(std::size_t index) const {
    if (numbers_.distance[index]) {
      return numbers_.distance[index];
    }
    const GearAxis& axis = layout_.train.axes[index];
    if (axis.is_in_line) {
      const std::optional<Scalar>& asked = layout_.meshes[at(axis.neighbour_mesh)].asked;
      return asked ? std::optional<Scalar>(distances_[at(axis.neighbour)] + *asked) : std::nullopt;
    }
    Scalar sum = 0.0;
    double count = 0.0;
    for (const int mesh : axis.on_centre) {
      if (const auto& asked = layout_.meshes[at(mesh)].asked) {
        sum = sum + *asked;
        count += 1.0;
      }
    }
    return count > 0.0 ? std::optional<Scalar>(sum / Scalar(count)) : std::nullopt;
  }

  bool place(std::size_t index) {
    const GearAxis& axis = layout_.train.axes[index];
    const std::optional<Scalar> distance = distance_of(index);
    distances_.push_back(distance.value_or(Scalar(0.0)));
    if (!distance) {
      return false;
    }
    const Vec3Of<Scalar> origin = centre(axis.about);
    if (axis.neighbour < 0) {
      layout_.centres.push_back(origin + *distance * Vec3Of<Scalar>::UnitY());
      return true;
    }
    const auto& asked = layout_.meshes[at(axis.neighbour_mesh)].asked;
    if (!asked) {
      return false;
    }
    const Scalar& beside = distances_[at(axis.neighbour)];
    const Turn<Scalar> turn =
        axis.is_in_line ? Turn<Scalar>{} : turn_between<Scalar>(beside, *distance, *asked);
    const Scalar side = axis.side == PlanetSide::left ? 1.0 : -1.0;
    const Vec3Of<Scalar> towards = (centre(axis.neighbour) - origin) / beside;
    const Vec3Of<Scalar> left = Vec3Of<Scalar>::UnitZ().cross(towards);
    layout_.centres.push_back(
        origin + *distance * Vec3Of<Scalar>(turn.cosine * towards + side * turn.sine * left));
    return true;
  }

  // Of an axis of the train, -1: the main axis.
  Vec3Of<Scalar> centre(int axis) const {
    return axis < 0 ? Vec3Of<Scalar>(Vec3Of<Scalar>::Zero()) : layout_.centres[at(axis)];
  }

  Vec3Of<Scalar> centre_of(int member) const { return centre(layout_.train.axis_of[at(member)]); }

  // Two gears on the main axis have no pitch point; gear_train_check has complained.
  void finish_mesh(std::size_t m) {
    using std::sqrt;
    MeshLayoutOf<Scalar>& mesh = layout_.meshes[m];
    const Vec3Of<Scalar> from = centre_of(layout_.train.first[m]);
    const Vec3Of<Scalar> along = centre_of(layout_.train.second[m]) - from;
    if (values_of<Scalar>(along).norm() > 0.0) {
      mesh.distance = sqrt(along.squaredNorm());
      mesh.tangent = unit_along<Scalar>(along.cross(Vec3Of<Scalar>::UnitZ()));
      mesh.pitch_point = from + teeth(layout_.train.first[m]) / sum_of_teeth(m) * along;
    }
    mesh.pitch_point[2] = numbers_.at[m];
  }

  const GearNumbersOf<Scalar>& numbers_;
  GearLayoutOf<Scalar> layout_;
  std::vector<Scalar> distances_;  ///< of the axes from those from which they stand off
};

}  // namespace

bool rings_fit(const GearTrain& train, const GearNumbers& numbers) {
  for (std::size_t m = 0; m < train.first.size(); ++m) {
    const double first = numbers.teeth[static_cast<std::size_t>(train.first[m])];
    const double second = numbers.teeth[static_cast<std::size_t>(train.second[m])];
    const bool is_internal = first < 0.0 || second < 0.0;
    if (is_internal && !(first + second < 0.0)) {
      return false;
    }
  }
  return true;
}

template <class Scalar>
Vec3Of<Scalar> GearLayoutOf<Scalar>::axis_of(std::string_view tail, std::string_view head) const {
  const int axis = train.axis_between(tail, head);
  return axis < 0 ? Vec3Of<Scalar>(Vec3Of<Scalar>::Zero())
                  : centres[static_cast<std::size_t>(axis)];
}

template <class Scalar>
std::optional<GearLayoutOf<Scalar>> find_layout(GearTrain train,
                                                const GearNumbersOf<Scalar>& numbers) {
  return LayoutFinder<Scalar>(std::move(train), numbers).find();
}

template struct GearLayoutOf<double>;
template struct GearLayoutOf<Dual>;
template std::optional<GearLayout> find_layout(GearTrain, const GearNumbersOf<double>&);
template std::optional<GearLayoutOf<Dual>> find_layout(GearTrain, const GearNumbersOf<Dual>&);
template struct GearLayoutOf<ExactInput>;
template std::optional<GearLayoutOf<ExactInput>> find_layout(GearTrain,
                                                             const GearNumbersOf<ExactInput>&);

}  // namespace kinestat
