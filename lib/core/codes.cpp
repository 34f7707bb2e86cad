#include "core/codes.hpp"

#include <algorithm>
#include <array>

namespace kinestat {

namespace {

using enum ExitStatus;

// Sorted by code: find_code searches by halves.
constexpr auto kCodes = std::to_array<Code>({
    {"E0101",
     usage,
     "wrong use of the command line",
     "The command, an option or its value is not one that this program knows. "
     "'kinestat --help' lists the commands, 'kinestat COMMAND --help' the options of one."},
    {"E0102",
     usage,
     "value of --set cannot be used",
     "--set takes NAME=VALUE, where NAME is a parameter of the mechanism file and VALUE a number "
     "or an expression, for example --set N1=24 or --set 'h_z=10 mm'."},
    {"E0151",
     environment,
     "input cannot be read",
     "The file is missing, is not an ordinary file, or may not be read. A folder, a device or a "
     "pipe is refused; give '-' to read standard input."},
    {"E0152",
     environment,
     "output cannot be written",
     "The output folder does not exist, is not a folder, may not be written to, or is full. "
     "Files are written whole or not at all, so what was there before is unchanged."},
    {"E0153",
     environment,
     "output would replace a foreign file",
     "A file of that name exists and was not written by this program. It is left as it is; "
     "choose another folder or give --force."},
    {"E0154",
     environment,
     "out of memory",
     "The machine, or the limit set for this process, has too little memory for the input."},
    {"E0201",
     wrong_input,
     "file is too large",
     "A mechanism file is a few kilobytes. Files above the limit are refused before they are read, "
     "so that a wrong file name cannot exhaust the machine."},
    {"E0202",
     wrong_input,
     "file is not UTF-8 text",
     "Mechanism files are UTF-8. The message names the first byte that is not; most editors can "
     "save the file again 'as UTF-8'."},
    {"E0203",
     wrong_input,
     "control character in the file",
     "Only line ends and spaces may shape the text. A tab may stand inside a line, not at its "
     "beginning, where YAML counts spaces."},
    {"E0204",
     wrong_input,
     "YAML cannot be read",
     "The text is not well-formed YAML: an indentation, a bracket or a quote does not fit."},
    {"E0205",
     wrong_input,
     "document is empty",
     "The file holds no mapping. 'kinestat: 1' and a few keys are the least."},
    {"E0206",
     wrong_input,
     "several documents in one file",
     "One file describes one mechanism: remove '---' and what follows it."},
    {"E0207",
     wrong_input,
     "key is given twice",
     "A mapping may name each key once. YAML readers silently keep one of the two values, which "
     "is never what was meant."},
    {"E0208",
     wrong_input,
     "YAML feature is not supported",
     "Tags, merge keys and keys that are not plain text are refused: the file must mean the same "
     "to every reader."},
    {"E0209",
     wrong_input,
     "alias cannot be used",
     "An alias names an anchor that is not defined before it, or that contains itself."},
    {"E0210",
     wrong_input,
     "file is too deep or too large inside",
     "Nesting, the number of values or the length of one value is above a limit that no mechanism "
     "needs. Expanded aliases count."},
    {"E0301",
     wrong_input,
     "format version is missing or not supported",
     "Every mechanism file begins with 'kinestat: 1', the version of the format it is written in."},
    {"E0302",
     wrong_input,
     "unknown key",
     "The key is not one that is known at this place. Own notes may stand under keys that begin "
     "with 'x-' at the top level."},
    {"E0303",
     wrong_input,
     "required key is missing",
     "The mapping lacks a key without which it has no meaning."},
    {"E0304",
     wrong_input,
     "value has the wrong shape",
     "A list, a mapping or a single value is expected where another one stands."},
    {"E0305",
     wrong_input,
     "value is not one of those allowed",
     "The message lists what may stand."},
    {"E0306",
     wrong_input,
     "name cannot be used",
     "Names are letters, digits, '_' and '-', beginning with a letter or '_'; parameters without "
     "'-', and never the name of a unit."},
    {"E0307",
     wrong_input,
     "name is declared twice",
     "Bodies have one name space; couplings and actuators share another."},
    {"E0308",
     wrong_input,
     "number or expression cannot be read",
     "A value is a YAML number or an expression such as (N1 + N5)/2*module or 20 deg. The caret "
     "marks the place."},
    {"E0309",
     wrong_input,
     "dimensions do not fit",
     "The value has another dimension than its place, or quantities of different dimensions are "
     "added. A bare number takes the unit that 'units:' names."},
    {"E0310",
     wrong_input,
     "parameters depend on each other in a circle",
     "A parameter may use others in any order, but not itself through them."},
    {"E0311",
     wrong_input,
     "unknown name in an expression",
     "The name is neither a parameter nor a unit nor a function."},
    {"E0312",
     wrong_input,
     "coupling joins a body that is not declared",
     "'bodies: [tail, head]' names the ground or bodies of the section 'bodies'."},
    {"E0313",
     wrong_input,
     "reference to something that is not declared",
     "The name must be declared in this file."},
    {"E0314",
     wrong_input,
     "geometry is missing, surplus or degenerate",
     "Each type of coupling needs its own geometry; an axis must not be zero."},
    {"E0315",
     wrong_input,
     "section is not analysed yet",
     "The section belongs to the format, but this version has no analysis for it."},
    {"E0316",
     wrong_input,
     "value has no result",
     "A division by zero, a root of a negative number or a result that is not finite."},
    {"E0401",
     wrong_input,
     "mechanism falls apart",
     "Every body must be joined to the ground through couplings. The message lists the parts."},
    {"E0402",
     wrong_input,
     "tree is not a spanning tree",
     "'tree:' must name as many couplings as there are moving bodies, and they must not close a "
     "circuit."},
    {"E0501",
     wrong_input,
     "primary motions are missing",
     "Exactly as many independent motions must be known as the net degree of freedom."},
    {"E0502",
     wrong_input,
     "primary motions depend on each other",
     "Some of the motions given follow from others, so that they are surplus or contradict them."},
    {"E0503",
     no_answer,
     "velocities are too large",
     "A velocity is beyond what a double holds (about 1e308). The answer is proportional to the "
     "known motions, so smaller ones show it."},
    {"E0601",
     wrong_input,
     "primary actions depend on each other",
     "Some of the actions given follow from others by equilibrium."},
    {"E0602",
     no_answer,
     "equilibrium has no solution",
     "A load acts along a freedom that nothing resists. The message names the body and the motion "
     "that cannot be held."},
    {"E0603",
     no_answer,
     "actions are too large",
     "An action is beyond what a double holds (about 1e308). The answer is proportional to the "
     "known actions, so smaller ones show it."},
    {"E0701",
     no_answer,
     "power balance is violated",
     "The powers of all couplings must sum to zero (Tellegen). A larger residual means that the "
     "numbers cannot be trusted at this position."},
    {"E0901",
     check_failed,
     "published value is missed",
     "The report differs from a value of the 'published:' section by more than its tolerance."},
    {"E0902",
     wrong_input,
     "published value points to nothing",
     "'value:' is a JSON Pointer into the report, for example /cases/M1/ratio."},
    {"W0301", done, "declared but never used", "It may stand, but nothing depends on it."},
    {"W0601",
     done,
     "actions are statically indeterminate",
     "Equilibrium alone does not determine every action with the primary actions given. Determined "
     "ones have values; the others are listed."},
});

}  // namespace

std::span<const Code> all_codes() {
  return kCodes;
}

const Code* find_code(std::string_view code) {
  const auto at = std::ranges::lower_bound(kCodes, code, {}, &Code::code);
  return at != kCodes.end() && at->code == code ? &*at : nullptr;
}

}  // namespace kinestat
