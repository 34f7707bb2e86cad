#include "io/screw_reader.hpp"

#include <array>

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr auto kKinds =
    std::to_array<std::string_view>({"rotation", "translation", "force", "couple"});

constexpr const char* kScrewForms =
    "write {rotation: z, at: [x, y, z]}, {translation: x}, {force: y, at: [x, y, z]} or "
    "{couple: z}; rotation and force may have a pitch";

bool has_line(ScrewWord kind) {
  return kind == ScrewWord::rotation || kind == ScrewWord::force;
}

// A rotation or couple of a planar mechanism is about z, so its direction has three components.
Space space_of(ScrewWord kind, Space space) {
  const bool is_about = kind == ScrewWord::rotation || kind == ScrewWord::couple;
  return is_about ? Space::spatial : space;
}

// The one key that names the kind and the direction; false after an error.
bool read_direction(Fields& fields, Space space, Diagnostics& found, ScrewDescription& screw) {
  int count = 0;
  bool is_good = true;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const YamlNode* node = fields.find(kKinds[i]);
    if (node == nullptr) {
      continue;
    }
    ++count;
    screw.kind = static_cast<ScrewWord>(i);
    const auto direction =
        read_axis(*node, fmt::format("the {}", kKinds[i]), space_of(screw.kind, space), found);
    is_good = is_good && direction.has_value();
    screw.direction = direction.value_or(AxisDescription{});
  }
  if (count != 1) {
    found.error(
        "E0303",
        fields.where(),
        fmt::format("{} needs one of rotation, translation, force and couple", fields.what()),
        kScrewForms);
  }
  return is_good && count == 1;
}

}  // namespace

std::optional<ScrewDescription> read_screw(const YamlNode& node,
                                           std::string_view what,
                                           Space space,
                                           Diagnostics& found) {
  const int errors_before = found.error_count();
  Fields fields(node, node.where, std::string(what), found);
  ScrewDescription screw;
  screw.where = node.where;
  if (node.kind == YamlKind::mapping) {
    const bool is_known = read_direction(fields, space, found, screw);
    if (!is_known || has_line(screw.kind)) {
      if (const YamlNode* at = fields.find("at")) {
        screw.at = read_point(*at, "the point of a screw", space, found);
      }
      if (const YamlNode* pitch = fields.find("pitch")) {
        screw.pitch = read_value(*pitch, "the pitch", found);
      }
    }
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(screw)) : std::nullopt;
}

std::vector<ScrewDescription> read_screws(const YamlNode& node,
                                          std::string_view what,
                                          Space space,
                                          Diagnostics& found) {
  std::vector<ScrewDescription> screws;
  if (node.kind != YamlKind::sequence) {
    found.error("E0304", node.where, fmt::format("{} needs a list of screws", what), kScrewForms);
    return screws;
  }
  for (const YamlNode& item : node.items) {
    if (auto screw = read_screw(item, fmt::format("a screw of {}", what), space, found)) {
      screws.push_back(*std::move(screw));
    }
  }
  return screws;
}

}  // namespace kinestat
