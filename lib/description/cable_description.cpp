#include "description/cable_description.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

namespace kinestat {

int segment_count(const CableDescription& cable) {
  const int stations = static_cast<int>(cable.over.size());
  return cable.closed || stations == 0 ? stations : stations - 1;
}

std::string segment_name(const CableDescription& cable, int segment) {
  return fmt::format("{}_{}", cable.name.text, segment);
}

std::size_t end_station(const CableDescription& cable, int segment) {
  return static_cast<std::size_t>(segment) % cable.over.size();
}

bool is_same_end(const CableStation& a, const CableStation& b) {
  return !a.slip && !b.slip && a.body.text == b.body.text;
}

std::vector<VirtualLink> virtual_links(const CableDescription& cable) {
  std::vector<VirtualLink> links;
  std::map<std::string_view, int> contacts;  // with each wheel so far
  for (std::size_t i = 0; i < cable.over.size(); ++i) {
    const CableStation& station = cable.over[i];
    if (station.is_pulley && station.slip) {
      const int contact = ++contacts[station.body.text];
      const std::string name = fmt::format("{}_{}", cable.name.text, station.body.text);
      links.push_back(
          {.station = i, .name = contact == 1 ? name : fmt::format("{}_{}", name, contact)});
    }
  }
  return links;
}

}  // namespace kinestat
