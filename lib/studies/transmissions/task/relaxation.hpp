// What keeps a task without an answer from having one.
#pragma once

#include <string>

#include "studies/transmissions/search.hpp"

namespace kinestat {

/// The single requirement without which there would be most transmissions, in a sentence that also
/// says where not all of them were tried: searching anew without each may take as long as a search
/// may. `stages` are those of the search that found none.
std::string relaxation_text(const TransmissionTask& task,
                            const SearchStages& stages,
                            const ForEach& for_each);

}  // namespace kinestat
