#include "large_network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace kinestat::bench {

namespace {

constexpr std::array<NetworkKind, 5> kKinds = {NetworkKind::four_bar_chain,
                                               NetworkKind::planetary_chain,
                                               NetworkKind::serial_loop,
                                               NetworkKind::gear_grid,
                                               NetworkKind::pin_grid};

// The sections of a file while they grow.
class File {
 public:
  void body(std::string_view name) {
    bodies_ += bodies_.empty() ? "" : ", ";
    bodies_ += name;
  }

  void coupling(std::string_view line) { add(line, couplings_); }

  void actuator(std::string_view line) { add(line, actuators_); }

  std::string with_case(std::string_view name, std::string_view asked) const {
    return fmt::format(
        "kinestat: 1\nname: {}\nspace: planar\nground: g\nbodies: [{}]\ncouplings:\n{}{}{}"
        "cases:\n  only: {{{}}}\n",
        name,
        bodies_,
        couplings_,
        actuators_.empty() ? "" : "actuators:\n",
        actuators_,
        asked);
  }

 private:
  static void add(std::string_view line, std::string& section) {
    section += "  ";
    section += line;
    section += '\n';
  }

  std::string bodies_;
  std::string couplings_;
  std::string actuators_;
};

constexpr std::string_view kDriven =
    "motion: {in: 1 rad/s}, action: {in: 1 N*m}, input: in, output: out";

// Cazangi's four-bar: pivots 7 apart, crank to (1, 3), rocker to (6, 5).
std::string four_bar_chain(int bodies) {
  constexpr int kWidth = 7;
  File file;
  const int stages = std::max(2, (bodies - 1) / 2) / 2 * 2;
  file.body("b0");
  file.coupling("a0: {type: revolute, bodies: [g, b0], at: [0, 0]}");
  for (int i = 1; i <= stages; ++i) {
    const int x = kWidth * (i - 1);
    const bool is_mirrored = i % 2 == 0;
    file.body(fmt::format("c{}", i));
    file.body(fmt::format("b{}", i));
    file.coupling(
        fmt::format("a{0}: {{type: revolute, bodies: [g, b{0}], at: [{1}, 0]}}", i, x + kWidth));
    file.coupling(fmt::format("p{0}: {{type: revolute, bodies: [b{1}, c{0}], at: [{2}, {3}]}}",
                              i,
                              i - 1,
                              x + 1,
                              is_mirrored ? 5 : 3));
    file.coupling(fmt::format("q{0}: {{type: revolute, bodies: [c{0}, b{0}], at: [{1}, {2}]}}",
                              i,
                              x + 6,
                              is_mirrored ? 3 : 5));
  }
  file.actuator("in: {coupling: a0}");
  file.actuator(fmt::format("out: {{coupling: a{}}}", stages));
  return file.with_case("chain of four-bars", kDriven);
}

// Sun 24, planet 18, ring 60 teeth of module 1; in odd stages the sun drives the carrier, in even
// ones the carrier the sun.
std::string planetary_chain(int bodies) {
  File file;
  const int stages = std::max(2, (bodies - 1) / 2) / 2 * 2;
  file.body("s0");
  file.coupling("a0: {type: revolute, bodies: [g, s0], at: [0, 0]}");
  for (int i = 1; i <= stages; ++i) {
    const int sun = i % 2 == 0 ? i : i - 1;
    const int carrier = i % 2 == 0 ? i - 1 : i;
    file.body(fmt::format("s{}", i));
    file.body(fmt::format("p{}", i));
    file.coupling(fmt::format("a{0}: {{type: revolute, bodies: [g, s{0}], at: [0, 0]}}", i));
    file.coupling(
        fmt::format("b{0}: {{type: revolute, bodies: [s{1}, p{0}], at: [0, 21]}}", i, carrier));
    file.coupling(fmt::format(
        "m{0}: {{type: gear, bodies: [s{1}, p{0}], at: [0, 12], line_of_action: x}}", i, sun));
    file.coupling(fmt::format(
        "r{0}: {{type: gear, bodies: [g, p{0}], at: [0, 30], line_of_action: x, internal: true}}",
        i));
  }
  file.actuator("in: {coupling: a0}");
  file.actuator(fmt::format("out: {{coupling: a{}}}", stages));
  return file.with_case("chain of planetary sets", kDriven);
}

// A regular polygon of links one long. All joints but three hold their angle.
std::string serial_loop(int bodies) {
  constexpr int kHinges = 3;
  File file;
  const int joints = std::max(4, bodies + 1);
  const double angle = 2.0 * std::numbers::pi / joints;
  const double radius = 0.5 / std::sin(0.5 * angle);
  for (int i = 0; i < joints; ++i) {
    const std::string tail = i == 0 ? "g" : fmt::format("b{}", i);
    const std::string head = i + 1 == joints ? "g" : fmt::format("b{}", i + 1);
    if (i + 1 < joints) {
      file.body(head);
    }
    file.coupling(fmt::format("j{}: {{type: revolute, bodies: [{}, {}], at: [{:.6f}, {:.6f}]}}",
                              i,
                              tail,
                              head,
                              radius * std::cos(angle * i),
                              radius * std::sin(angle * i)));
    const int hinge_step = joints / kHinges;
    const bool is_hinge = i % hinge_step == 0 && i / hinge_step < kHinges;
    if (!is_hinge) {
      file.actuator(fmt::format("d{0}: {{coupling: j{0}}}", i));
    }
  }
  return file.with_case("serial loop",
                        fmt::format("action: {{}}, loads: {{w: {{body: b{}, at: [0, 0], force: "
                                    "[3, -4]}}}}",
                                    joints / 2));
}

// The place of a cell of a grid that is about square.
struct Grid {
  int rows = 0;
  int columns = 0;

