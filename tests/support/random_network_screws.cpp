#include "support/random_network_screws.hpp"

#include <utility>

#include <Eigen/SVD>

namespace kinestat {

namespace {

using List = std::vector<NetworkScrew>;

// Turning or force about a line, sliding or couple without one.
enum class Side { freedoms, constraints };

NetworkScrew draw_screw(Side side, LayoutDraw& draw) {
  const bool has_line = draw.random().chance(0.6);
  // In the plane rotations and couples are about z, translations and forces in it.
  const bool turns = (side == Side::freedoms) == has_line;
  NetworkScrew screw;
  screw.kind = side == Side::freedoms ? (has_line ? ScrewWord::rotation : ScrewWord::translation)
                                      : (has_line ? ScrewWord::force : ScrewWord::couple);
  screw.direction = turns ? draw.turning() : draw.sliding();
  if (has_line) {
    screw.at = draw.point_of(screw.direction);
    screw.pitch = !draw.is_planar() && draw.random().chance(0.3) ? draw.random().magnitude() : 0.0;
  }
  return screw;
}

Vec6 coordinates_of(const NetworkScrew& screw) {
  const Vec3 direction = screw.direction.vector.normalized();
  Vec6 result = Vec6::Zero();
  if (screw.has_line()) {
    result << direction, screw.at.cross(direction) + screw.pitch * direction;
  } else {
    result.tail<3>() = direction;
  }
  return result;
}

// Clearly so: in metres, as all points of a network lie within a few of them.
bool are_independent(const List& screws) {
  Mat6X columns(6, static_cast<Eigen::Index>(screws.size()));
  for (std::size_t i = 0; i < screws.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = coordinates_of(screws[i]);
  }
  return MatX(columns).jacobiSvd().singularValues().minCoeff() > 0.1;
}

// Those that the layout makes dependent are drawn anew without it.
List draw_independent(Side side, LayoutDraw& draw) {
  LayoutDraw general(draw.is_planar() ? Layout::planar : Layout::general, draw.random());
  List list(static_cast<std::size_t>(draw.random().whole(1, draw.is_planar() ? 2 : 5)));
  for (NetworkScrew& screw : list) {
    screw = draw_screw(side, draw);
  }
  while (!are_independent(list)) {
    for (NetworkScrew& screw : list) {
      screw = draw_screw(side, general);
    }
  }
  return list;
}

NetworkKey draw_one_side(LayoutDraw& draw) {
  const bool is_free = draw.random().chance(0.5);
  return {.word = is_free ? "freedoms" : "constraints",
          .value = draw_independent(is_free ? Side::freedoms : Side::constraints, draw)};
}

// A turning with pitch, and what it is reciprocal to: forces across its axis that meet it, couples
// across it, and the wrench of opposite pitch along it.
std::pair<List, List> draw_helical(LayoutDraw& draw) {
  const NetworkDirection axis = draw.turning();
  const Vec3 point = draw.point_of(axis);
  const NetworkDirection first = draw.across(axis);
  const NetworkDirection second{axis.vector.cross(first.vector)};
  List constraints = {{ScrewWord::force, first, point, 0.0},
                      {ScrewWord::force, second, point, 0.0}};
  if (draw.is_planar()) {
    return {{{ScrewWord::rotation, axis, point, 0.0}}, constraints};
  }
  const double pitch = draw.random().magnitude();
  constraints.push_back({ScrewWord::couple, first});
  constraints.push_back({ScrewWord::force, axis, point, -pitch});
  constraints.push_back({ScrewWord::couple, second});
  return {{{ScrewWord::rotation, axis, point, pitch}}, constraints};
}

}  // namespace

std::vector<NetworkKey> draw_screw_lists(Completeness completeness, LayoutDraw& draw) {
  if (draw.random().chance(0.7)) {
    return {draw_one_side(draw)};
  }
  auto [freedoms, constraints] = draw_helical(draw);
  if (completeness == Completeness::any) {
    const int count = draw.random().whole(1, static_cast<int>(constraints.size()));
    constraints.resize(static_cast<std::size_t>(count));
  }
  return {{.word = "freedoms", .value = std::move(freedoms)},
          {.word = "constraints", .value = std::move(constraints)}};
}

}  // namespace kinestat
