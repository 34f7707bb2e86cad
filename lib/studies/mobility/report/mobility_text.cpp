#include "studies/mobility/report/mobility_text.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/label_kind.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "studies/mobility/report/mobility_words.hpp"

namespace kinestat {

namespace {

// "a b c d", the couplings of a list.
std::string names_text(const Topology& topology, const std::vector<CouplingId>& couplings) {
  std::vector<std::string> names;
  for (const CouplingId id : couplings) {
    names.push_back(topology.coupling(id).name);
  }
  return fmt::format("{}", fmt::join(names, " "));
}

class MobilityText {
 public:
  explicit MobilityText(const MobilityAnalysis& analysis)
      : analysis_(analysis),
        mobility_(analysis.mobility),
        topology_(analysis.mechanism.topology),
        in_(analysis.description.units) {}

  MobilityBlocks run() const {
    MobilityBlocks blocks{.counts = counts(), .reshetov = {}, .motions = {}};
    if (mobility_.reshetov) {
      blocks.reshetov = reshetov(*mobility_.reshetov);
    }
    if (mobility_.exact) {
      blocks.motions = motions(mobility_.exact->motions);
      blocks.motions += redundancies_text(analysis_);
    }
    return blocks;
  }

  std::string head() const {
    return fmt::format("{}  {} bodies, {} couplings, {}\n\n",
                       title_text(analysis_.file, analysis_.description),
                       topology_.body_count(),
                       topology_.coupling_count(),
                       counted(analysis_.mechanism.graph.circuit_count(), "circuit"));
  }

  std::string remarks() const {
    std::string text;
    for (const std::string& remark : mobility_remarks(analysis_)) {
      text += "  " + remark + "\n";
    }
    return text + "\n";
  }

 private:
  TextBlocks counts() const {
    std::string text = "Grübler: M = order (bodies - 1 - couplings) + freedoms\n";
    text += grubler("space", mobility_.spatial);
    if (mobility_.planar) {
      text += grubler("the plane", *mobility_.planar);
    }
    TextBlocks blocks(text + "\n");
    blocks += classes(mobility_.spatial);
    return mobility_.exact ? blocks += davies(mobility_.exact->counts) : blocks;
  }

  static std::string grubler(const char* where, const GrublerCount& count) {
    return fmt::format("  in {}: M = {} ({} - 1 - {}) + {} = {}\n",
                       where,
                       count.order,
                       count.bodies,
                       count.couplings,
                       count.freedoms,
                       count.mobility);
  }

  TextBlocks classes(const GrublerCount& count) const {
    Table table({"Pairs", "number", "freedoms", "couplings"});
    for (std::size_t i = 0; i < count.classes.size(); ++i) {
      const PairClass& one = count.classes[i];
      if (!one.couplings.empty()) {
        table.add({name_of_class(i),
                   std::to_string(one.couplings.size()),
                   std::to_string(one.freedoms),
                   names_text(topology_, one.couplings)});
      }
    }
    return TextBlocks(std::move(table));
  }

  static TextBlocks davies(const MobilityCounts& counts) {
    Table table({"Davies", "order", "freedoms F", "rank m", "net freedom F_N", "redundant C_N"});
    const auto add = [&](const char* name, const MotionCounts& c) {
      table.add({name,
                 std::to_string(c.order),
                 std::to_string(c.gross_freedom),
                 std::to_string(c.rank),
                 std::to_string(c.net_freedom),
                 std::to_string(c.net_constraint)});
    };
    add("spatial", counts.spatial.motions);
    if (counts.planar) {
      add("planar", counts.planar->motions);
    }
    add("minimal", counts.minimal.motions);
    return TextBlocks(std::move(table));
  }

  // One line a circuit: what it is offered, then what covers each demand.
  TextBlocks reshetov(const ReshetovTable& table) const {
    TextBlocks text("Reshetov: what closes each circuit without force\n");
    for (const ReshetovCircuit& circuit : table.circuits) {
      Table rows(
          {topology_.coupling(circuit.chord).name, "Rx", "Ry", "Rz", "Tx", "Ty", "Tz", "oblique"});
      std::vector<std::string> offered = {"offered"};
      std::vector<std::string> covered = {"covered by"};
      for (std::size_t i = 0; i < kClosures.size(); ++i) {
        offered.push_back(circuit.offered[i] == 0 ? "." : std::to_string(circuit.offered[i]));
        const std::optional<int>& cover = circuit.covered_by[i];
        covered.push_back(cover ? analysis_.in_space.topology.freedom_name(*cover) : "missing");
      }
      const int oblique = circuit.oblique_rotations + circuit.oblique_translations;
      offered.push_back(oblique == 0 ? "." : std::to_string(oblique));
      covered.emplace_back("");
      rows.add(std::move(offered));
      rows.add(std::move(covered));
      text += fmt::format("  circuit of {}: {}\n",
                          topology_.coupling(circuit.chord).name,
                          names_text(topology_, circuit.couplings));
      text += TextBlocks(std::move(rows), "    ");
    }
    std::vector<std::string> unused;
    for (const int f : table.unused) {
      unused.push_back(analysis_.in_space.topology.freedom_name(f));
    }
    text += fmt::format("  missing: {} redundant; left over: mobility {}{}\n\n",
                        table.redundant,
                        table.mobility,
                        unused.empty() ? "" : fmt::format(" ({})", fmt::join(unused, ", ")));
    return text;
  }

