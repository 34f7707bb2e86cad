// A network in one order, with its textbook matrices: what the identities are tested on.
#pragma once

#include <vector>

#include "kinematics/velocity.hpp"
#include "network/freedom_counts.hpp"
#include "statics/action.hpp"
#include "support/random.hpp"

namespace kinestat {

/// Two ways to the same number may differ by this share of the largest number of their kind: 1e-16
/// of rounding, times 1e6 for the flattest network that is not skipped (kFlattest), times some
/// hundred steps.
inline constexpr double kAgreement = 1e-8;

/// A network is skipped where the rank is in doubt, because less than four decades lie between
/// what counted and what did not, or where a pivot below 1e-6 makes the answer lose more digits
/// than kAgreement allows. Both are properties of the drawn position, not of the method.
inline constexpr double kLeastGap = 4.0;
inline constexpr double kFlattest = 1e-6;

/// Whether a network may be tested; a random one nearly always may.
bool is_clear(const RankEvidence& evidence);

/// A mechanism in the order that its couplings have (3 in the plane, else 6) with the textbook
/// matrices, whose columns are brought to the order of the Topology.
struct NetworkCase {
  Mechanism mechanism;
  CoordinateBasis twist_basis;
  CoordinateBasis wrench_basis;
  MatX M_N;  ///< λ l x F
  MatX A_N;  ///< λ k x C, internal actions included
  MatX A_P;  ///< the columns of A_N of the passive constraints

  int order() const { return twist_basis.order(); }
};

NetworkCase make_network_case(Mechanism mechanism);

/// How many of its actions are passive; they come first.
int passive_count(const Topology& topology, const CouplingTopology& coupling);

/// Whether f + c = λ holds for the passive constraints of every coupling. Teeth that roll,
/// clutches, brakes, screws of which both sides are listed and couplings with `passive:` are what
/// breaks it.
bool couplings_are_complementary(const Mechanism& mechanism, int order);

/// Magnitudes that are independent and sufficient, with random values: some chosen one by one among
/// those that are still undetermined, the rest by a completion that the check proposes. Fails the
/// test where the check proposes none.
std::vector<Primary> choose_motions(const NetworkCase& network, Random& random);
std::vector<Primary> choose_actions(const NetworkCase& network, Random& random);

/// The secondary magnitudes from the textbook, N_S x_S = -N_P x_P (Cazangi 2008, eqs. 3.46 and
/// 3.47), by QR; all magnitudes in the order of the columns.
VecX solve_partition(const MatX& N, const std::vector<Primary>& primaries);

/// The largest magnitude, relative to which answers are compared; 0 of no values.
double size_of(const MatX& values);

}  // namespace kinestat
