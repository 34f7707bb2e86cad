#include "couplings/finite_law.hpp"

#include "couplings/internal/law_writer.hpp"
#include "couplings/kinds.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

FiniteLaw finite_law(CouplingType type, Space space, const DrawnCoupling& drawn) {
  LawWriter law(space, drawn);
  kind_of(type).mechanics->law(law);
  return law.take();
}

}  // namespace kinestat
