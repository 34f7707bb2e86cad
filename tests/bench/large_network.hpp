// Mechanism files of any size, to see how time and memory grow.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kinestat::bench {

/// All are planar. Isostatic: everything but the two grids.
enum class NetworkKind {
  four_bar_chain,  ///< the rocker of each four-bar is the crank of the next; every other one is the
                   ///< mirror image of the one before, so that the end turns as the beginning does
  planetary_chain,  ///< sun to carrier and back, rings fixed: every second shaft turns as the first
  serial_loop,      ///< one circuit of links, their angles held by drives, loaded in the middle
  gear_grid,        ///< equal wheels that mesh with all neighbours: movable, and redundant
  pin_grid,         ///< plates pinned to all neighbours: rigid, and redundant
};

std::span<const NetworkKind> all_network_kinds();

/// "four_bar_chain"
std::string_view name_of(NetworkKind kind);

std::optional<NetworkKind> find_network_kind(std::string_view name);

/// A file with one case, its moving bodies as many as fit into `bodies`, at least one of what the
/// network repeats.
std::string large_network(NetworkKind kind, int bodies);

}  // namespace kinestat::bench
