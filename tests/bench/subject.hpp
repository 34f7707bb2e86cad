// The mechanism and the case that the benchmarks of one process solve.
#pragma once

#include <string>

#include "core/source.hpp"
#include "files/load_file.hpp"
#include "io/yaml_tree.hpp"
#include "kinematics/velocity.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"

namespace kinestat::bench {

/// One file, read and bound, and one of its cases.
struct Subject {
  std::string path;
  SourceFile source;
  YamlNode tree;
  Loaded loaded;
  CoordinateBasis motion;
  CoordinateBasis action;
  Case which;
  int case_index = 0;
};

/// Throws std::runtime_error if the file cannot be read or has no such case.
Subject read_subject(const std::string& path, const std::string& case_label);

KinematicSolution motion_of(const Subject& subject);

StaticSolution action_of(const Subject& subject);

}  // namespace kinestat::bench
