// Times the analysis of networks of up to 10^5 bodies, in units of KLU on the same system, and says
// how time and memory grow. scale_bench --only KIND measures one kind of network, scale_bench
// --write KIND BODIES writes one as a file.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <malloc.h>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "format/mechanism_reader.hpp"
#include "graph/structural_rank.hpp"
#include "interleave.hpp"
#include "io/yaml_tree.hpp"
#include "kinematics/velocity.hpp"
#include "klu_solve.hpp"
#include "large_network.hpp"
#include "math/elimination/elimination.hpp"
#include "math/elimination/exact_rank.hpp"
#include "mechanism/bind/bind.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "statics/action.hpp"

namespace kinestat::bench {

namespace {

constexpr int kBodies = 100000;
constexpr int kFewerBodies = 10000;
constexpr double kKluTarget = 10.0;
constexpr double kMemoryTarget = 2000.0;  // bytes a body
constexpr double kExponentTarget = 1.2;
constexpr double kRedundantExponentTarget = 1.5;
constexpr double kExactTarget = 10.0;  // µs a body
constexpr int kMostRounds = 5;

// Of the processor, so that what else runs on the machine counts little.
double seconds_of(const std::function<void()>& run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// A line of /proc/self/status in bytes.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word) {
    if (word == key) {
      status >> kilobytes;
    }
  }
  return 1024.0 * kilobytes;
}

// How much the largest resident memory exceeds that before; Linux resets it on request.
double peak_bytes_of(const std::function<void()>& run) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = status_bytes("VmRSS:");
  run();
  return status_bytes("VmHWM:") - before;
}

struct Bound {
  Mechanism mechanism;
  double tree_seconds = 0.0;
  double description_seconds = 0.0;
  double bind_seconds = 0.0;
  std::size_t bytes = 0;
};

Bound bind_network(NetworkKind kind, int bodies) {
  const SourceFile source{"network", large_network(kind, bodies)};
  const ReadLimits limits = ReadLimits::for_size(std::size_t{1} << 30U);
  Diagnostics found;
  Bound bound;
  bound.bytes = source.text.size();
  std::optional<YamlNode> tree;
  bound.tree_seconds = seconds_of([&] { tree = read_yaml(source, limits, found); });
  std::optional<MechanismDescription> description;
  bound.description_seconds = seconds_of([&] { description = read_mechanism(*tree, found); });
  std::optional<Mechanism> mechanism;
  bound.bind_seconds = seconds_of([&] { mechanism = bind(*description, found); });
  if (!mechanism) {
    throw std::runtime_error("the network is wrong");
  }
  bound.mechanism = *std::move(mechanism);
  return bound;
}

// One side of the case of a network.
struct Side {
  std::string name;
  SparseMatrix system;
  std::vector<int> columns;
  std::vector<double> known;
  std::function<bool()> solve;  // from the bound mechanism; whether it is solved
};

Side motions_of(const Mechanism& mechanism) {
  const Case& which = mechanism.cases.front();
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  Side side{.name = "kinematics",
            .system = velocity_system(mechanism.topology, mechanism.geometry, basis),
            .columns = {},
            .known = {},
            .solve = [&mechanism, &which] {
              const CoordinateBasis own =
                  motion_basis(mechanism.geometry, mechanism.kinematic_order);
              return solve_velocity(mechanism, own, which.motions).status == SolveStatus::solved;
            }};
  for (const Primary& primary : which.motions) {
    side.columns.push_back(velocity_column(mechanism.topology, basis, primary.index));
    side.known.push_back(primary.value / rate_unit(mechanism.topology, basis, primary.index));
  }
  return side;
}

Side actions_of(const Mechanism& mechanism) {
  const Case& which = mechanism.cases.front();
  const CoordinateBasis basis =
      action_basis(mechanism.geometry, mechanism.static_order, wrenches_of(which.loads));
  Side side{
      .name = "statics",
      .system = action_system(mechanism.topology, mechanism.geometry, basis),
      .columns = {},
      .known = {},
      .solve = [&mechanism, &which] {
        const std::vector<BodyWrench> loads = wrenches_of(which.loads);
        const CoordinateBasis own = action_basis(mechanism.geometry, mechanism.static_order, loads);
        return solve_action(mechanism, own, which.actions, loads).status == SolveStatus::solved;
      }};
  for (const Primary& primary : which.actions) {
    side.columns.push_back(primary.index);
    side.known.push_back(primary.value / action_unit(mechanism.topology, basis, primary.index));
  }
  return side;
}

// What equilibrium leaves open in a grid of pins is too much to be listed; there, the rank alone.
Side side_for(NetworkKind kind, Side side) {
  if (kind == NetworkKind::pin_grid) {
    side.name = "rank";
    side.solve = [system = side.system, columns = side.columns] {
      return Elimination(system, columns).rank() == system.rows;
    };
  }
  return side;
}

struct Measured {
  double seconds = 0.0;  // of the analysis; the least
  double ratio = 0.0;    // to KLU; 0 where the system is redundant
  double bytes = 0.0;    // a body
};

