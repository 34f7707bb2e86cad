// The count of Grübler and Kutzbach, which knows no geometry.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mechanism/topology.hpp"

namespace kinestat {

/// The pairs of one class: P_I prevents one of the six motions in space, P_V five
/// (Alves 2023, section 2.2.1, p. 32, after Reshetov 1979); a rigid coupling is of class 6, one
/// that prevents nothing of class 0.
struct PairClass {
  std::vector<CouplingId> couplings;
  int freedoms = 0;  ///< Σ f of the class, in the order of the count
};

/// "P_V", "P_VI"; "P_0" for pairs that prevent nothing.
std::string name_of_class(std::size_t prevented);

/// M = λ(n - 1 - j) + Σ f (Alves 2023, eq. 3.3); with every constraint independent of the others it
/// would be the net degree of freedom. In general it is F_N - C_N.
struct GrublerCount {
  int order = 6;      ///< λ
  int bodies = 0;     ///< n, the ground included
  int couplings = 0;  ///< j
  int freedoms = 0;   ///< Σ f
  int mobility = 0;   ///< M
  std::array<PairClass, 7> classes;
};

/// `topology` in the plane (λ = 3) or in space (λ = 6); `in_space` are the same couplings with what
/// they free in space, which decides on the class: a hinge is P_V in the plane too.
GrublerCount count_by_grubler(const Topology& topology, const Topology& in_space, int order);

}  // namespace kinestat
