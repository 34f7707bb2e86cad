#include "statics/lossy_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense/dense_solve.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/internal/friction_system.hpp"

namespace kinestat {

namespace {

// So many times at most the senses are corrected by the powers that they cause; hardly ever more
// than twice.
constexpr int kMostSenseSteps = 100;

// Of each mesh that takes part in the search: whether its head is the driven gear.
using Senses = std::vector<bool>;

// Laws of couplings first, then two of each mesh.
std::vector<FrictionLaw> all_laws(const LossyStatics& given) {
  std::vector<FrictionLaw> laws(given.frictions.begin(), given.frictions.end());
  for (const MeshLossLaw& mesh : given.meshes) {
    laws.push_back(mesh.head_driven);
    laws.push_back(mesh.tail_driven);
  }
  return laws;
}

bool is_answer(LossSearch search) {
  return search == LossSearch::found || search == LossSearch::rejected;
}

// How many laws of each sort there are.
struct LawCounts {
  std::size_t frictions = 0;
  std::size_t meshes = 0;
};

// The losses of meshes as an affine function of the frictions of couplings: first + rest · f.
struct LinearLosses {
  VecX first;
  MatX rest;
};

class SenseSearch {
 public:
  SenseSearch(const FrictionSystem& system,
              const LawCounts& counts,
              const std::function<bool(const VecX&)>& is_accepted)
      : system_(system), counts_(counts), is_accepted_(is_accepted) {
    for (std::size_t i = 0; i < counts.frictions; ++i) {
      if (!system.is_open(i)) {
        frictions_.push_back(i);
      }
    }
    for (std::size_t m = 0; m < counts.meshes; ++m) {
      if (!system.is_open(law_of(m, true)) && !system.is_open(law_of(m, false))) {
        meshes_.push_back(m);
      }
    }
  }

  LossSearch run() {
    const Senses ideal = ideal_senses();
    const LossSearch result = search(ideal);
    if (result == LossSearch::found && std::ssize(meshes_) <= kMostSearchedMeshes &&
        !is_contraction(*best_)) {
      (void)try_all(ideal, [&](ChosenFrictions one) { return take_other(std::move(one)); });
    }
    return result;
  }

  // Accepted, or the first that agrees with itself.
  const std::optional<ChosenFrictions>& best() const { return best_; }

  // Which mesh a law of those chosen is of, and whether its head is the driven gear.
  std::pair<std::size_t, bool> mesh_of(std::size_t law) const {
    const std::size_t i = law - counts_.frictions;
    return {i / 2, i % 2 == 0};
  }

  // Accepted as well, with other actions.
  const std::optional<ChosenFrictions>& other() const { return other_; }

 private:
  LossSearch search(const Senses& ideal) {
    if (iterate(ideal)) {
      return LossSearch::found;
    }
    if (std::ssize(meshes_) > kMostSearchedMeshes) {
      return LossSearch::undecided;
    }
    if (try_all(ideal, [&](ChosenFrictions one) { return take(std::move(one)); })) {
      return LossSearch::found;
    }
    return best_ ? LossSearch::rejected : LossSearch::none;
  }

  std::size_t law_of(std::size_t mesh, bool head_is_driven) const {
    return counts_.frictions + 2 * mesh + (head_is_driven ? 0 : 1);
  }

  Senses ideal_senses() const {
    Senses senses;
    for (const std::size_t m : meshes_) {
      const FrictionFunction function = system_.function_of(law_of(m, true), {});
      senses.push_back(function.forces.front().constant.x() >= 0.0);
    }
    return senses;
  }

  bool iterate(Senses senses) {
    std::set<Senses> seen;
    while (seen.insert(senses).second && std::ssize(seen) <= kMostSenseSteps) {
      const std::optional<ChosenFrictions> found = solve(senses);
      if (!found) {
        return false;
      }
      const Senses next = turned(senses, *found);
      if (next == senses) {
        return take(*found);
      }
      senses = next;
    }
    return false;
  }