Measured measure_side(const Side& side, int bodies, bool is_square, int rounds) {
  Measured result;
  std::optional<KluSolve> klu;
  if (is_square) {
    klu.emplace(side.system, side.columns, side.known);
  }
  std::vector<double> ratios;
  std::vector<double> times;
  result.bytes = peak_bytes_of([&] { keep(side.solve()); }) / bodies;
  for (int i = 0; i < rounds; ++i) {
    const double unit = klu ? seconds_of([&] { klu->solve(); }) : 1.0;
    bool is_solved = false;
    times.push_back(seconds_of([&] { is_solved = side.solve(); }));
    if (!is_solved) {
      throw std::runtime_error("the network is not solved");
    }
    ratios.push_back(times.back() / unit);
  }
  result.seconds = make_ratio({}, times, {}).median;
  result.ratio = make_ratio({}, ratios, {}).median;
  return result;
}

std::string verdict(double value, double target) {
  return value <= target ? "held" : "MISSED";
}

std::string describe(NetworkKind kind,
                     const Side& side,
                     const Measured& few,
                     const Measured& many) {
  const bool is_redundant = kind == NetworkKind::gear_grid || kind == NetworkKind::pin_grid;
  const double exponent = std::log10(many.seconds / few.seconds);
  const double most = is_redundant ? kRedundantExponentTarget : kExponentTarget;
  std::string ratio;
  if (!is_redundant) {
    ratio = fmt::format("{:.1f} and {:.1f} KLU ({:g}: {}), ",
                        few.ratio,
                        many.ratio,
                        kKluTarget,
                        verdict(many.ratio, kKluTarget));
  }
  return fmt::format("{} {}: {}{:.2f} s, exponent {:.2f} ({:g}: {}), {:.0f} B a body ({:g}: {})\n",
                     name_of(kind),
                     side.name,
                     ratio,
                     many.seconds,
                     exponent,
                     most,
                     verdict(exponent, most),
                     many.bytes,
                     kMemoryTarget,
                     verdict(many.bytes, kMemoryTarget));
}

// The rank of the motions, of the entries as exact numbers, and what proves it.
std::string exact_mobility(NetworkKind kind, const SparseMatrix& system, int bodies) {
  ExactRank rank;
  const double seconds = seconds_of([&] {
    EntryPattern pattern(static_cast<std::size_t>(system.rows));
    for (const SparseEntry& entry : system.entries) {
      pattern[static_cast<std::size_t>(entry.row)].push_back(entry.column);
    }
    rank = find_exact_rank(system, structural_rank(pattern, system.columns));
  });
  const double micros = 1e6 * seconds / bodies;
  return fmt::format("{} exact mobility: {:.1f} us a body ({:g}: {}), rank by {}\n",
                     name_of(kind),
                     micros,
                     kExactTarget,
                     verdict(micros, kExactTarget),
                     text_of(rank.proof));
}

std::string measure_network(NetworkKind kind, int rounds) {
  const Bound few = bind_network(kind, kFewerBodies);
  const Bound many = bind_network(kind, kBodies);
  std::string text =
      fmt::format("{}: {:.1f} MB, tree {:.2f} s, description {:.2f} s, bound {:.2f} s\n",
                  name_of(kind),
                  1e-6 * static_cast<double>(many.bytes),
                  many.tree_seconds,
                  many.description_seconds,
                  many.bind_seconds);
  const Case& which = many.mechanism.cases.front();
  const bool is_redundant = kind == NetworkKind::gear_grid || kind == NetworkKind::pin_grid;
  const int bodies = many.mechanism.topology.body_count() - 1;
  for (const auto& side_of : {motions_of, actions_of}) {
    const bool is_kinematic = side_of == motions_of;
    if (is_kinematic ? !which.asks_motions : !which.asks_actions) {
      continue;
    }
    const Side small = side_for(kind, side_of(few.mechanism));
    const Side large = side_for(kind, side_of(many.mechanism));
    const int fewer = few.mechanism.topology.body_count() - 1;
    const Measured at_few = measure_side(small, fewer, !is_redundant, rounds);
    const Measured at_many = measure_side(large, bodies, !is_redundant, rounds);
    text += describe(kind, large, at_few, at_many);
  }
  return text + exact_mobility(kind, motions_of(many.mechanism).system, bodies);
}

std::string run(const Options& options, std::span<const NetworkKind> kinds) {
  std::string text;
  for (const NetworkKind kind : kinds) {
    text += measure_network(kind, std::min(options.rounds, kMostRounds));
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  using namespace kinestat::bench;
  constexpr int kWriteWords = 4;
  const std::string word = argc > 2 ? argv[1] : "";
  if (word != "--write" && word != "--only") {
    return run_program("scale_bench", argc, argv, [](const Options& options) {
      return run(options, all_network_kinds());
    });
  }
  const std::optional<NetworkKind> kind = find_network_kind(argv[2]);
  if (!kind || (word == "--write" && argc != kWriteWords)) {
    std::fprintf(stderr, "usage: scale_bench --write KIND BODIES, or --only KIND [--rounds N]\n");
    return 1;
  }
  if (word == "--only") {
    return run_program("scale_bench", argc - 2, argv + 2, [&](const Options& options) {
      return run(options, std::span(&*kind, 1));
    });
  }
  const std::string text = large_network(*kind, std::atoi(argv[3]));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}
