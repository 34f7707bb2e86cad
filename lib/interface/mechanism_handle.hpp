// A mechanism that another program holds.
#pragma once

#include <string>
#include <vector>

#include "core/source.hpp"
#include "description/mechanism_description.hpp"
#include "files/file_names.hpp"
#include "files/load_file.hpp"

struct kinestat_mechanism {
  kinestat::SourceFile source;
  kinestat::MechanismDescription file;         ///< as it was read
  std::vector<kinestat::Override> overrides;   ///< the last of each parameter
  kinestat::MechanismDescription description;  ///< with these
  kinestat::FileNames names;
};
