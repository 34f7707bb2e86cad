#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "draw/catalogue/catalogue_parts.hpp"
#include "draw/graph/graph_drawing.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "draw/linkage/page_linkage.hpp"
#include "draw/picture_title.hpp"
#include "draw/train/gear_scheme.hpp"

namespace kinestat {

namespace {

bool has_power(const CaseAnalysis& one) {
  return one.power.has_value();
}

std::string why_no_power(const PictureSource& source) {
  return why_not_in_cases(source, has_power, "power, for which velocities and actions are needed");
}

// Pictures are named as in the catalogue.
Picture named(std::string_view name, Picture picture) {
  picture.name = name;
  return picture;
}

// The case that is asked for, or the first that counts.
std::size_t case_of(const PictureSource& source, bool (*counts)(const CaseAnalysis&)) {
  const std::vector<CaseAnalysis>& cases = source.analysis->cases;
  return source.which
             ? *source.which
             : static_cast<std::size_t>(std::ranges::find_if(cases, counts) - cases.begin());
}

std::string why_no_gears(const PictureSource& source) {
  return why_no_gear_scheme(*source.analysis, source.sections);
}

std::string why_no_nothing(const PictureSource&) {
  return "";
}

// How many graphs one picture may show.
constexpr int kMostGraphs = 60;

std::string why_no_graphs(int count, std::string_view name) {
  if (count > kMostGraphs) {
    return fmt::format("its graph has {} {}s, more than a picture shows", count, name);
  }
  return count == 0 ? fmt::format("its graph has no {}", name) : "";
}

std::string why_no_circuits(const PictureSource& source) {
  return why_no_graphs(source.analysis->mechanism.graph.circuit_count(), "circuit");
}

std::string why_no_cutsets(const PictureSource& source) {
  return why_no_graphs(source.analysis->mechanism.graph.cutset_count(), "cut-set");
}

std::string why_no_mechanism(const PictureSource& source) {
  const bool is_empty = source.placed == nullptr &&
                        source.analysis->mechanism.topology.couplings.empty() &&
                        source.analysis->mechanism.topology.body_count() <= 1;
  return is_empty ? "it has no bodies and no couplings" : "";
}

LinkageOptions options_of(const PictureSource& source) {
  LinkageOptions options;
  if (!source.analysis->cases.empty()) {
    options.which = source.which.value_or(0);
  }
  return options;
}

Picture draw_mechanism(const PictureSource& source) {
  return source.placed != nullptr
             ? draw_placed(*source.placed)
             : named("linkage", draw_linkage(*source.analysis, options_of(source)));
}

std::vector<Picture> draw_mechanism_of_page(const PictureSource& source) {
  return {source.placed != nullptr
              ? draw_placed(*source.placed)
              : named("linkage", draw_page_linkage(*source.analysis, options_of(source)))};
}

Picture draw_scheme(const PictureSource& source) {
  return named(
      "gear-scheme",
      *draw_gear_scheme(*source.analysis, {.which = source.which, .sections = source.sections}));
}

Picture draw_coupling_graph(const PictureSource& source) {
  return named("coupling-graph", draw_graph(coupling_graph_model(*source.analysis)));
}

Picture draw_motion_graph(const PictureSource& source) {
  return named("motion-graph", draw_graph(motion_graph_model(*source.analysis)));
}

Picture draw_action_graph(const PictureSource& source) {
  return named("action-graph", draw_graph(action_graph_model(*source.analysis)));
}

Picture draw_circuits(const PictureSource& source) {
  return named("circuits",
               *draw_graphs(circuit_models(*source.analysis),
                            picture_title("Fundamental circuits", *source.analysis)));
}

Picture draw_cutsets(const PictureSource& source) {
  return named("cut-sets",
               *draw_graphs(cutset_models(*source.analysis),
                            picture_title("Fundamental cut-sets", *source.analysis)));
}

GraphModel power_of(const PictureSource& source) {
  return power_model(*source.analysis, case_of(source, has_power));
}

Picture draw_power(const PictureSource& source) {
  return named("power-flow", draw_graph(power_of(source)));
}

template <GraphModel model_of(const Analysis&)>
std::string graph_text(const PictureSource& source) {
  return dot_text(model_of(*source.analysis));
}

std::string power_text(const PictureSource& source) {
  return dot_text(power_of(source));
}

constexpr auto kDrawingKinds = std::to_array<PictureKind>({
    {.name = "linkage",
     .sentence = "the mechanism to scale, with the forces of a case",
     .scope = PictureScope::one_case,
     .takes_positions = true,
     .why_not = why_no_mechanism,
     .draw = draw_mechanism,
     .draw_in_parts = draw_mechanism_of_page},
    {.name = "gear-scheme",
     .sentence =
         "a gear train along its axis, or all its axes developed, with its clutches and brakes",
     .scope = PictureScope::one_case,
     .why_not = why_no_gears,
     .draw = draw_scheme},
    {.name = "coupling-graph",
     .sentence = "bodies and couplings as a graph, with its tree",
     .why_not = why_no_nothing,
     .draw = draw_coupling_graph,
     .dot = graph_text<coupling_graph_model>},
    {.name = "motion-graph",
     .sentence = "the graph with a line for each freedom",
     .why_not = why_no_nothing,
     .draw = draw_motion_graph,
     .dot = graph_text<motion_graph_model>},
    {.name = "action-graph",
     .sentence = "the graph with a line for each constraint",
     .why_not = why_no_nothing,
     .draw = draw_action_graph,
     .dot = graph_text<action_graph_model>},
    {.name = "circuits",
     .sentence = "the fundamental circuits in the graph",
     .why_not = why_no_circuits,
     .draw = draw_circuits},
    {.name = "cut-sets",
     .sentence = "the fundamental cut-sets in the graph",
     .why_not = why_no_cutsets,
     .draw = draw_cutsets},
    {.name = "power-flow",
     .sentence = "where the power of a case goes, and how much",
     .scope = PictureScope::one_case,
     .why_not = why_no_power,
     .draw = draw_power,
     .dot = power_text},
});

}  // namespace

std::span<const PictureKind> drawing_kinds() {
  return kDrawingKinds;
}

}  // namespace kinestat
