#include "studies/motion/report/motion_dynamics_text.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "report/number_format.hpp"
#include "studies/motion/report/motion_dynamics_record.hpp"

namespace kinestat {

namespace {

class DynamicsWriter {
 public:
  explicit DynamicsWriter(const MotionTable& motion)
      : motion_(motion), dynamics_(*motion.dynamics) {}

  TextBlocks run() const {
    TextBlocks text;
    if (!dynamics_.actuators.empty()) {
      text += actuators();
    }
    if (dynamics_.energy) {
      text += energy(*dynamics_.energy);
    }
    if (dynamics_.flywheel) {
      text += flywheel(*dynamics_.flywheel);
    }
    if (dynamics_.balance) {
      text += balance(*dynamics_.balance);
    }
    if (!dynamics_.limit_speeds.empty()) {
      text += limit_speeds();
    }
    if (!dynamics_.harmonics.empty()) {
      text += harmonics();
    }
    return text;
  }

 private:
  std::string amount(QuantityKind kind, double si) const {
    return format_short(dynamics_.units.from_si(kind, si)) + " " + dynamics_.units.text(kind);
  }

  std::string short_of(QuantityKind kind, double si) const {
    return format_short(dynamics_.units.from_si(kind, si));
  }

  // " at motor = 37.7 deg"
  std::string place(double at) const {
    const DriveTravel& drive = motion_.drives.front();
    return fmt::format(" at {} = {}", drive.name, amount(dynamics_.place_kind(), at));
  }

  TextBlocks actuators() const {
    using enum QuantityKind;
    const std::string& drive = motion_.drives.front().name;
    const auto with_unit = [&](std::string_view what, QuantityKind kind) {
      return fmt::format("{} [{}]", what, dynamics_.units.text(kind));
    };
    std::vector<TextColumn> table = {{"Actuator", {}},
                                     {"peak", {}},
                                     {"at " + drive, {}},
                                     {"mean", {}},
                                     {"RMS", {}},
                                     {with_unit("peak power", power), {}},
                                     {"at " + drive, {}},
                                     {with_unit("energy in", QuantityKind::energy), {}},
                                     {with_unit("energy out", QuantityKind::energy), {}}};
    for (const ActuatorFigures& one : dynamics_.actuators) {
      const QuantityKind kind = one.turns ? moment : force;
      const std::vector<std::string> cells = {with_unit(one.name, kind),
                                              short_of(kind, one.peak.value),
                                              short_of(dynamics_.place_kind(), one.peak.at),
                                              short_of(kind, one.mean),
                                              short_of(kind, one.rms),
                                              short_of(power, one.peak_power.value),
                                              short_of(dynamics_.place_kind(), one.peak_power.at),
                                              short_of(QuantityKind::energy, one.energy_in),
                                              short_of(QuantityKind::energy, one.energy_out)};
      for (std::size_t i = 0; i < cells.size(); ++i) {
        table[i].cells.push_back(cells[i]);
      }
    }
    return TextBlocks(std::move(table));
  }

  TextBlocks energy(const EnergyFigures& figures) const {
    using enum QuantityKind;
    const auto exchanged = [&](double energy) {
      return fmt::format("{} {}",
                         energy < 0.0 ? "absorb" : "supply",
                         amount(QuantityKind::energy, std::abs(energy)));
    };
    return TextBlocks(fmt::format(
        "Energy\n  actuators {}; loads, weights and springs {}; {} {}\n  net "
        "change of kinetic energy {}, largest value {}{}\n\n",
        exchanged(figures.actuators),
        exchanged(figures.loads),
        figures.has_lossy_meshes ? "friction and meshes dissipate" : "friction dissipates",
        amount(QuantityKind::energy, figures.lost),
        amount(QuantityKind::energy, figures.kinetic_change),
        amount(QuantityKind::energy, figures.greatest_kinetic),
        figures.audit ? fmt::format("; balance error {:.1g} of that", *figures.audit) : ""));
  }

  TextBlocks flywheel(const FlywheelFigures& wheel) const {
    using enum QuantityKind;
    std::string text = "Flywheel\n";
    text += fmt::format("  {} at {}, for a fluctuation of {} at {}\n",
                        amount(inertia, wheel.inertia),
                        wheel.at,
                        format_short(wheel.fluctuation),
                        amount(angular_velocity, wheel.speed));
    text += fmt::format("  drive {} then supplies a constant {}; the energy fluctuates by {}\n",
                        wheel.motor,
                        amount(wheel.motor_turns ? moment : force, wheel.mean_action),
                        amount(energy, wheel.energy));
    if (wheel.with_it) {
      const CycleSpeed& speed = *wheel.with_it;
      text += fmt::format("  with it, fluctuation {}: least {}{}, greatest {}{}\n",
                          format_short(speed.fluctuation),
                          amount(angular_velocity, speed.least),
                          place(speed.least_at),
                          amount(angular_velocity, speed.greatest),
                          place(speed.greatest_at));
    } else {
      text +=
          "  actions depend on speed, as friction, losses and dampers do, so the speed with it is "
          "not known\n";
    }
    return TextBlocks(text + "\n");
  }

