// The coupling graph of one file and, on request, all matrices of the method.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/mechanism.hpp"
#include "network/network_matrices.hpp"
#include "report/report_forms.hpp"

namespace kinestat {

/// Couplings, tree, circuits and cut-sets; the matrices in the given order, if any. The CSV form is
/// one table: `matrix,row,column,value`, or the edge list if there are no matrices.
FileReport make_graph_report(const std::string& file,
                             const MechanismDescription& description,
                             const Mechanism& mechanism,
                             const std::vector<LabelledMatrix>& matrices,
                             const ReportForms& forms);

}  // namespace kinestat
