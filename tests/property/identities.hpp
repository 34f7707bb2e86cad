// The identities of Davies' method that every mechanism must satisfy; each fails the running test.
#pragma once

#include "property/network_answers.hpp"
#include "support/random_network.hpp"

namespace kinestat {

/// B Qᵀ = 0.
void expect_orthogonal_graph(const CouplingGraph& graph);

/// Within every coupling: the freedoms are independent, the passive constraints too, and none of
/// these does work on any of those.
void expect_reciprocal_couplings(const NetworkCase& network);

/// The rank of the velocity system is λ (n - 1) + rank M_N, that of the action system rank A_N; the
/// ranks of M_N and A_N by column-pivoted QR.
void expect_equal_ranks(const NetworkCase& network);

/// F + C = λ e, F_N = F - rank M_N = λ k - rank A_N, C_N = C - rank A_N = λ l - rank M_N and
/// F_N - C_N = F - λ l, C being the passive constraints. Holds where every coupling has f + c = λ.
void expect_complementary_counts(const NetworkCase& network);

/// f + c = λ for every coupling that is not excused by name (is_complementary).
void expect_complementary_couplings(const RandomNetwork& network, const NetworkCase& in_numbers);

/// Solves for random primary motions: the status is solved, M_N φ = 0, and φ is that of the
/// textbook's partition.
VecX expect_solved_motions(const NetworkCase& network, const std::vector<Primary>& primaries);

/// Likewise A_N ψ = 0.
VecX expect_solved_actions(const NetworkCase& network, const std::vector<Primary>& primaries);

/// The same magnitudes come out in the minimal order.
void expect_motions_in_minimal_order(const NetworkCase& network,
                                     const std::vector<Primary>& primaries);
void expect_actions_in_minimal_order(const NetworkCase& network,
                                     const std::vector<Primary>& primaries);

/// Σ wrench · twist over all couplings = 0 for any solution of each side (Tellegen). Returns the
/// largest power of a coupling relative to the largest rate times the largest action, which tells
/// a test of something from one of zeros.
double expect_balanced_power(const NetworkCase& network, const VecX& rates, const VecX& magnitudes);

}  // namespace kinestat
