#include "studies/synthesis/linkages/defects.hpp"

#include "core/contract.hpp"

namespace kinestat {

std::string_view word_of(Defect defect) {
  switch (defect) {
    case Defect::none:
      return "none";
    case Defect::digits:
      return "digits";
    case Defect::circuit:
      return "circuit";
    case Defect::branch:
      return "branch";
    case Defect::order:
      return "order";
    case Defect::grashof:
      return "class";
    case Defect::other_circuit:
      return "other_circuit";
    case Defect::full_turn:
      return "turns_fully";
    case Defect::centre_point:
      return "centre_points";
    case Defect::circle_point:
      return "circle_points";
    case Defect::transmission:
      return "transmission_angle";
    case Defect::full_transmission:
      return "full_transmission_angle";
    case Defect::ratio:
      return "link_ratio";
    case Defect::size:
      return "size";
  }
  return "";
}

std::string_view limit_of(Defect defect) {
  return defect == Defect::other_circuit ? "circuit" : word_of(defect);
}

void Defects::add(Defect defect) {
  KINESTAT_EXPECTS(defect != Defect::none);
  all_.set(static_cast<std::size_t>(defect));
}

Defect Defects::worst() const {
  for (std::size_t i = 1; i < kDefectCount; ++i) {
    if (all_[i]) {
      return static_cast<Defect>(i);
    }
  }
  return Defect::none;
}

}  // namespace kinestat