  // Until one that agrees with itself is taken.
  bool try_all(const Senses& ideal, const std::function<bool(ChosenFrictions)>& take_one) {
    std::vector<std::uint32_t> masks(std::size_t{1} << meshes_.size());
    std::iota(masks.begin(), masks.end(), 0U);
    std::ranges::stable_sort(masks, {}, [](std::uint32_t mask) { return std::popcount(mask); });
    return std::ranges::any_of(masks, [&](std::uint32_t mask) {
      Senses senses = ideal;
      for (std::size_t i = 0; i < senses.size(); ++i) {
        senses[i] = senses[i] != (((mask >> i) & 1U) != 0U);
      }
      const std::optional<ChosenFrictions> found = solve(senses);
      return found && turned(senses, *found) == senses && take_one(*found);
    });
  }

  // Whether losses change what is lost by less than they are, in whatever senses, so that there is
  // one answer. They are compared as powers. Whichever gear of a mesh is held back, the others feel
  // as much of it, for its teeth pass on a couple of either; its own power differs by the loss.
  bool is_contraction(const ChosenFrictions& found) const {
    const auto speed = [&](std::size_t i) {
      return std::abs(system_.law(found.laws[frictions_.size() + i]).speed);
    };
    const auto first = static_cast<Eigen::Index>(frictions_.size());
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      const FrictionFunction function =
          system_.function_of(found.laws[frictions_.size() + m], found.laws);
      const PressingForce& force = function.forces.front();
      double sum = force.part->weight;
      for (std::size_t j = 0; j < meshes_.size(); ++j) {
        sum +=
            std::abs(force.part->weight * force.slopes(0, first + static_cast<Eigen::Index>(j))) *
            speed(m) / speed(j);
      }
      if (!(sum < 1.0)) {
        return false;
      }
    }
    return true;
  }

  // The senses of what does not roll under load differ without a difference.
  bool take_other(ChosenFrictions found) {
    const VecX actions = system_.actions_with(found);
    const VecX known = system_.actions_with(*best_);
    if (!is_accepted_(actions) ||
        (actions - known).norm() <= kConsistency * (actions.norm() + known.norm())) {
      return false;
    }
    other_ = std::move(found);
    return true;
  }

  bool take(ChosenFrictions found) {
    for (double& one : found.magnitudes) {
      one = std::max(one, 0.0);
    }
    const bool is_good = is_accepted_(system_.actions_with(found));
    if (is_good || !best_) {
      best_ = std::move(found);
    }
    return is_good;
  }