  TextBlocks balance(const BalanceFigures& figures) const {
    const auto angle_of = [&](const Vec3& at) {
      return at.isZero(0.0) ? "-" : short_of(QuantityKind::angle, std::atan2(at.y(), at.x()));
    };
    std::vector<TextColumn> table = {
        {"Counterweight", {}},
        {fmt::format("mass*radius [{}]", mass_radius_unit(dynamics_.units)), {}}};
    if (dynamics_.is_planar) {
      table.push_back({fmt::format("angle [{}]", dynamics_.units.text(QuantityKind::angle)), {}});
    } else {
      for (const char* axis : {"x", "y", "z"}) {
        table.push_back(
            {fmt::format("along {} [{}]", axis, mass_radius_unit(dynamics_.units)), {}});
      }
    }
    for (const Counterweight& one : figures.counterweights) {
      table[0].cells.push_back(one.body);
      table[1].cells.push_back(
          format_short(mass_radius_from_si(one.mass_radius.norm(), dynamics_.units)));
      if (dynamics_.is_planar) {
        table[2].cells.push_back(angle_of(one.mass_radius));
      } else {
        for (std::size_t i = 0; i < 3; ++i) {
          table[2 + i].cells.push_back(format_short(
              mass_radius_from_si(one.mass_radius[static_cast<Eigen::Index>(i)], dynamics_.units)));
        }
      }
    }
    TextBlocks text(std::move(table));
    const std::string& unit = dynamics_.units.text(QuantityKind::force);
    std::vector<TextColumn> forces = {{fmt::format("Shaking force [{}]", unit), {}},
                                      {"RMS", {}},
                                      {"greatest", {}},
                                      {"at " + motion_.drives.front().name, {}}};
    for (const auto& [what, force] : {std::pair("without counterweights", &figures.before),
                                      std::pair("with them", &figures.after)}) {
      forces[0].cells.emplace_back(what);
      forces[1].cells.push_back(short_of(QuantityKind::force, force->rms));
      forces[2].cells.push_back(short_of(QuantityKind::force, force->greatest));
      forces[3].cells.push_back(short_of(dynamics_.place_kind(), force->greatest_at));
    }
    return text += TextBlocks(std::move(forces));
  }

  TextBlocks limit_speeds() const {
    const QuantityKind kind =
        dynamics_.drive_turns ? QuantityKind::angular_velocity : QuantityKind::velocity;
    const std::string& drive = motion_.drives.front().name;
    std::vector<TextColumn> table = {
        {"Force", {}},
        {fmt::format("vanishes at speed of {} [{}]", drive, dynamics_.units.text(kind)), {}},
        {"at " + drive, {}}};
    for (const LimitSpeed& one : dynamics_.limit_speeds) {
      table[0].cells.push_back(one.action);
      table[1].cells.push_back(one.speed ? short_of(kind, *one.speed) : "none");
      table[2].cells.push_back(one.at ? short_of(dynamics_.place_kind(), *one.at) : "-");
    }
    return TextBlocks(std::move(table));
  }

  TextBlocks harmonics() const {
    std::vector<TextColumn> table = {{"Amplitude of order", {}}, {"mean", {}}};
    for (const Harmonic& one : dynamics_.harmonics.front().orders) {
      table.push_back({std::to_string(one.order), {}});
    }
    for (const HarmonicSeries& one : dynamics_.harmonics) {
      table[0].cells.push_back(fmt::format("{} [{}]", one.name, dynamics_.units.text(one.kind)));
      table[1].cells.push_back(short_of(one.kind, one.mean));
      for (std::size_t i = 0; i < one.orders.size(); ++i) {
        table[2 + i].cells.push_back(short_of(one.kind, one.orders[i].amplitude));
      }
    }
    return TextBlocks(std::move(table));
  }

  const MotionTable& motion_;
  const MotionDynamics& dynamics_;
};

}  // namespace

TextBlocks motion_dynamics_blocks(const MotionTable& motion) {
  return motion.dynamics ? DynamicsWriter(motion).run() : TextBlocks();
}

}  // namespace kinestat
