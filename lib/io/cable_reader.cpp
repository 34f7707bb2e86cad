#include "io/cable_reader.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kStationForms =
    "write {body: NAME, at: [x, y]} for a point, or "
    "{pulley: NAME, radius: 1, wrap: clockwise} for a pulley";

// Neither a body nor a pulley, perhaps because the word is misspelt.
void complain_of_kind(const YamlNode& node, const std::string& what, Diagnostics& found) {
  static const std::vector<std::string> kStations = {"body", "pulley"};
  for (const YamlEntry& entry : node.entries) {
    const std::string guess = did_you_mean(entry.key, kStations);
    if (!guess.empty()) {
      found.error("E0302",
                  entry.key_where,
                  fmt::format("{} has no key '{}'", what, entry.key),
                  fmt::format("{} {}", guess, kStationForms));
      return;
    }
  }
  found.error("E0303",
              node.where,
              fmt::format("{} lacks the key 'body' or 'pulley'", what),
              std::string(kStationForms));
}

// Whether the station is a pulley; empty after an error.
std::optional<bool> read_kind(const YamlNode& node, const std::string& what, Diagnostics& found) {
  const bool has_body = node.find("body") != nullptr;
  const bool has_pulley = node.find("pulley") != nullptr;
  if (has_body != has_pulley) {
    return has_pulley;
  }
  if (has_body) {
    found.error("E0302",
                place_of_key(node, "body"),
                fmt::format("{} has both 'body' and 'pulley'", what),
                "keep 'body' for a point where the cable is fixed, 'pulley' for one that it wraps");
  } else if (node.kind == YamlKind::mapping) {
    complain_of_kind(node, what, found);
  }
  return std::nullopt;
}

// Where the cable meets and leaves the pulley.
void read_contacts(const YamlNode& node,
                   const std::string& what,
                   Space space,
                   CableStation& station,
                   Diagnostics& found) {
  if (node.kind != YamlKind::sequence || node.items.size() != 2) {
    found.error("E0304",
                node.where,
                fmt::format("'points' of {} must be two points", what),
                "write points: [[x, y], [x, y]]: where the cable meets the pulley, then where it "
                "leaves it");
    return;
  }
  for (const YamlNode& item : node.items) {
    if (auto point = read_point(item, fmt::format("'points' of {}", what), space, found)) {
      station.points.push_back(*std::move(point));
    }
  }
}

void read_wrap(const YamlNode& node,
               const std::string& what,
               CableStation& station,
               Diagnostics& found) {
  static const std::vector<std::string> kWraps = {"clockwise", "counterclockwise"};
  if (const auto word = read_word(node, fmt::format("'wrap' of {}", what), kWraps, found)) {
    station.wrap = *word == 0 ? Wrap::clockwise : Wrap::counterclockwise;
  }
}

void read_pulley(Fields& fields, Space space, CableStation& station, Diagnostics& found) {
  station.is_pulley = true;
  station.body = require_reference(fields, "pulley", found);
  station.at = find_point(fields, "at", space, found);
  const YamlNode* points = fields.find("points");
  if (points != nullptr) {
    read_contacts(*points, fields.what(), space, station, found);
  }
  const YamlNode* radius = points != nullptr ? fields.find("radius") : fields.require("radius");
  if (radius != nullptr) {
    station.radius = read_value(*radius, fmt::format("'radius' of {}", fields.what()), found);
  }
  const YamlNode* wrap = points != nullptr ? fields.find("wrap") : fields.require("wrap");
  if (wrap != nullptr) {
    read_wrap(*wrap, fields.what(), station, found);
  }
  if (const YamlNode* node = fields.find("axis")) {
    station.axis =
        read_axis(*node, fmt::format("the axis of {}", fields.what()), Space::spatial, found);
  }
  station.slip = find_bool(fields, "slip", found);
  station.turns = find_value(fields, "turns", found);
  station.friction = find_value(fields, "friction", found);
  station.eta = find_value(fields, "eta", found);
}

CableStation read_station(const YamlNode& node,
                          const std::string& what,
                          Space space,
                          Diagnostics& found) {
  CableStation station;
  station.where = node.where;
  Fields fields(node, node.where, what, found);
  const std::optional<bool> is_pulley = read_kind(node, what, found);
  if (!is_pulley) {
    return station;  // which other keys may stand depends on the kind
  }
  if (*is_pulley) {
    read_pulley(fields, space, station, found);
  } else {
    station.body = require_reference(fields, "body", found);
    station.at = require_point(fields, "at", space, found);
  }
  fields.finish();
  return station;
}

void read_stations(Fields& fields, Space space, CableDescription& cable, Diagnostics& found) {
  const YamlNode* node = fields.require("over");
  if (node == nullptr) {
    return;
  }
  if (node->kind != YamlKind::sequence || node->items.size() < 2) {
    found.error("E0304",
                node->where,
                fmt::format("{} must run over a list of at least two stations", fields.what()),
                std::string(kStationForms));
    return;
  }
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const std::string what = fmt::format("station {} of {}", i + 1, fields.what());
    cable.over.push_back(read_station(node->items[i], what, space, found));
  }
}

// A cable without ends is fixed nowhere.
void check_closed(const CableDescription& cable, Diagnostics& found) {
  for (const CableStation& station : cable.over) {
    if (!station.is_pulley) {
      found.error("E0314",
                  station.where,
                  fmt::format("cable '{}' is closed and cannot be fixed at a point of '{}'",
                              cable.name.text,
                              station.body.text),
                  "make it a pulley, or remove 'closed: true'");
    }
  }
}

// A cable with ends must not slip off them.
void check_ends(const CableDescription& cable, Diagnostics& found) {
  for (const CableStation* end : {&cable.over.front(), &cable.over.back()}) {
    if (end->is_pulley && end->slip) {
      found.error("E0314",
                  end->where,
                  fmt::format("cable '{}' ends on pulley '{}' and would slip off it",
                              cable.name.text,
                              end->body.text),
                  "remove 'slip' if it is a drum, end the cable at a point {body: NAME, at: …}, or "
                  "write 'closed: true' for a belt");
    }
  }
}

CableDescription read_cable(const YamlEntry& entry, Space space, Diagnostics& found) {
  const int errors_before = found.error_count();
  CableDescription cable;
  cable.name = {.text = entry.key, .where = entry.key_where};
  cable.where = entry.value.where;
  check_name(cable.name, "a cable", found);
  Fields fields(entry.value, entry.key_where, fmt::format("cable '{}'", entry.key), found);
  read_stations(fields, space, cable, found);
  cable.closed = find_bool(fields, "closed", found);
  fields.finish();
  if (found.error_count() == errors_before) {
    cable.closed ? check_closed(cable, found) : check_ends(cable, found);
  }
  return cable;
}

}  // namespace

std::vector<CableDescription> read_cables(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<CableDescription> cables;
  if (!check_mapping(node, "cables", found)) {
    return cables;
  }
  for (const YamlEntry& entry : node.entries) {
    const int errors_before = found.error_count();
    CableDescription cable = read_cable(entry, space, found);
    if (found.error_count() == errors_before) {
      cables.push_back(std::move(cable));
    }
  }
  return cables;
}

}  // namespace kinestat
