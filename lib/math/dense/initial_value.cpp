#include "math/dense/initial_value.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace kinestat {

namespace {

using OdeState = std::vector<double>;
using DormandPrince = boost::numeric::odeint::runge_kutta_dopri5<OdeState>;

// A step that is so short a share of the time is lost in its rounding.
constexpr double kLostStep = 16.0 * std::numeric_limits<double>::epsilon();

// How steps follow their error, which is of the fifth power of them.
constexpr double kOrder = 5.0;
constexpr double kCaution = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5.0;

// By how much longer a step is tried that met a place without a slope: none of its looks falls on
// one of those before.
constexpr double kPassing = 1.19;

bool is_finite(const OdeState& all) {
  return std::ranges::all_of(all, [](double one) { return std::isfinite(one); });
}

}  // namespace

struct InitialValueProblem::Stepper {
  Stepper(Slope slope_of, Allowed allowed_of)
      : find_slope(std::move(slope_of)), find_allowed(std::move(allowed_of)) {}

  // Without a value all components are none, and so is everything that is made of them.
  void slope(const OdeState& at_y, OdeState& at_f, double time) const {
    at_f.resize(at_y.size());
    if (!find_slope(time, at_y, at_f)) {
      std::ranges::fill(at_f, std::numeric_limits<double>::quiet_NaN());
    }
  }

  // The largest error of a tried step by what is allowed; infinite where it has no value.
  double worst_error(double tried) {
    if (!is_finite(y) || !is_finite(f) || !is_finite(missed)) {
      return std::numeric_limits<double>::infinity();
    }
    allowed.resize(y.size());
    find_allowed(y, f, tried, allowed);
    double worst = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      worst = std::max(worst, std::abs(missed[i]) / allowed[i]);
    }
    return worst;
  }

  bool step(double end, double latest) {
    if (!is_finite(f)) {
      return false;
    }
    y_before.swap(y);
    f_before.swap(f);
    y.resize(y_before.size());
    f.resize(y_before.size());
    missed.resize(y_before.size());
    const auto system = [this](const OdeState& at_y, OdeState& at_f, double time) {
      slope(at_y, at_f, time);
    };
    const double left = end - now;
    double length = std::min(next_step, left);
    bool may_pass = true;
    while (length > kLostStep * std::max(std::abs(now), length)) {
      method.do_step(system, y_before, f_before, now, y, f, length, missed);
      const double error = worst_error(length);
      const double factor =
          std::isfinite(error) ? kCaution * std::pow(error, -1.0 / kOrder) : kLeastFactor;
      if (error <= 1.0) {
        before = now;
        now = length == left ? end : now + length;
        // A step that was cut short by the end says nothing against longer ones.
        next_step = std::max(length * std::clamp(factor, kLeastFactor, kMostFactor),
                             length == left ? next_step : 0.0);
        return true;
      }
      const bool passes = may_pass && !std::isfinite(error) && kPassing * length <= latest - now;
      may_pass = may_pass && std::isfinite(error);
      length *= passes ? kPassing : std::clamp(factor, kLeastFactor, kCaution);
    }
    y.swap(y_before);
    f.swap(f_before);
    return false;
  }

  Slope find_slope;
  Allowed find_allowed;
  DormandPrince method;
  double before = 0.0;
  double now = 0.0;
  double next_step = 0.0;
  OdeState y_before;
  OdeState f_before;
  OdeState y;
  OdeState f;
  OdeState missed;
  OdeState allowed;
  mutable OdeState between;
};

InitialValueProblem::InitialValueProblem(Slope slope, Allowed allowed)
    : stepper_(std::make_unique<Stepper>(std::move(slope), std::move(allowed))) {}

InitialValueProblem::~InitialValueProblem() = default;

void InitialValueProblem::start(double time, std::span<const double> y, double step) {
  Stepper& s = *stepper_;
  s.before = time;
  s.now = time;
  s.next_step = step;
  s.y.assign(y.begin(), y.end());
  s.slope(s.y, s.f, time);
}

bool InitialValueProblem::step(double end, double latest) {
  return stepper_->step(end, latest);
}

bool InitialValueProblem::has_slope() const {
  return is_finite(stepper_->f);
}

double InitialValueProblem::time_before() const {
  return stepper_->before;
}

double InitialValueProblem::time() const {
  return stepper_->now;
}

double InitialValueProblem::next_step() const {
  return stepper_->next_step;
}

const std::vector<double>& InitialValueProblem::state() const {
  return stepper_->y;
}

const std::vector<double>& InitialValueProblem::state_before() const {
  return stepper_->y_before;
}

void InitialValueProblem::state_at(double time, std::span<double> y) const {
  const Stepper& s = *stepper_;
  s.between.resize(s.y.size());
  s.method.calc_state(time, s.between, s.y_before, s.f_before, s.before, s.y, s.f, s.now);
  std::ranges::copy(s.between, y.begin());
}

}  // namespace kinestat