  explicit Grid(int bodies)
      : rows(std::max(2, static_cast<int>(std::sqrt(bodies)))),
        columns(std::max(2, bodies / rows)) {}
};

std::string gear_grid(int bodies) {
  File file;
  const Grid grid(bodies);
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      file.body(fmt::format("w{}_{}", r, c));
      file.coupling(
          fmt::format("a{0}_{1}: {{type: revolute, bodies: [g, w{0}_{1}], at: [{2}, {3}]}}",
                      r,
                      c,
                      2 * c,
                      2 * r));
      if (c > 0) {
        file.coupling(
            fmt::format("h{0}_{1}: {{type: gear, bodies: [w{0}_{2}, w{0}_{1}], at: [{3}, {4}], "
                        "line_of_action: y}}",
                        r,
                        c,
                        c - 1,
                        2 * c - 1,
                        2 * r));
      }
      if (r > 0) {
        file.coupling(
            fmt::format("v{0}_{1}: {{type: gear, bodies: [w{2}_{1}, w{0}_{1}], at: [{3}, {4}], "
                        "line_of_action: x}}",
                        r,
                        c,
                        r - 1,
                        2 * c,
                        2 * r - 1));
      }
    }
  }
  file.actuator("in: {coupling: a0_0}");
  return file.with_case("grid of gears", "motion: {in: 1 rad/s}");
}

std::string pin_grid(int bodies) {
  File file;
  const Grid grid(bodies);
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      file.body(fmt::format("w{}_{}", r, c));
      if (c > 0) {
        file.coupling(fmt::format(
            "h{0}_{1}: {{type: revolute, bodies: [w{0}_{2}, w{0}_{1}], at: [{3}, {4}]}}",
            r,
            c,
            c - 1,
            10 * c - 5,
            10 * r + (3 * r + c) % 5 - 2));
      }
      if (r > 0) {
        file.coupling(fmt::format(
            "v{0}_{1}: {{type: revolute, bodies: [w{2}_{1}, w{0}_{1}], at: [{3}, {4}]}}",
            r,
            c,
            r - 1,
            10 * c + (r + 3 * c) % 5 - 2,
            10 * r - 5));
      }
    }
  }
  file.coupling("held: {type: rigid, bodies: [g, w0_0]}");
  return file.with_case(
      "grid of pins",
      fmt::format("action: {{}}, loads: {{w: {{body: w{}_{}, at: [0, 0], force: [3, -4]}}}}",
                  grid.rows - 1,
                  grid.columns - 1));
}

}  // namespace

std::span<const NetworkKind> all_network_kinds() {
  return kKinds;
}

std::string_view name_of(NetworkKind kind) {
  switch (kind) {
    case NetworkKind::four_bar_chain:
      return "four_bar_chain";
    case NetworkKind::planetary_chain:
      return "planetary_chain";
    case NetworkKind::serial_loop:
      return "serial_loop";
    case NetworkKind::gear_grid:
      return "gear_grid";
    case NetworkKind::pin_grid:
      return "pin_grid";
  }
  return "";
}

std::optional<NetworkKind> find_network_kind(std::string_view name) {
  const auto* const found = std::ranges::find(kKinds, name, name_of);
  return found == kKinds.end() ? std::nullopt : std::optional(*found);
}

std::string large_network(NetworkKind kind, int bodies) {
  switch (kind) {
    case NetworkKind::four_bar_chain:
      return four_bar_chain(bodies);
    case NetworkKind::planetary_chain:
      return planetary_chain(bodies);
    case NetworkKind::serial_loop:
      return serial_loop(bodies);
    case NetworkKind::gear_grid:
      return gear_grid(bodies);
    case NetworkKind::pin_grid:
      return pin_grid(bodies);
  }
  return "";
}

}  // namespace kinestat::bench
