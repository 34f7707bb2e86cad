// Tables with a row a case or a step, as spreadsheets and plotting programs read them.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

enum class TableLayout {
  tidy,  ///< a row a value
  wide   ///< a row a case, a point or a step of a motion, and a column a value
};

/// A tidy table as a wide one: `mechanism,case,status`, with `file` before them or `step` behind
/// them where the tidy one has such a column, then "element/quantity [unit]", each with its pass in
/// front where two passes have one of that name, and behind it the parameter with which it changes,
/// where the tidy one has such a column. `status` is that of the first pass which is not
/// "solved", as its first value has it. Events of a motion, which lie between steps, and what
/// belongs to no case stay out.
std::string wide_table(std::string_view tidy);

}  // namespace kinestat
