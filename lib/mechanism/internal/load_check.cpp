#include "mechanism/internal/load_check.hpp"

#include <fmt/format.h>

namespace kinestat {

namespace {

void check_load(const LoadDescription& load, const SectionContext& context) {
  const std::string role = fmt::format("load '{}' acts on", load.name.text);
  context.names.bodies.check(load.body, role, context.found);
  context.point(load.at);
  if (load.force) {
    context.components(load.force->coordinates, QuantityKind::force);
  }
  context.components(load.couple, QuantityKind::moment);
}

}  // namespace

void check_loads(const SectionContext& context) {
  for (const LoadDescription& load : context.description.loads) {
    check_load(load, context);
  }
  for (const CaseDescription& one : context.description.cases) {
    for (const LoadDescription& load : one.loads) {
      check_load(load, context);
    }
  }
}

}  // namespace kinestat
