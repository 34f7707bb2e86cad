#include "studies/graph/graph_report.hpp"

#include <array>

#include <fmt/format.h>

#include "core/text.hpp"
#include "couplings/kinds.hpp"
#include "graph/cutsets.hpp"
#include "report/csv.hpp"
#include "report/file/report_record.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

std::string matrix_csv(const std::vector<LabelledMatrix>& matrices) {
  std::string text = "matrix,row,column,value\n";
  for (const LabelledMatrix& matrix : matrices) {
    for (std::size_t r = 0; r < matrix.rows.size(); ++r) {
      for (std::size_t c = 0; c < matrix.columns.size(); ++c) {
        const double value =
            matrix.value(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
        text += csv_line(
            std::array{matrix.symbol, matrix.rows[r], matrix.columns[c], format_exact(value)});
      }
    }
  }
  return text;
}

// Of each coupling: name, type, tail, head, part.
std::vector<std::vector<std::string>> edge_rows(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  std::vector<std::vector<std::string>> rows;
  for (const CouplingTopology& coupling : topology.couplings) {
    rows.push_back({coupling.name,
                    std::string(word_of(coupling.type)),
                    topology.body(coupling.tail).name,
                    topology.body(coupling.head).name,
                    "chord"});
  }
  for (const int branch : mechanism.graph.tree.branches) {
    rows[static_cast<std::size_t>(branch)].back() = "branch";
  }
  return rows;
}

std::string edge_csv(const Mechanism& mechanism) {
  std::string text = "coupling,type,tail,head,part\n";
  for (const std::vector<std::string>& row : edge_rows(mechanism)) {
    text += csv_line(row);
  }
  return text;
}

// "h: h + a - e - f": the couplings of a circuit or cut-set with their signs, its own first.
std::string signed_sum(const Topology& topology,
                       const CouplingGraph& graph,
                       const MatXi& rows,
                       Eigen::Index row,
                       int own) {
  const auto name = [&](int e) { return topology.couplings[static_cast<std::size_t>(e)].name; };
  std::string text = fmt::format("  {}: {}", name(own), name(own));
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    const int edge = graph.columns[static_cast<std::size_t>(c)];
    if (edge != own && rows(row, c) != 0) {
      text += fmt::format(" {} {}", rows(row, c) > 0 ? '+' : '-', name(edge));
    }
  }
  return text + "\n";
}

std::string sums_text(const Mechanism& mechanism) {
  const CouplingGraph& graph = mechanism.graph;
  const MatXi cutsets = cutset_matrix(graph);
  const MatXi circuits = circuit_matrix(cutsets);
  std::string text = "Cut-sets\n";
  for (std::size_t i = 0; i < graph.tree.branches.size(); ++i) {
    text += signed_sum(
        mechanism.topology, graph, cutsets, static_cast<Eigen::Index>(i), graph.tree.branches[i]);
  }
  text += "\nCircuits\n";
  for (std::size_t i = 0; i < graph.tree.chords.size(); ++i) {
    text += signed_sum(
        mechanism.topology, graph, circuits, static_cast<Eigen::Index>(i), graph.tree.chords[i]);
  }
  return text + "\n";
}

TextBlocks matrix_blocks(const LabelledMatrix& matrix) {
  std::vector<std::string> head = {matrix.symbol};
  head.insert(head.end(), matrix.columns.begin(), matrix.columns.end());
  Table table(std::move(head));
  for (std::size_t r = 0; r < matrix.rows.size(); ++r) {
    std::vector<std::string> row = {matrix.rows[r]};
    for (Eigen::Index c = 0; c < matrix.value.cols(); ++c) {
      const double value = matrix.value(static_cast<Eigen::Index>(r), c);
      row.push_back(value == 0.0 ? "." : format_short(value));
    }
    table.add(std::move(row));
  }
  TextBlocks blocks(fmt::format("{} ({} x {}): {}\n",
                                matrix.symbol,
                                matrix.value.rows(),
                                matrix.value.cols(),
                                matrix.meaning));
  return blocks += TextBlocks(std::move(table));
}

TextBlocks graph_blocks(const MechanismDescription& description, const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  TextBlocks blocks(fmt::format("{}\n  {} bodies, {} couplings: {} in the tree, {}\n\n",
                                description.name,
                                topology.body_count(),
                                topology.coupling_count(),
                                mechanism.graph.cutset_count(),
                                counted(mechanism.graph.circuit_count(), "chord")));
  Table table({"Coupling", "type", "tail", "head", "part"});
  for (std::vector<std::string>& row : edge_rows(mechanism)) {
    table.add(std::move(row));
  }
  blocks += TextBlocks(std::move(table));
  blocks += sums_text(mechanism);
  return blocks;
}

}  // namespace

FileReport make_graph_report(const std::string& file,
                             const MechanismDescription& description,
                             const Mechanism& mechanism,
                             const std::vector<LabelledMatrix>& matrices,
                             const ReportForms& forms) {
  FileReport report;
  const ReportView view{
      .file = file, .description = description, .mechanism = &mechanism, .matrices = matrices};
  add_json(report_record, view, description.units, forms, report);
  if (forms.csv) {
    report.csv.push_back(
        {.pass = "graph", .text = matrices.empty() ? edge_csv(mechanism) : matrix_csv(matrices)});
  }
  if (forms.text) {
    report.text = graph_blocks(description, mechanism);
    for (const LabelledMatrix& matrix : matrices) {
      report.text += matrix_blocks(matrix);
    }
  }
  return report;
}

}  // namespace kinestat
