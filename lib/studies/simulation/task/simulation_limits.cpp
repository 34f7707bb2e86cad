#include "studies/simulation/task/simulation_limits.hpp"

#include <array>

#include <fmt/format.h>

namespace kinestat {

namespace {

struct LimitWords {
  std::string_view name;
  std::string_view hint;
};

constexpr std::array<LimitWords, 9> kLimits = {{
    {.name = "friction of couplings with several freedoms",
     .hint = "model it by couplings of one freedom each; or ask 'kinestat motion' for the forces "
             "along a given motion, which has such friction"},
    {.name = "torque converters",
     .hint = "give the couples of pump and turbine as curves over their speeds"},
    {.name = "mesh losses that depend on force",
     .hint = "give its 'losses' a number, or a formula of 'speed' alone"},
    {.name = "losses of teeth whose gears do not both turn by hinges on one carrier",
     .hint = "remove 'losses' for it: its teeth lose nothing then"},
    {.name = "freewheels",
     .hint = "remove 'one_way' and give the action of the clutch, 0 while it is open"},
    {.name = "bodies that only contacts, teeth or cables hold",
     .hint = "guide it by couplings with one freedom each, for example slides along x and y "
             "and a revolute between bodies without mass"},
    {.name = "bodies that turn freely about a point",
     .hint = "model the ball as couplings with one axis each, such as a universal and a revolute"},
    {.name = "inertia or loads in a freedom that no other body feels",
     .hint = "take that freedom away, for example by a universal joint instead of a ball"},
    {.name = "actuators on contacts or segments of cables",
     .hint = "put it on a coupling whose freedom has a position"},
}};

}  // namespace

void refuse(SimulationLimit limit,
            SourceRange where,
            std::string_view element,
            Diagnostics& found) {
  const LimitWords& words = kLimits.at(static_cast<std::size_t>(limit));
  found.error("E0516",
              where,
              fmt::format("a simulation does not know {}: {}", words.name, element),
              std::string(words.hint));
}

std::string simulation_limits() {
  std::string text;
  for (const LimitWords& one : kLimits) {
    text += (text.empty() ? "" : "; ") + std::string(one.name);
  }
  return text;
}

}  // namespace kinestat
