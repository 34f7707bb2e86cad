#include "property/precise_motion.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kinestat {

namespace {

using Number = BigFloat;
using Vector = std::array<Number, 3>;
using Matrix = std::array<Vector, 3>;

Vector cross_of(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector operator*(const Number& a, const Vector& b) {
  return {a * b[0], a * b[1], a * b[2]};
}

Vector operator*(const Matrix& m, const Vector& v) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  }
  return result;
}

Vector precise(const Vec3& v) {
  return {Number(v[0]), Number(v[1]), Number(v[2])};
}

struct Pose {
  Matrix rotation = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  Vector shift = {0, 0, 0};

  Vector point(const Vector& p) const { return rotation * p + shift; }
};

struct Line {
  Vector axis;
  Vector point;
  Number pitch = 0;
  bool is_turn = true;
};

Line line_of(const ElementaryMotion& motion) {
  const Vector d = precise(motion.direction);
  const Number length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return {.axis = (1 / length) * d,
          .point = precise(motion.point),
          .pitch = Number(motion.pitch),
          .is_turn = motion.kind == ElementaryKind::turn};
}

Pose operator*(const Pose& a, const Pose& b) {
  Pose result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.rotation[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        result.rotation[i][j] += a.rotation[i][k] * b.rotation[k][j];
      }
    }
  }
  result.shift = a.point(b.shift);
  return result;
}

Pose displaced(const Line& line, const Number& q) {
  Pose result;
  if (!line.is_turn) {
    result.shift = q * line.axis;
    return result;
  }
  const Number c = cos(q);
  const Number s = sin(q);
  const Vector& a = line.axis;
  const Matrix skew = {Vector{0, -a[2], a[1]}, Vector{a[2], 0, -a[0]}, Vector{-a[1], a[0], 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.rotation[i][j] = (i == j ? c : Number(0)) + (1 - c) * a[i] * a[j] + s * skew[i][j];
    }
  }
  const Vector turned = result.rotation * line.point;
  result.shift = line.point + (q * line.pitch) * a + Number(-1) * turned;
  return result;
}

// Where the drawn line is in a pose, as a screw.
PreciseTwist screw_of(const Line& line, const Pose& pose) {
  const Vector a = pose.rotation * line.axis;
  const Vector moment = cross_of(pose.point(line.point), a) + line.pitch * a;
  return line.is_turn ? PreciseTwist{a[0], a[1], a[2], moment[0], moment[1], moment[2]}
                      : PreciseTwist{0, 0, 0, a[0], a[1], a[2]};
}

PreciseTwist bracket(const PreciseTwist& a, const PreciseTwist& b) {
  const Vector wa = {a[0], a[1], a[2]};
  const Vector va = {a[3], a[4], a[5]};
  const Vector wb = {b[0], b[1], b[2]};
  const Vector vb = {b[3], b[4], b[5]};
  const Vector angular = cross_of(wa, wb);
  const Vector linear = cross_of(wa, vb) + cross_of(va, wb);
  return {angular[0], angular[1], angular[2], linear[0], linear[1], linear[2]};
}

void add(PreciseTwist& sum, const Number& factor, const PreciseTwist& one) {
  for (std::size_t i = 0; i < 6; ++i) {
    sum[i] += factor * one[i];
  }
}

// A body with the screws that move it, one a freedom.
struct Placed {
  Pose pose;
  std::vector<PreciseTwist> screws;
  PreciseTwist twist = {};
  PreciseTwist twist_rate = {};
};