  // Each mesh whose driven gear is found to drive, the other way round. Powers are compared, as
  // couples on gears of different size say nothing of each other.
  Senses turned(Senses senses, const ChosenFrictions& found) const {
    const auto power_of = [&](std::size_t i) {
      const std::size_t at = frictions_.size() + i;
      const FrictionLaw& law = system_.law(found.laws[at]);
      return found.magnitudes[static_cast<Eigen::Index>(at)] * law.speed / law.parts.front().weight;
    };
    double largest = 0.0;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      largest = std::max(largest, std::abs(power_of(i)));
    }
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      senses[i] = senses[i] != (power_of(i) < -kPowerBalance * largest);
    }
    return senses;
  }

  std::optional<ChosenFrictions> solve(const Senses& senses) const {
    ChosenFrictions result{.laws = frictions_, .magnitudes = {}};
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      result.laws.push_back(law_of(meshes_[i], senses[i]));
    }
    const std::optional<LinearLosses> losses = linear_losses(result.laws);
    const std::optional<VecX> f = losses ? frictions_with(*losses, result.laws) : std::nullopt;
    if (!f) {
      return std::nullopt;
    }
    result.magnitudes.resize(f->size() + losses->first.size());
    result.magnitudes << *f, losses->first + losses->rest * *f;
    return result;
  }

  // f_m = share (c + A_f f + A_m f_m), solved for f_m; empty if singular.
  std::optional<LinearLosses> linear_losses(const std::vector<std::size_t>& laws) const {
    const auto friction_count = static_cast<Eigen::Index>(frictions_.size());
    const auto count = static_cast<Eigen::Index>(meshes_.size());
    MatX system = MatX::Identity(count, count);
    LinearLosses right{.first = VecX::Zero(count), .rest = MatX::Zero(count, friction_count)};
    for (Eigen::Index r = 0; r < count; ++r) {
      const std::size_t law = laws[static_cast<std::size_t>(friction_count + r)];
      const FrictionFunction function = system_.function_of(law, laws);
      const PressingForce& force = function.forces.front();
      const double share = force.part->weight;
      right.first[r] = share * force.constant.x();
      for (Eigen::Index f = 0; f < friction_count; ++f) {
        right.rest(r, f) = share * force.slopes(0, f);
      }
      system.row(r) -= share * force.slopes.row(0).tail(count);
    }
    const std::optional<VecX> first = solve_dense(system, right.first);
    if (!first) {
      return std::nullopt;
    }
    LinearLosses solved{.first = *first, .rest = right.rest};
    for (Eigen::Index c = 0; c < friction_count; ++c) {
      const std::optional<VecX> column = solve_dense(system, VecX(right.rest.col(c)));
      if (!column) {
        return std::nullopt;
      }
      solved.rest.col(c) = *column;
    }
    return solved;
  }

  // The frictions of couplings in presence of the losses; empty if they lock.
  std::optional<VecX> frictions_with(const LinearLosses& losses,
                                     const std::vector<std::size_t>& laws) const {
    if (frictions_.empty()) {
      return VecX(0);
    }
    std::vector<FrictionFunction> functions;
    for (const std::size_t i : frictions_) {
      FrictionFunction function = system_.function_of(i, laws);
      for (PressingForce& force : function.forces) {
        const auto count = static_cast<Eigen::Index>(frictions_.size());
        const MatX of_losses = force.slopes.rightCols(losses.first.size());
        force.constant += of_losses * losses.first;
        force.slopes = MatX(force.slopes.leftCols(count) + of_losses * losses.rest);
      }
      functions.push_back(std::move(function));
    }
    return follow_friction(functions);
  }

  const FrictionSystem& system_;
  LawCounts counts_;
  const std::function<bool(const VecX&)>& is_accepted_;
  std::vector<std::size_t> frictions_;  // laws of couplings that can be evaluated
  std::vector<std::size_t> meshes_;     // likewise
  std::optional<ChosenFrictions> best_;
  std::optional<ChosenFrictions> other_;
};

}  // namespace

LossySystem::LossySystem(const Mechanism& mechanism,
                         const CoordinateBasis& basis,
                         const LossyStatics& given,
                         const StaticSolution& frictionless)
    : friction_count_(given.frictions.size()),
      mesh_count_(given.meshes.size()),
      laws_(all_laws(given)),
      system_(
          std::make_unique<FrictionSystem>(mechanism, basis, given.primaries, given.loads, laws_)) {
  for (const MeshLossLaw& mesh : given.meshes) {
    shares_.push_back({.lossy = mesh.lossy, .radius = mesh.radius, .planets = mesh.planets});
  }
  system_->find_open(frictionless.check.undetermined);
}

bool LossySystem::has_shares_by_law() const {
  return std::ranges::any_of(shares_,
                             [](const MeshShare& one) { return one.lossy->law.has_value(); });
}