  QuantityKind rate_kind(int f) const {
    return kind_of(topology_.freedoms[static_cast<std::size_t>(f)]);
  }

  TextBlocks motions(const MotionSpace& space) const {
    if (space.net_freedom == 0) {
      return TextBlocks("Motions: none\n\n");
    }
    TextBlocks text(fmt::format(
        "Motions: {}{}\n", space.net_freedom, space.motions.empty() ? ", too many to list" : ""));
    for (std::size_t i = 0; i < space.motions.size(); ++i) {
      text += motion(i, space.motions[i]);
    }
    text += singularity();
    return text += space.motions.empty() ? "\n" : "";
  }

  // Whether the motion goes on beyond the instant.
  std::string persistence(std::size_t i) const {
    if (!analysis_.finite || i >= analysis_.finite->trials.size()) {
      return "";
    }
    switch (analysis_.finite->trials[i].persistence) {
      case Persistence::finite:
        return "     finite: the mechanism can follow it\n";
      case Persistence::deflected:
        return "     deflected: the mechanism moves, but leaves this direction at once\n";
      case Persistence::instantaneous:
        return "     instantaneous: the mechanism shakes, but cannot follow it\n";
    }
    return "";
  }

  std::string singularity() const {
    if (!analysis_.finite || !analysis_.finite->is_singular()) {
      return "";
    }
    const std::string gained = names_text(topology_, analysis_.finite->gained);
    return fmt::format("  The drawn position is singular: {} here, {} close by{}\n\n",
                       counted(analysis_.finite->drawn_freedom, "freedom"),
                       analysis_.finite->nearby_freedom,
                       gained.empty() ? "" : "; only here move " + gained);
  }

  TextBlocks motion(std::size_t index, const FreeMotion& motion) const {
    const FileUnits& units = in_.units();
    const double first = units.factor(rate_kind(motion.first));
    std::vector<std::string> rates;
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      if (motion.rates[f] != 0.0) {
        rates.push_back(
            fmt::format("{} = {} {}",
                        topology_.freedom_name(f),
                        format_short(motion.rates[f] * (first / units.factor(rate_kind(f)))),
                        units.text(rate_kind(f))));
      }
    }
    TextBlocks text(fmt::format("  {}. {}\n", index + 1, fmt::join(rates, ", ")));
    text += persistence(index);
    if (motion.is_passive()) {
      std::vector<std::string> bodies;
      for (const BodyId body : motion.passive) {
        bodies.push_back(topology_.body(body).name);
      }
      text +=
          fmt::format("     passive: only {} moves, no other body\n", fmt::join(bodies, " and "));
    }
    text += screws(motion);
    return text += "\n";
  }

  TextBlocks screws(const FreeMotion& motion) const {
    const Geometry& geometry = analysis_.mechanism.geometry;
    const std::string length = in_.units().text(QuantityKind::length);
    Table table({"Body", "motion", "through [" + length + "]", "pitch [" + length + "]"});
    for (std::size_t b = 1; b < topology_.bodies.size(); ++b) {
      const std::optional<ScrewAxis> axis = motion.axis_of(b, geometry.length);
      if (!axis) {
        continue;
      }
      if (!axis->pitch) {
        table.add({topology_.bodies[b].name,
                   "shifts along " + direction_words(axis->direction),
                   "",
                   "infinite"});
        continue;
      }
      const Vec3 point = in_.length(geometry.origin.in_world(*axis->point));
      table.add({topology_.bodies[b].name,
                 "turns about " + direction_words(axis->direction),
                 fmt::format("({}, {}, {})",
                             format_short(point.x()),
                             format_short(point.y()),
                             format_short(point.z())),
                 format_short(in_.length(*axis->pitch))});
    }
    return {std::move(table), "     "};
  }

  const MobilityAnalysis& analysis_;
  const Mobility& mobility_;
  const Topology& topology_;
  InUnits in_;
};

}  // namespace

MobilityBlocks mobility_blocks(const MobilityAnalysis& analysis) {
  return MobilityText(analysis).run();
}

TextBlocks mobility_text(const MobilityAnalysis& analysis) {
  const MobilityText text(analysis);
  const MobilityBlocks blocks = text.run();
  TextBlocks all(text.head() + text.remarks());
  all += blocks.counts;
  all += blocks.reshetov;
  return all += blocks.motions;
}

}  // namespace kinestat
