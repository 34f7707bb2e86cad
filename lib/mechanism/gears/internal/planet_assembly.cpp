#include "mechanism/gears/internal/planet_assembly.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace kinestat {

namespace {

// One condition: Σ teeth x - constant/n is whole.
struct AssemblyCondition {
  std::vector<long long> teeth;  ///< of each planet
  long long constant = 0;        ///< what the gear on the main axis adds
};

AssemblyCondition condition_of(const AssemblyMesh& mesh, int planet_count) {
  AssemblyCondition result{.teeth =
                               std::vector<long long>(static_cast<std::size_t>(planet_count), 0)};
  result.teeth[static_cast<std::size_t>(mesh.planet)] += mesh.teeth;
  if (mesh.mate < 0) {
    result.constant = mesh.mate_teeth;
  } else {
    result.teeth[static_cast<std::size_t>(mesh.mate)] += mesh.mate_teeth;
  }
  return result;
}

void subtract(AssemblyCondition& from, long long times, const AssemblyCondition& what) {
  for (std::size_t i = 0; i < from.teeth.size(); ++i) {
    from.teeth[i] -= times * what.teeth[i];
  }
  from.constant -= times * what.constant;
}

// Euclid's algorithm on one column: of the conditions from `begin` on, only the first keeps it.
// Answers whether any has it.
bool eliminate(std::vector<AssemblyCondition>& conditions, std::size_t begin, std::size_t column) {
  const auto size = [&](const AssemblyCondition& one) { return std::abs(one.teeth[column]); };
  while (true) {
    std::size_t pivot = conditions.size();
    for (std::size_t i = begin; i < conditions.size(); ++i) {
      const bool is_smaller =
          pivot == conditions.size() || size(conditions[i]) < size(conditions[pivot]);
      pivot = size(conditions[i]) > 0 && is_smaller ? i : pivot;
    }
    if (pivot == conditions.size()) {
      return false;
    }
    std::swap(conditions[begin], conditions[pivot]);
    bool is_done = true;
    for (std::size_t i = begin + 1; i < conditions.size(); ++i) {
      subtract(conditions[i],
               conditions[i].teeth[column] / conditions[begin].teeth[column],
               conditions[begin]);
      is_done = is_done && size(conditions[i]) == 0;
    }
    if (is_done) {
      return true;
    }
  }
}

}  // namespace

std::vector<long long> assembly_teeth(std::span<const AssemblyMesh> meshes, int planet_count) {
  std::vector<AssemblyCondition> conditions;
  for (const AssemblyMesh& mesh : meshes) {
    conditions.push_back(condition_of(mesh, planet_count));
  }
  std::size_t begin = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(planet_count); ++p) {
    begin += eliminate(conditions, begin, p) ? 1 : 0;
  }
  std::vector<long long> result;
  for (std::size_t i = begin; i < conditions.size(); ++i) {
    result.push_back(std::abs(conditions[i].constant));
  }
  std::erase(result, 0);
  return result;
}

}  // namespace kinestat
