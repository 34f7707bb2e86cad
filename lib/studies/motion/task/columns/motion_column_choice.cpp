#include "studies/motion/task/columns/motion_column_choice.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/column_path.hpp"
#include "mechanism/motion_column_names.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/task/columns/motion_column_offers.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

namespace {

// "at/x" and "at/y" of one element.
bool is_of_one_vector(const MotionColumn& a, const MotionColumn& b) {
  const auto stem = [](const MotionColumn& one) {
    return std::string_view(one.quantity).substr(0, one.quantity.rfind('/'));
  };
  return a.element == b.element && stem(a) == stem(b);
}

class ColumnChoice {
 public:
  ColumnChoice(const MechanismDescription& description,
               const Mechanism& mechanism,
               MotionPlan& plan,
               Diagnostics& found)
      : description_(description),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        plan_(plan),
        found_(found) {
    std::vector<int> driven;
    for (const PlannedDrive& drive : plan.drives) {
      driven.push_back(drive.freedom);
    }
    const MotionNetwork network =
        make_motion_network(mechanism, bind_drawn_couplings(description, mechanism), driven);
    first_.freedoms = freedom_positions(network, mechanism, drawn_configuration(network));
    offers_ = offers_of(plan.which);
  }

  bool run() {
    const std::vector<Name> names = std::exchange(plan_.report.columns, {});
    if (!check_report(plan_, mechanism_, found_)) {
      return false;  // columns of the words can be made only where the case has what they need
    }
    ChosenColumns chosen;
    for (const MotionReading& one : motion_readings(description_, mechanism_, plan_, first_)) {
      chosen.usual.push_back(one.column.name());
    }
    bool are_known = true;
    for (const Name& name : names) {
      const std::vector<const MotionColumnOffer*> meant = columns_of(name.text, offers_);
      for (const MotionColumnOffer* const one : meant) {
        chosen.named.push_back(one->column.name());
        unite(plan_.report, one->needs);
      }
      if (meant.empty()) {
        refuse(name);
        are_known = false;
      }
    }
    plan_.report.chosen = std::move(chosen);
    return are_known;
  }

 private:
  // Those of the drives and of how well circuits close are in every table.
  std::vector<MotionColumnOffer> offers_of(int which) const {
    MotionPlan plan = plan_;
    plan.which = which;
    std::vector<MotionColumnOffer> offers =
        motion_column_offers(description_, mechanism_, plan, first_.freedoms);
    for (const PlannedDrive& drive : plan_.drives) {
      offers.push_back({.column = {.element = name_of(drive.actuator),
                                   .quantity = std::string(kDriveColumn),
                                   .unit = {}},
                        .needs = {}});
    }
    offers.push_back(
        {.column = {.element = {}, .quantity = std::string(kClosureErrorColumn), .unit = {}},
         .needs = {}});
    return offers;
  }

  const std::string& name_of(int actuator) const {
    return topology_.actuators[static_cast<std::size_t>(actuator)].name;
  }

  bool means(const std::string& asked, const MotionColumn& column) const {
    return std::ranges::any_of(names_of(column, topology_), [&](const auto& name) {
      const auto& [element, quantity] = name;
      if (element.empty()) {
        return begins_with_parts(quantity, asked);
      }
      return begins_with_parts(asked, element) &&
             begins_with_parts(element + "." + quantity, asked);
    });
  }

  std::vector<const MotionColumnOffer*> columns_of(
      const std::string& name, const std::vector<MotionColumnOffer>& offers) const {
    std::vector<const MotionColumnOffer*> meant;
    for (const MotionColumnOffer& one : offers) {
      if (means(dotted(name), one.column)) {
        meant.push_back(&one);
      }
    }
    return meant;
  }

  void refuse(const Name& name) {
    if (lacks_case(name.text)) {
      return;
    }
    if (dotted(name.text) == kTimeColumn) {
      found_.error("E0303",
                   name.where,
                   "'motion' reports 'time' and therefore needs the key 'time'",
                   "add for example time: 0.5 s");
      return;
    }
    std::vector<std::string> all;
    std::vector<std::string> elements;
    std::vector<std::string> of_element;
    for (const MotionColumnOffer& one : offers_) {
      all.push_back(one.column.name());
      const std::string& part = one.column.element;
      if (!part.empty() && std::ranges::find(elements, part) == elements.end()) {
        elements.push_back(part);
      }
      for (const auto& [element, quantity] : names_of(one.column, topology_)) {
        if (!element.empty() && begins_with_parts(dotted(name.text), element)) {
          of_element.push_back(one.column.name());
        }
      }
    }
    const std::string rest =
        of_element.empty()
            ? fmt::format("columns are called NAME/QUANTITY, as {}; they are of {}",
                          name_of(plan_.drives.front().actuator) + "/" + std::string(kDriveColumn),
                          plain_list(elements))
            : fmt::format("it has {}", plain_list(of_element));
    found_.error("E0313",
                 name.where,
                 fmt::format("the motion has no column '{}'", printable(name.text)),
                 guess_before(name.text, of_element.empty() ? all : of_element, rest));
  }

  // Where the case does not say what the column needs, that is the matter.
  bool lacks_case(const std::string& name) {
    for (std::size_t c = 0; c < mechanism_.cases.size() && plan_.which < 0; ++c) {
      const std::vector<MotionColumnOffer> offers = offers_of(static_cast<int>(c));
      const auto meant = columns_of(name, offers);
      if (!meant.empty()) {
        return !can_report(meant.front()->needs);
      }
    }
    const bool is_of_dynamics = std::ranges::any_of(kColumnsOfDynamics, [&](std::string_view one) {
      return begins_with_parts(dotted(name), std::string(one));
    });
    if (is_of_dynamics && !can_report(report_of_word("dynamics"))) {
      return true;
    }
    return std::ranges::any_of(motion_report_words(), [&](const std::string& word) {
      const std::string text = "." + dotted(name) + ".";
      return text.find("." + word + ".") != std::string::npos && !can_report(report_of_word(word));
    });
  }

  bool can_report(const MotionReport& report) {
    MotionPlan plan = plan_;
    plan.report = report;
    return check_report(plan, mechanism_, found_);
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  MotionPlan& plan_;
  Diagnostics& found_;
  MotionPosition first_;
  std::vector<MotionColumnOffer> offers_;
};

}  // namespace

bool choose_columns(const MechanismDescription& description,
                    const Mechanism& mechanism,
                    MotionPlan& plan,
                    Diagnostics& found) {
  return plan.report.columns.empty() || ColumnChoice(description, mechanism, plan, found).run();
}

void keep_readings(const std::function<bool(const MotionColumn&)>& is_wanted,
                   std::vector<MotionReading>& readings) {
  std::vector<MotionReading> kept;
  for (MotionReading& one : readings) {
    const bool is_next = !kept.empty() && is_of_one_vector(kept.back().column, one.column);
    if (is_wanted(one.column)) {
      if (one.alone && !is_next) {
        one.value = one.alone;
      }
      kept.push_back(std::move(one));
    }
  }
  readings = std::move(kept);
}

}  // namespace kinestat
