#include "description/cable_description.hpp"

#include <fmt/format.h>

namespace kinestat {

int segment_count(const CableDescription& cable) {
  const int stations = static_cast<int>(cable.over.size());
  return cable.closed || stations == 0 ? stations : stations - 1;
}

std::string segment_name(const CableDescription& cable, int segment) {
  return fmt::format("{}_{}", cable.name.text, segment);
}

std::string virtual_link_name(const CableDescription& cable, std::size_t station) {
  const std::string& wheel = cable.over[station].body.text;
  int number = 1;
  for (std::size_t i = 0; i < station; ++i) {
    const CableStation& before = cable.over[i];
    number += before.is_pulley && before.slip && before.body.text == wheel ? 1 : 0;
  }
  const std::string name = fmt::format("{}_{}", cable.name.text, wheel);
  return number == 1 ? name : fmt::format("{}_{}", name, number);
}

}  // namespace kinestat
