// The same linkages as rigid bodies of Simbody.
#pragma once

#include <memory>

#include "mass_linkage.hpp"

namespace kinestat::bench {

/// Positions with what their drives must do, and the reactions of the joints.
class SimbodyRows {
 public:
  explicit SimbodyRows(const MassLinkage& linkage);
  ~SimbodyRows();
  SimbodyRows(const SimbodyRows&) = delete;
  SimbodyRows& operator=(const SimbodyRows&) = delete;

  /// One after the other over the whole stroke, the drawn position among them.
  void run(int steps);

  /// What the first drive does in the last position [N or N·m], along its rate.
  double last_action() const;

 private:
  struct Model;

  std::unique_ptr<Model> model_;
};

}  // namespace kinestat::bench