class Search {
 public:
  Search(const Mechanism& mechanism,
         std::span<const FiniteLaw> laws,
         std::span<const PreciseDrive> drives,
         std::span<const double> near)
      : topology_(mechanism.topology), drives_(drives) {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.coupling(CouplingId{e});
      std::vector<std::pair<int, Line>>& chain = chains_.emplace_back();
      for (const ElementaryMotion& motion : laws[static_cast<std::size_t>(e)].chain) {
        chain.emplace_back(coupling.first_freedom + motion.freedom, line_of(motion));
      }
    }
    const auto count = topology_.freedoms.size();
    is_driven_.assign(count, false);
    for (const double q : near) {
      found_.positions.emplace_back(q);
    }
    found_.rates.assign(count, Number(0));
    found_.rate_rates = found_.rates;
    for (const PreciseDrive& drive : drives) {
      const auto f = static_cast<std::size_t>(drive.freedom);
      is_driven_[f] = true;
      found_.positions[f] = drive.position;
    }
  }

  PreciseMotion find() {
    for (int round = 0; round < 12; ++round) {
      place();
      const std::vector<Number> step = solve(misses_, found_.positions);
      for (std::size_t f = 0; f < step.size(); ++f) {
        found_.positions[f] += step[f];
      }
    }
    place();
    found_.miss = 0.0;
    for (const Number& one : misses_) {
      found_.miss = std::max(found_.miss, std::abs(one.convert_to<double>()));
    }
    for (const PreciseDrive& drive : drives_) {
      found_.rates[static_cast<std::size_t>(drive.freedom)] = drive.speed;
      found_.rate_rates[static_cast<std::size_t>(drive.freedom)] = drive.acceleration;
    }
    place();
    add_all(found_.rates, solve(twist_misses_, found_.rates));
    place();
    add_all(found_.rate_rates, solve(rate_misses_, found_.rate_rates));
    place();
    for (const std::optional<Placed>& body : bodies_) {
      found_.twists.push_back(body->twist);
      found_.twist_rates.push_back(body->twist_rate);
    }
    return found_;
  }

 private:
  static void add_all(std::vector<Number>& values, const std::vector<Number>& more) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += more[i];
    }
  }

  // By a chain from its tail to its head, or backwards.
  Placed carried(const Placed& from, std::size_t coupling, bool is_forward) const {
    Placed result = from;
    const auto& chain = chains_[coupling];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const auto& [freedom, line] = is_forward ? chain[i] : chain[chain.size() - 1 - i];
      const auto f = static_cast<std::size_t>(freedom);
      const Number sense = is_forward ? 1 : -1;
      const PreciseTwist screw = screw_of(line, result.pose);
      add(result.twist_rate, sense * found_.rates[f], bracket(result.twist, screw));
      add(result.twist_rate, sense * found_.rate_rates[f], screw);
      add(result.twist, sense * found_.rates[f], screw);
      add(result.screws[f], sense, screw);
      result.pose = result.pose * displaced(line, sense * found_.positions[f]);
    }
    return result;
  }

  void place() {
    bodies_.assign(topology_.bodies.size(), std::nullopt);
    bodies_[0] = Placed{.pose = {},
                        .screws = std::vector<PreciseTwist>(topology_.freedoms.size()),
                        .twist = {},
                        .twist_rate = {}};
    std::vector<bool> is_used(chains_.size(), false);
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t e = 0; e < chains_.size(); ++e) {
        const CouplingTopology& coupling = topology_.coupling(CouplingId{static_cast<int>(e)});
        auto& tail = bodies_[static_cast<std::size_t>(coupling.tail.value)];
        auto& head = bodies_[static_cast<std::size_t>(coupling.head.value)];
        if (tail.has_value() != head.has_value()) {
          (tail ? head : tail) = carried(tail ? *tail : *head, e, tail.has_value());
          is_used[e] = true;
          goes_on = true;
        }
      }
    }
    misses_.clear();
    twist_misses_.clear();
    rate_misses_.clear();
    rows_.clear();
    for (std::size_t e = 0; e < chains_.size(); ++e) {
      if (!is_used[e]) {
        const CouplingTopology& coupling = topology_.coupling(CouplingId{static_cast<int>(e)});
        close(carried(*bodies_[static_cast<std::size_t>(coupling.tail.value)], e, true),
              *bodies_[static_cast<std::size_t>(coupling.head.value)]);
      }
    }
  }

  // Six rows that say that both are one.
  void close(const Placed& one, const Placed& other) {
    Pose back;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        back.rotation[i][j] = other.pose.rotation[j][i];
      }
    }
    back.shift = Number(-1) * (back.rotation * other.pose.shift);
    const Pose apart = one.pose * back;
    const Matrix& m = apart.rotation;
    misses_.push_back((m[2][1] - m[1][2]) / 2);
    misses_.push_back((m[0][2] - m[2][0]) / 2);
    misses_.push_back((m[1][0] - m[0][1]) / 2);
    misses_.insert(misses_.end(), apart.shift.begin(), apart.shift.end());
    for (std::size_t i = 0; i < 6; ++i) {
      std::vector<Number>& row = rows_.emplace_back();
      for (std::size_t f = 0; f < one.screws.size(); ++f) {
        row.push_back(is_driven_[f] ? Number(0) : one.screws[f][i] - other.screws[f][i]);
      }
      twist_misses_.push_back(one.twist[i] - other.twist[i]);
      rate_misses_.push_back(one.twist_rate[i] - other.twist_rate[i]);
    }
  }

  // What brings the misses to zero, by elimination with complete pivoting. Rows that depend on
  // others miss nothing.
  std::vector<Number> solve(std::vector<Number> right, const std::vector<Number>& like) const {
    std::vector<std::vector<Number>> m = rows_;
    std::vector<Number> result(like.size(), Number(0));
    std::vector<std::pair<std::size_t, std::size_t>> pivots;
    std::vector<bool> is_taken(m.size(), false);
    for (std::size_t k = 0; k < m.size(); ++k) {
      std::size_t r = 0;
      std::size_t c = 0;
      Number largest = 0;
      for (std::size_t i = 0; i < m.size(); ++i) {
        for (std::size_t j = 0; !is_taken[i] && j < like.size(); ++j) {
          if (abs(m[i][j]) > largest) {
            largest = abs(m[i][j]);
            r = i;
            c = j;
          }
        }
      }
      // While Newton is on its way, rows depend on each other but for what is missed.
      if (largest < Number("1e-12")) {
        break;
      }
      is_taken[r] = true;
      pivots.emplace_back(r, c);
      for (std::size_t i = 0; i < m.size(); ++i) {
        if (i != r && m[i][c] != 0) {
          const Number factor = m[i][c] / m[r][c];
          for (std::size_t j = 0; j < like.size(); ++j) {
            m[i][j] -= factor * m[r][j];
          }
          right[i] -= factor * right[r];
        }
      }
    }
    for (const auto& [r, c] : pivots) {
      result[c] = -right[r] / m[r][c];
    }
    return result;
  }

  const Topology& topology_;
  std::span<const PreciseDrive> drives_;
  std::vector<std::vector<std::pair<int, Line>>> chains_;
  std::vector<bool> is_driven_;
  PreciseMotion found_;
  std::vector<std::optional<Placed>> bodies_;
  std::vector<std::vector<Number>> rows_;
  std::vector<Number> misses_;
  std::vector<Number> twist_misses_;
  std::vector<Number> rate_misses_;
};

}  // namespace

PreciseMotion precise_motion(const Mechanism& mechanism,
                             std::span<const FiniteLaw> laws,
                             std::span<const PreciseDrive> drives,
                             std::span<const double> near) {
  return Search(mechanism, laws, drives, near).find();
}

}  // namespace kinestat
