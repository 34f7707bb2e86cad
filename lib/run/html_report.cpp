#include "run/html_report.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "description/mechanism_description.hpp"
#include "draw/train/gear_scheme.hpp"
#include "files/each_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "pages/html_document.hpp"
#include "pages/motion_figure.hpp"
#include "report/file/file_report.hpp"
#include "report/tables/wide_table.hpp"
#include "run/analyse.hpp"
#include "run/mobility.hpp"
#include "run/motion.hpp"
#include "run/sensitivity.hpp"
#include "run/simulation.hpp"
#include "run/sweep.hpp"
#include "run/synthesis.hpp"
#include "studies/duty/report/duty_report.hpp"
#include "studies/duty/task/find_duty.hpp"
#include "studies/motion/picture/drawn_actions_maker.hpp"
#include "studies/motion/picture/drawn_motion_maker.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/simulation/picture/drawn_simulation.hpp"
#include "studies/simulation/report/simulation_report.hpp"
#include "studies/simulation/report/simulation_table.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"
#include "studies/transmissions/task/transmission_files.hpp"

namespace kinestat {

namespace {

PageMotion page_motion(const MechanismDescription& description,
                       const FoundMotion& motion,
                       const Mechanism& mechanism) {
  const auto count = static_cast<std::size_t>(motion.solution.position_count());
  std::vector<std::size_t> shown = shown_positions(mechanism, count);
  DrawnMotion drawn = make_drawn_motion(motion, motion.solution, shown, mechanism);
  DrawnActions acting = make_drawn_actions(description, mechanism, motion, shown, drawn);
  return {.table = motion.table,
          .shown = std::move(shown),
          .drawn = std::move(drawn),
          .acting = std::move(acting)};
}

PageMotion page_rows(const FoundSimulation& simulation, const SimulationReportView& view) {
  std::vector<std::size_t> shown =
      shown_positions(simulation.mechanism, simulation.solution.rows.size());
  DrawnMotion drawn = make_drawn_simulation(simulation, shown);
  DrawnActions acting = make_drawn_actions(simulation, shown, drawn);
  return {.table = simulation_table(view),
          .shown = std::move(shown),
          .drawn = std::move(drawn),
          .acting = std::move(acting)};
}

class PageBuilder {
 public:
  PageBuilder(const std::string& path, const AnalyseOptions& options)
      : path_(path), options_(options) {}

  FilePage run() && {
    page_.source.path = path_;
    page_.description = load_description(path_, options_.load, page_.source, page_.found);
    if (page_.description) {
      analyse();
      if (!page_.analysis) {
        move_alone();
      }
      simulate();
      sweep();
      synthesize();
      page_.data.push_back({.name = printable(report_stem(path_)) + ".yaml",
                            .type = "application/yaml",
                            .text = page_.source.text});
    }
    return std::move(page_);
  }

 private:
  void analyse() {
    std::optional<Mechanism> mechanism = bind(*page_.description, page_.found);
    if (page_.found.has_errors()) {
      return;
    }
    if (mechanism) {
      auto certified = analyse_mechanism(path_,
                                         {.description = *page_.description,
                                          .mechanism = *std::move(mechanism),
                                          .shift = std::nullopt},
                                         options_.accuracy,
                                         page_.found);
      if (certified) {
        const Analysis& analysis = certified->analysis;
        if (analysis.description.motion) {
          move(analysis.mechanism, page_.found);
        }
        add_data("report",
                 make_report(analysis,
                             certified->certainty,
                             page_.motion ? &page_.motion->table : nullptr,
                             kForms,
                             page_.found));
        sum_duty(analysis);
        differentiate(analysis);
        page_.analysis = std::move(certified->analysis);
      }
    }
    if (mechanism || !page_.description->synthesis) {
      Diagnostics found;
      page_.mobility = find_mobility(path_, *page_.description, options_.accuracy, found);
      add_new(found, page_.found);
      if (page_.mobility) {
        add_data("mobility", make_mobility_report(*page_.mobility, kForms, page_.found));
      }
    }
  }

  void move(const Mechanism& mechanism, Diagnostics& found) {
    const std::optional<FoundMotion> motion = find_motion(*page_.description, mechanism, found);
    if (motion) {
      page_.motion = page_motion(*page_.description, *motion, mechanism);
    }
  }

  // A motion closes a drawing that does not close before it begins.
  void move_alone() {
    if (!page_.description->motion) {
      return;
    }
    Diagnostics found;
    if (const auto mechanism = bind_unassembled(*page_.description, found)) {
      move(*mechanism, found);
    }
    add_new(found, page_.found);
    if (page_.motion) {
      add_data(
          "motion",
          make_motion_report(
              {.file = path_, .description = *page_.description, .motion = page_.motion->table},
              kForms,
              page_.found));
    }
  }

  void sum_duty(const Analysis& analysis) {
    if (!analysis.description.duty) {
      return;
    }
    Diagnostics found;
    const std::optional<FoundDuty> duty = find_duty(path_, "", judged_file(analysis), found);
    add_new(found, page_.found);
    if (!duty) {
      return;
    }
    const DutyReportView view{.file = path_,
                              .description = analysis.description,
                              .mechanism = analysis.mechanism,
                              .plan = duty->plan,
                              .duty = duty->solution,
                              .found = &page_.found};
    page_.duty = {.blocks = duty_blocks(view), .maps = map_duty(analysis.mechanism, duty->plan)};
    add_data("duty", make_duty_report(view, kForms));
  }

