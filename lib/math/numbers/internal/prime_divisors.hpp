// The prime divisors of small whole numbers.
#pragma once

namespace kinestat {

/// Calls `visit` with each prime divisor of n > 0 once, ascending.
template <class Visit>
void for_each_prime_divisor(int n, const Visit& visit) {
  for (int q = 2; q * q <= n; ++q) {
    if (n % q == 0) {
      visit(q);
    }
    while (n % q == 0) {
      n /= q;
    }
  }
  if (n > 1) {
    visit(n);
  }
}

}  // namespace kinestat
