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
  const SimulationBlocks& blocks = page.simulation->blocks;
  add_blocks(blocks.end, "Simulation", section.html());
  if (has_drawn_simulation(page) && !leads_with_simulation(page)) {
    add_simulation_figure(section);
  }
  const MotionTable& table = page.simulation->rows.table;
  section.html().open("div", {{"class", "charts"}});
  section.add_charts(simulation_figure(table, ""), "Simulation", ChartRows::of_simulation);
  section.add_charts(energy_figure(table, ""), "Simulation", ChartRows::of_simulation);
  section.html().close();
  // Below the charts, which show them at a glance.
  add_blocks(blocks.rows, "Rows", section.html());
  section.html().close();
}

}  // namespace kinestat
