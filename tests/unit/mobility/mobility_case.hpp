// Mechanisms for the tests of mobility: of the library by name, or from the text of a file.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/bind_counted.hpp"
#include "studies/mobility/mobility.hpp"

namespace kinestat {

struct MobilityCase {
  Mechanism mechanism;
  Mechanism in_space;

  ExactMobility exact() const { return find_exact_mobility(mechanism, in_space); }
};

/// A complaint is a failed test.
inline MobilityCase case_of(const MechanismDescription& description) {
  MobilityCase result;
  Diagnostics found;
  if (can_only_be_counted(description)) {
    auto counted = bind_counted(description, found);
    if (counted) {
      result = {.mechanism = std::move(counted->mechanism),
                .in_space = std::move(counted->in_space)};
    }
  } else {
    auto mechanism = bind(description, found);
    auto in_space = bind_in_space(description, found);
    if (mechanism && in_space) {
      result = {.mechanism = *std::move(mechanism), .in_space = *std::move(in_space)};
    }
  }
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
  }
  return result;
}

inline MobilityCase case_of_text(const std::string& text) {
  const SourceFile source{.path = "test", .text = "kinestat: 1\n" + text};
  Diagnostics found;
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);
  const auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
  }
  return description ? case_of(*description) : MobilityCase{};
}

/// "spatial/bennett"
inline MobilityCase case_of_library(const std::string& name) {
  const auto path = std::filesystem::path(KINESTAT_SOURCE_DIR) / "mechanisms" / (name + ".yaml");
  SourceFile source;
  Diagnostics found;
  const auto description = load_description(path.string(), {}, source, found);
  EXPECT_TRUE(description.has_value()) << name;
  return description ? case_of(*description) : MobilityCase{};
}

}  // namespace kinestat
