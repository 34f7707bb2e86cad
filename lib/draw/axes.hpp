// Scales from values to pixels, and where their ticks stand.
#pragma once

#include <string>
#include <vector>

namespace kinestat {

enum class ScaleKind { linear, logarithmic };

/// A tick with its label.
struct Tick {
  double value = 0.0;
  std::string label;
};

/// The range of an axis with its ticks.
struct AxisRange {
  ScaleKind kind = ScaleKind::linear;
  double low = 0.0;
  double high = 1.0;
  int exponent = 0;  ///< labels are in units of 10^exponent
  std::vector<Tick> ticks;

  /// Where a value stands, 0 at `low` and 1 at `high`. Not a number for what has no place: what is
  /// not finite, and on a logarithmic axis what is not positive.
  double share(double value) const;
};

/// What an axis is to show.
struct AxisDemand {
  double low = 0.0;
  double high = 0.0;
  int tick_count = 6;       ///< about as many ticks
  bool in_degrees = false;  ///< ticks at parts of a turn
  double least_step = 0.0;  ///< no ticks nearer to each other
};

/// How much an axis shows of values of that size and span: the span, or where they agree in all
/// digits that a picture tells apart, as much as they are large; 2 of zeros.
double shown_span(double span, double size);

/// An axis from tick to tick around the demand, with steps of 1, 2 or 5 times a power of ten; in
/// degrees of 15, 30, 45, 90, 180 or 360 where these are the size. A single value is widened.
AxisRange linear_axis(const AxisDemand& demand);

/// The same with ticks within the demand, whose ends are kept.
AxisRange tight_axis(const AxisDemand& demand);

/// An axis of whole decades around positive values; each or each second, third, … has a tick.
AxisRange logarithmic_axis(const AxisDemand& demand);

/// "10⁻³"
std::string power_of_ten(int exponent);

/// A number for labels: that many significant digits, a real minus sign, "×10⁻⁶" where it is far
/// from 1. "–" for what is not finite.
std::string label_number(double value, int digits = 4);

/// Ticks of a logarithmic axis of a decade or so: 1, 1.5, 2, 3, 4, 5, 6, 8 and their tens, over
/// more of it 1, 2, 5.
std::vector<double> ratio_ticks(double low, double high);

/// Places at least that far from each other, in the order of `wished`, which ascends, and as near
/// to it as a simple push allows.
std::vector<double> spread_places(const std::vector<double>& wished, double distance);

}  // namespace kinestat
