#include "studies/motion/task/columns/motion_column_offers.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

#include "mechanism/column_path.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

namespace {

void unite(std::vector<int>& all, const std::vector<int>& some) {
  for (const int one : some) {
    if (std::ranges::find(all, one) == all.end()) {
      all.push_back(one);
    }
  }
}

// No more than the one column needs of them.
MotionReport needs_of(const MotionColumn& column, MotionReport needs, const Topology& topology) {
  if (!needs.positions.empty()) {
    std::erase_if(needs.positions,
                  [&](int f) { return topology.freedom_name(f) != column.element; });
  }
  for (int a = 0; needs.action && a < topology.action_count(); ++a) {
    if (topology.action_name(a) == column.element) {
      needs.action = false;
      needs.actions = {a};
    }
  }
  return needs;
}

class OfferList {
 public:
  OfferList(const MechanismDescription& description,
            const Mechanism& mechanism,
            MotionPlan plan,
            const std::vector<std::optional<double>>& positions)
      : description_(description), mechanism_(mechanism), plan_(std::move(plan)) {
    first_.freedoms = positions;
  }

  std::vector<MotionColumnOffer> run() {
    MotionReport positions;
    for (int f = 0; f < mechanism_.topology.freedom_count(); ++f) {
      positions.positions.push_back(f);
    }
    add(positions);
    for (const std::string& word : motion_report_words()) {
      add(report_of_word(word));
    }
    return std::move(offers_);
  }

 private:
  void add(const MotionReport& needs) {
    plan_.report = needs;
    Diagnostics ignored;
    if (!check_report(plan_, mechanism_, ignored)) {
      return;
    }
    for (MotionReading& one : motion_readings(description_, mechanism_, plan_, first_)) {
      if (names_.insert(one.column.name()).second) {
        MotionReport least = needs_of(one.column, needs, mechanism_.topology);
        offers_.push_back({.column = std::move(one.column), .needs = std::move(least)});
      }
    }
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  MotionPlan plan_;
  MotionPosition first_;
  std::unordered_set<std::string> names_;
  std::vector<MotionColumnOffer> offers_;
};

}  // namespace

std::vector<std::pair<std::string, std::string>> names_of(const MotionColumn& column,
                                                          const Topology& topology) {
  const std::string element = dotted(column.element);
  const std::string quantity = dotted(column.quantity);
  std::vector<std::pair<std::string, std::string>> names = {{element, quantity}};
  for (const ActuatorTopology& actuator : topology.actuators) {
    if (column.element == topology.freedom_name(actuator.freedom)) {
      names.emplace_back(dotted(actuator.name), quantity);
    }
  }
  constexpr std::string_view kPlace = "at.";
  if (quantity.starts_with(kPlace)) {
    const std::string axis = quantity.substr(kPlace.size());
    names.emplace_back(element, axis);
    names.emplace_back(element, "position." + axis);
  }
  return names;
}

MotionReport report_of_word(const std::string& word) {
  MotionReport report;
  *find_report_word(word, report) = true;
  return report;
}

void unite(MotionReport& all, MotionReport some) {
  for (const std::string& word : motion_report_words()) {
    bool& is_asked = *find_report_word(word, all);
    is_asked = is_asked || *find_report_word(word, some);
  }
  unite(all.positions, some.positions);
  unite(all.actions, some.actions);
}

std::vector<MotionColumnOffer> motion_column_offers(
    const MechanismDescription& description,
    const Mechanism& mechanism,
    MotionPlan plan,
    const std::vector<std::optional<double>>& positions) {
  return OfferList(description, mechanism, std::move(plan), positions).run();
}

}  // namespace kinestat