  // Cases without an answer, or a file without parameters, have no derivatives to show.
  void differentiate(const Analysis& analysis) {
    if (analysis.description.parameters.empty() || analysis.cases.empty()) {
      return;
    }
    Diagnostics found;
    const std::optional<FoundSensitivity> answer = find_sensitivity(analysis, {}, found);
    if (!answer) {
      return;
    }
    add_new(found, page_.found);
    for (const CaseSensitivity& one : answer->cases) {
      TextBlocks blocks = sensitivity_blocks(one, answer->parameters);
      if (!blocks.is_empty()) {
        page_.sensitivity.push_back({.label = one.label, .blocks = std::move(blocks)});
      }
    }
    if (!page_.sensitivity.empty()) {
      add_data("sensitivity",
               make_sensitivity_report(
                   path_, analysis.description, answer->parameters, answer->cases, kForms, found));
    }
  }

  void simulate() {
    if (!page_.description->simulation) {
      return;
    }
    Diagnostics found;
    const std::optional<FoundSimulation> answer = find_simulation(*page_.description, found);
    add_new(found, page_.found);
    if (answer && !answer->solution.rows.empty()) {
      const SimulationReportView view = simulation_view(path_, *page_.description, *answer, &found);
      page_.simulation = {.rows = page_rows(*answer, view), .blocks = simulation_blocks(view)};
      add_data("simulation", make_simulation_report(view, kForms));
    }
  }

  void sweep() {
    if (!page_.description->sweep) {
      return;
    }
    Diagnostics found;
    page_.sweep = find_sweep_table(page_.source, *page_.description, found);
    add_new(found, page_.found);
    if (page_.sweep && !page_.sweep->csv.empty()) {
      page_.data.push_back({.name = printable(report_stem(path_)) + ".sweep.csv",
                            .type = "text/csv",
                            .text = page_.sweep->csv});
    }
  }

  void synthesize() {
    if (!page_.description->synthesis) {
      return;
    }
    Diagnostics found;
    if (page_.description->synthesis->transmission) {
      page_.transmissions = find_transmissions(path_, *page_.description, {}, found);
      add_new(found, page_.found);
      if (page_.transmissions) {
        draw_schemes(*page_.transmissions);
        add_data("synthesis", make_transmission_report(*page_.transmissions, kForms, page_.found));
      }
      return;
    }
    page_.synthesis = find_synthesis(path_, *page_.description, {}, found);
    add_new(found, page_.found);
    if (page_.synthesis) {
      add_data("synthesis", make_synthesis_report(*page_.synthesis, kForms, page_.found));
    }
  }

  // Of the first transmission of each of the best ladders.
  void draw_schemes(const TransmissionAnalysis& found) {
    constexpr std::size_t kMostSchemes = 10;
    for (std::size_t i = 0; i < std::min(found.groups.size(), kMostSchemes); ++i) {
      const Analysis solved = solve_transmission(found, found.groups[i].variants.front());
      if (std::optional<Picture> scheme = draw_gear_scheme(solved)) {
        scheme->title = fmt::format("Transmission {}.0", i);
        page_.schemes.push_back(*std::move(scheme));
      }
    }
  }

  void add_data(const std::string& pass, FileReport report) {
    const std::string stem = printable(report_stem(path_));
    page_.data.push_back({.name = fmt::format("{}.{}.json", stem, pass),
                          .type = "application/json",
                          .text = std::move(report.json)});
    for (NamedTable& table : report.csv) {
      const std::string name = fmt::format("{}.{}.csv", stem, table.pass);
      const bool is_there =
          std::ranges::find(page_.data, name, &PageData::name) != page_.data.end();
      if (!is_there) {
        // A row a value would be most of the page.
        std::string text = table.pass == "motion" ? wide_table(table.text) : std::move(table.text);
        page_.data.push_back({.name = name, .type = "text/csv", .text = std::move(text)});
      }
    }
  }

  static constexpr ReportForms kForms{.json = true, .csv = true};

  const std::string& path_;
  const AnalyseOptions& options_;
  FilePage page_;
};

bool can_be_written(const HtmlReportOptions& page, InputPaths inputs, Outcome& outcome) {
  if (page.path.empty()) {
    return true;
  }
  const OutputFile file{
      .path = page.path, .content = {}, .signature = std::string(html_signature())};
  Diagnostics found;
  const bool is_free = check_places(std::span(&file, 1), page.overwrite, inputs, found);
  if (!found.items().empty()) {
    add_diagnostics({}, found, Strictness::normal, outcome);
  }
  return is_free;
}

void write_page(std::string html,
                const HtmlReportOptions& page,
                InputPaths inputs,
                Outcome& outcome) {
  if (page.path.empty()) {
    outcome.out += html;
    return;
  }
  const OutputFile file{
      .path = page.path, .content = std::move(html), .signature = std::string(html_signature())};
  Diagnostics found;
  if (write_files(std::span(&file, 1), page.overwrite, inputs, found)) {
    outcome.out += fmt::format("{}: written\n", printable(page.path));
  } else {
    add_diagnostics({}, found, Strictness::normal, outcome);
  }
}

}  // namespace

Outcome html_report_of_files(const std::vector<std::string>& paths,
                             const HtmlReportOptions& page,
                             const AnalyseOptions& options) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  const std::vector<std::string> inputs = input_paths(paths, options.load);
  if (!can_be_written(page, inputs, outcome)) {
    return outcome;
  }
  std::vector<FilePage> pages;
  Outcome read = for_each_file(paths, options, [&](const std::string& path, Outcome& of_file) {
    pages.push_back(PageBuilder(path, options).run());
    add_diagnostics(pages.back().source, pages.back().found, options.strictness, of_file);
  });
  write_page(html_report(pages), page, inputs, read);
  return read;
}

}  // namespace kinestat
