#include "dynamics/curve_loads.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/index.hpp"
#include "mechanism/cases/load_moment.hpp"

namespace kinestat {

namespace {

class CurveReader {
 public:
  CurveReader(const Mechanism& mechanism, const LoadState& place)
      : mechanism_(mechanism), place_(place) {}

  const std::optional<CurveObstacle>& obstacle() const { return obstacle_; }

  // Zero where an obstacle was found.
  double number(const MovingNumber& number, const std::string& name) {
    return number.law ? value(*number.law, name) : number.value;
  }

  double value(const NumberLaw<double>& law, const std::string& name) {
    std::vector<LawVariable<double>> variables;
    for (std::size_t i = 0; i < mechanism_.curves.size(); ++i) {
      const Curve& curve = mechanism_.curves[i];
      if (std::ranges::count(law.names(), curve.name) > 0) {
        variables.push_back(
            {.name = curve.name, .value = {.value = height(i), .dimension = curve.dimension}});
      }
    }
    if (obstacle_) {
      return 0.0;
    }
    const auto found = law.at(variables);
    if (const double* const number = std::get_if<double>(&found)) {
      return *number;
    }
    obstacle_ = CurveObstacle{.kind = CurveObstacle::Kind::no_value, .number = name};
    return 0.0;
  }

 private:
  void stop(CurveObstacle::Kind kind, std::size_t curve) {
    obstacle_ = CurveObstacle{.kind = kind, .curve = curve};
  }

  // As drawn and at rest a list is empty.
  static std::optional<double> of_freedom(const std::vector<std::optional<double>>& list,
                                          int freedom) {
    return list.empty() ? 0.0 : list[at(freedom)];
  }

  std::optional<double> argument(std::size_t i) {
    using enum CurveObstacle::Kind;
    const Curve& curve = mechanism_.curves[i];
    std::optional<double> found;
    switch (curve.over) {
      case Curve::Over::time:
        found = place_.time;
        break;
      case Curve::Over::position:
        found = of_freedom(place_.positions, curve.freedom);
        break;
      case Curve::Over::speed:
        found = of_freedom(place_.rates, curve.freedom);
        break;
    }
    if (!found) {
      stop(curve.over == Curve::Over::time       ? no_time
           : curve.over == Curve::Over::position ? no_position
                                                 : no_speed,
           i);
    }
    return found;
  }

  double height(std::size_t i) {
    if (obstacle_) {
      return 0.0;
    }
    const std::optional<double> place = argument(i);
    if (!place) {
      return 0.0;
    }
    const std::optional<CurvePoint> point = mechanism_.curves[i].point(*place);
    if (!point) {
      stop(CurveObstacle::Kind::outside, i);
      return 0.0;
    }
    return point->value;
  }

  const Mechanism& mechanism_;
  const LoadState& place_;
  std::optional<CurveObstacle> obstacle_;
};

Vec3 vector_of(const std::array<MovingNumber, 3>& numbers,
               const std::string& name,
               CurveReader& reader) {
  return {reader.number(numbers[0], name),
          reader.number(numbers[1], name),
          reader.number(numbers[2], name)};
}

Load load_of(const MovingLoad& load, CurveReader& reader) {
  const Vec3 force = load.turn * vector_of(load.force, load.name, reader);
  const Vec3 couple = load.turn * vector_of(load.couple, load.name, reader);
  const Vec3 moment = load.point ? moment_of_load(*load.point, force, couple) : couple;
  return {.name = load.name,
          .acts = {.body = load.body, .wrench = {.moment = moment, .force = force}},
          .point = load.point,
          .frame = load.frame,
          .where = load.where};
}

}  // namespace

std::variant<CurveNumbers, CurveObstacle> curve_numbers(const Mechanism& mechanism,
                                                        const Case& which,
                                                        const LoadState& place) {
  CurveReader reader(mechanism, place);
  CurveNumbers result;
  for (const MovingLoad& load : which.moving_loads) {
    result.loads.push_back(load_of(load, reader));
  }
  for (const Primary& action : which.actions) {
    result.actions.push_back(action.moves() ? reader.value(*action.law, action.given)
                                            : action.value);
  }
  for (const Spring& spring : mechanism.springs) {
    result.springs.push_back(reader.number(spring.force, spring.name));
  }
  if (reader.obstacle()) {
    return *reader.obstacle();
  }
  return result;
}

}  // namespace kinestat
