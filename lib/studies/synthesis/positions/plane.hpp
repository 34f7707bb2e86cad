// Points and vectors of the plane of motion, as complex numbers.
#pragma once

#include <complex>

namespace kinestat {

/// x + iy. A turn by φ is a product with e^{iφ}.
using Point = std::complex<double>;

inline double dot(const Point& a, const Point& b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

/// Positive if b lies anticlockwise of a.
inline double cross(const Point& a, const Point& b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// The unit vector at an angle [rad].
inline Point unit_vector(double angle) {
  return std::polar(1.0, angle);
}

/// Turned anticlockwise by a right angle.
inline Point left_of(const Point& a) {
  return {-a.imag(), a.real()};
}

}  // namespace kinestat
