#include "pages/motion_figure.hpp"
#include "pages/motion_tables.hpp"
#include "pages/page_parts.hpp"
#include "pages/tables.hpp"
#include "studies/simulation/picture/simulation_curves.hpp"

namespace kinestat {

bool has_drawn_simulation(const FilePage& page) {
  return page.analysis && page.simulation && !page.simulation->rows.drawn.positions.empty();
}

bool leads_with_simulation(const FilePage& page) {
  return has_drawn_simulation(page) && !has_drawn_motion(page);
}

void add_simulation_figure(SectionWriter& section) {
  const FilePage& page = section.page();
  add_motion_figure(*page.analysis,
                    page.simulation->rows,
                    {.name = "simulation", .section = section.id_of(ChartRows::of_simulation)},
                    section.figures(),
                    section.html());
}

void add_simulation_part(SectionWriter& section) {
  const FilePage& page = section.page();
  if (!page.simulation) {
    section.add_lack("simulation", "Simulation", page.description && page.description->simulation);
    return;
  }
  section.open_part("simulation", "Simulation");
  // Its rows, the last table, come below the charts, which show them at a glance.
  TextBlocks above;
  std::optional<Table> rows;
  for (const TextBlock& one : page.simulation->blocks.blocks()) {
    if (rows && one.table) {
      above += TextBlocks(*std::move(rows));
    }
    if (one.table) {
      rows = one.table;
    } else {
      above += TextBlocks(one.lines);
    }
  }
  add_blocks(above, "Simulation", section.html());
  if (has_drawn_simulation(page) && !leads_with_simulation(page)) {
    add_simulation_figure(section);
  }
  const MotionTable& table = page.simulation->rows.table;
  section.html().open("div", {{"class", "charts"}});
  section.add_charts(simulation_figure(table, ""), "Simulation", ChartRows::of_simulation);
  section.add_charts(energy_figure(table, ""), "Simulation", ChartRows::of_simulation);
  section.html().close();
  if (rows) {
    add_table(*rows, "Rows", section.html());
  }
  section.html().close();
}

}  // namespace kinestat
