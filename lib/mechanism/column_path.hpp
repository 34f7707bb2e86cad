// Names of columns as paths: "d.wz/position", or "d.wz.position" where a slash would divide.
#pragma once

#include <algorithm>
#include <string>

namespace kinestat {

/// With points in place of slashes.
inline std::string dotted(std::string name) {
  std::ranges::replace(name, '/', '.');
  return name;
}

/// Whether it is that beginning, or goes on behind it after a point.
inline bool begins_with_parts(const std::string& name, const std::string& begin) {
  return name.starts_with(begin) && (name.size() == begin.size() || name[begin.size()] == '.');
}

}  // namespace kinestat
