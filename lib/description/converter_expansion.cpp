#include "description/converter_expansion.hpp"

#include <utility>

namespace kinestat {

std::string stator_name(const CouplingDescription& converter) {
  return converter.name.text + "_stator";
}

void expand_converters(MechanismDescription& description) {
  std::vector<CouplingDescription> stators;
  for (const CouplingDescription& coupling : description.couplings) {
    if (coupling.type != CouplingType::torque_converter || !coupling.stator) {
      continue;
    }
    CouplingDescription stator = coupling;
    stator.name = {.text = stator_name(coupling), .where = coupling.name.where};
    stator.tail = *coupling.stator;
    stator.stator.reset();
    stator.stator_of = coupling.name.text;
    stators.push_back(std::move(stator));
  }
  for (CouplingDescription& stator : stators) {
    description.couplings.push_back(std::move(stator));
  }
}

}  // namespace kinestat
