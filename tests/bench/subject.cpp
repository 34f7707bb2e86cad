#include "subject.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "io/read_file.hpp"

namespace kinestat::bench {

namespace {

template <class T>
T required(std::optional<T> value, const std::string& path) {
  if (!value) {
    throw std::runtime_error("this file cannot be read: " + path);
  }
  return *std::move(value);
}

}  // namespace

Subject read_subject(const std::string& path, const std::string& case_label) {
  Diagnostics found;
  Subject subject;
  subject.path = path;
  subject.source = required(read_file(path, {}, found), path);
  subject.tree = required(read_yaml(subject.source, {}, found), path);
  SourceFile source;
  subject.loaded = required(load(path, {}, source, found), path);
  const Mechanism& mechanism = subject.loaded.mechanism;
  subject.motion = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  subject.action = action_basis(mechanism.geometry, mechanism.static_order);
  const auto which = std::ranges::find(mechanism.cases, case_label, &Case::label);
  if (which == mechanism.cases.end()) {
    throw std::runtime_error(fmt::format("the file has no case '{}'", case_label));
  }
  subject.which = *which;
  subject.case_index = static_cast<int>(which - mechanism.cases.begin());
  return subject;
}

KinematicSolution motion_of(const Subject& subject) {
  return solve_velocity(subject.loaded.mechanism, subject.motion, subject.which.motions);
}

StaticSolution action_of(const Subject& subject) {
  return solve_action(subject.loaded.mechanism, subject.action, subject.which.actions);
}

}  // namespace kinestat::bench