// The shares of meshes under these actions; answers by how much one of them moves. Empty where one
// has no value.
std::optional<double> LossySystem::take_shares(const VecX& actions) {
  double moved = 0.0;
  for (std::size_t m = 0; m < shares_.size(); ++m) {
    const MeshShare& one = shares_[m];
    if (!one.lossy->law) {
      continue;
    }
    FrictionLaw& head = laws_[friction_count_ + 2 * m];
    FrictionLaw& tail = laws_[friction_count_ + 2 * m + 1];
    const double torque = std::abs(system_->pressing_of(friction_count_ + 2 * m, 0, actions).x());
    const std::optional<double> share =
        share_at(*one.lossy, one.radius * head.speed, torque / (one.radius * one.planets));
    if (!share) {
      return std::nullopt;
    }
    double& weight = head.parts.front().weight;
    moved = std::max(moved, std::abs(*share - weight));
    weight = *share;
    tail.parts.front().weight = *share;
  }
  return moved;
}

// Shares that depend on force begin with that without losses.
template <class Search>
LossSearch LossySystem::settle(std::optional<Search>& search,
                               const std::function<bool(const VecX&)>& is_accepted) {
  constexpr int kMostRounds = 60;
  const LawCounts counts = {.frictions = friction_count_, .meshes = mesh_count_};
  if (has_shares_by_law() && !take_shares(system_->frictionless())) {
    return LossSearch::no_share;
  }
  for (int round = 0; round < kMostRounds; ++round) {
    search.emplace(*system_, counts, is_accepted);
    const LossSearch outcome = search->run();
    if (!has_shares_by_law() || !search->best()) {
      return outcome;
    }
    const std::optional<double> moved = take_shares(system_->actions_with(*search->best()));
    if (!moved) {
      return LossSearch::no_share;
    }
    if (*moved <= kCancellation) {
      return outcome;
    }
  }
  return LossSearch::undecided;
}

LossySystem::LossySystem(LossySystem&&) noexcept = default;
LossySystem& LossySystem::operator=(LossySystem&&) noexcept = default;
LossySystem::~LossySystem() = default;

void LossySystem::set_primaries(std::span<const double> values) {
  system_->set_primaries(values);
}

void LossySystem::set_friction(std::size_t friction, double speed, double constant) {
  laws_[friction].speed = speed;
  laws_[friction].constant = constant;
}

void LossySystem::set_mesh_speeds(std::size_t mesh, double head, double tail) {
  laws_[friction_count_ + 2 * mesh].speed = head;
  laws_[friction_count_ + 2 * mesh + 1].speed = tail;
}

bool LossySystem::is_determined() const {
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    if (system_->is_open(i)) {
      return false;
    }
  }
  return true;
}

std::optional<LossyMagnitudes> LossySystem::solve(
    const std::function<bool(const VecX&)>& is_accepted) {
  std::optional<SenseSearch> search;
  LossyMagnitudes result{.search = settle(search, is_accepted),
                         .actions = {},
                         .frictions = std::vector<double>(friction_count_, 0.0),
                         .losses = std::vector<double>(mesh_count_, 0.0),
                         .head_is_driven = std::vector<bool>(mesh_count_, true)};
  if (!is_answer(result.search) || !search->best()) {
    return std::nullopt;
  }
  const ChosenFrictions& best = *search->best();
  result.actions = system_->actions_with(best);
  for (std::size_t i = 0; i < best.laws.size(); ++i) {
    const double magnitude = best.magnitudes[static_cast<Eigen::Index>(i)];
    if (best.laws[i] < friction_count_) {
      result.frictions[best.laws[i]] = magnitude;
      continue;
    }
    const auto [mesh, head_is_driven] = search->mesh_of(best.laws[i]);
    result.losses[mesh] = magnitude;
    result.head_is_driven[mesh] = head_is_driven;
  }
  return result;
}

LossyActions LossySystem::solve_whole(const std::function<bool(const VecX&)>& is_accepted) {
  std::optional<SenseSearch> search;
  LossyActions result{.search = settle(search, is_accepted), .solution = {}, .other = {}};
  if (result.search == LossSearch::no_share || !search || !search->best()) {
    result.solution.status = SolveStatus::locked_by_friction;
    return result;
  }
  result.solution = system_->solution_with(*search->best());
  if (search->other()) {
    result.other = system_->solution_with(*search->other());
  }
  return result;
}

}  // namespace kinestat
