#include "core/codes.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/internal/analysis_codes.hpp"
#include "core/internal/warning_codes.hpp"

namespace kinestat {

namespace {

using enum ExitStatus;

// Of calls, files and descriptions. Sorted by code, like the others: find_code searches by halves.
constexpr auto kErrorCodes = std::to_array<Code>({
    {"E0101",
     usage,
     "wrong use of the command line",
     "A command, an option or a value is unknown to this program, or one is missing. Nothing was "
     "written. The message names the word and, where there is one, the nearest match; 'kinestat "
     "--help' lists the commands, 'kinestat COMMAND --help' the options of one."},
    {"E0102",
     usage,
     "value of --set cannot be used",
     "--set gives a parameter of the mechanism file another value for this run. It takes "
     "NAME=VALUE, where NAME is one of the section 'parameters' and VALUE a number or an "
     "expression of the same dimension as the value in the file; in the shell, quote a value with "
     "spaces, as in --set 'h_z=10 mm'."},
    {"E0103",
     usage,
     "wrong use of the library",
     "A function of libkinestat, or of what is built on it, was given a name that the mechanism or "
     "its report does not have, an infinite value or NaN, or nothing at all where a value is "
     "required. Nothing was changed. The message names it and, where there is one, the nearest "
     "match."},
    {"E0151",
     environment,
     "input cannot be read",
     "The file does not exist, is not a regular file, or may not be read; the message gives the "
     "reason reported by the system. A folder, a device or a pipe is refused, because reading it "
     "might never end; use '-' to read standard input."},
    {"E0152",
     environment,
     "output cannot be written",
     "The folder or the file cannot be written: it does not exist, may not be written to, or the "
     "disk is full; the message gives the reason reported by the system. Files are written "
     "completely or not at all, so the previous contents are unchanged. This program does not "
     "create the folder of --out, so that a misspelt name leaves no traces."},
    {"E0153",
     environment,
     "output would replace a foreign file",
     "A file of that name exists, and it is not a report that this program wrote, or it holds the "
     "words for the numbers of an array of a sweep. It is left unchanged, because it may hold work "
     "that exists nowhere else. Choose another folder or name, or give --force if it may be "
     "replaced. A file that the command itself reads is never replaced."},
    {"E0154",
     environment,
     "out of memory",
     "The machine, or the limit set for this process, has too little memory for the input. No file "
     "was left partly written. Raise the limit ('ulimit -v'), or remove from the file what does "
     "not belong to the mechanism."},
    {"E0155",
     bug,
     "internal error",
     "The program reached a state that should be impossible: this is a bug in the program, not a "
     "mistake in the file. The other files of the run are still analysed. Please report it with "
     "the file and the line that was printed."},
    {"E0201",
     wrong_input,
     "file is too large",
     "A mechanism file is a few kilobytes. Larger ones are refused before they are read, so that a "
     "wrong file name cannot exhaust the memory; the message gives the limit. Usually another file "
     "was meant."},
    {"E0202",
     wrong_input,
     "file is not UTF-8 text",
     "Mechanism files are UTF-8 text. The message shows the first bytes that are not, and what "
     "they look like: another encoding, or no text at all. Most editors can save the file as "
     "UTF-8; iconv converts it."},
    {"E0203",
     wrong_input,
     "control character in the file",
     "Only line ends and spaces may lay out the text. A tab is allowed inside a line but not at "
     "its start, where YAML counts columns and editors disagree on its width; other control "
     "characters are invisible and have no meaning. Replace tabs by spaces."},
    {"E0204",
     wrong_input,
     "YAML cannot be read",
     "The text is not well-formed YAML: a bracket or a quote is not closed, or an indentation does "
     "not match the lines around it. The location given is that of the opening bracket or of the "
     "line that does not match."},
    {"E0205",
     wrong_input,
     "document is empty",
     "The file contains no mapping: it is empty, or contains only comments. Perhaps it was not "
     "saved, or another file was meant. 'kinestat new' writes a starter file."},
    {"E0206",
     wrong_input,
     "several documents in one file",
     "One file describes one mechanism. YAML allows several documents in a file, separated by "
     "'---', but which of them is meant could only be guessed. Remove '---' and what follows it, "
     "or make two files, which may be analysed together."},
    {"E0207",
     wrong_input,
     "key is given twice",
     "A mapping may contain each key only once. Most YAML readers silently keep one of the two "
     "values, which is never what was meant. The note shows the first occurrence; remove or rename "
     "one of the two."},
    {"E0208",
     wrong_input,
     "YAML feature is not supported",
     "Tags, merge keys, directives and keys that are not plain text belong to YAML, but not to "
     "this format, because a file must have the same meaning for every reader. Write the value "
     "itself."},
    {"E0209",
     wrong_input,
     "alias cannot be used",
     "An alias (*name) repeats what an earlier anchor (&name) marks. Here the anchor is missing, "
     "comes later, or contains the alias itself. Define the anchor first, or use a parameter, "
     "which may be defined anywhere."},
    {"E0210",
     wrong_input,
     "file is too deep or too large inside",
     "Nesting, the number of values or the length of one value exceeds a limit that no mechanism "
     "needs; aliases count with everything that they repeat. The limits prevent a broken or "
     "hostile file from exhausting the machine. The message names the limit that was exceeded."},
    {"E0301",
     wrong_input,
     "format version is missing or not supported",
     "Every mechanism file contains 'kinestat: 1', the version of its format, so that a later "
     "format cannot be mistaken for this one. Add the line, or use a newer version of the program "
     "for a file in a newer format."},
    {"E0302",
     wrong_input,
     "unknown key",
     "The key is not known at this place, so its value would be ignored silently. Usually it is "
     "misspelt or one level too deep or too high; the hint names the permitted keys. You can keep "
     "your own notes at the top level under keys that begin with 'x-'."},
    {"E0303",
     wrong_input,
     "required key is missing",
     "The mapping lacks a key without which it has no meaning, and there is no sensible default. "
     "The hint says what to add."},
    {"E0304",
     wrong_input,
     "value has the wrong shape",
     "A list, a mapping or a single value is expected, but the value has another form, or a list "
     "has the wrong length: points are [x, y] in the plane and [x, y, z] in space. The hint shows "
     "the form. A decimal comma turns one number into two, and true and false are not text unless "
     "quoted."},
    {"E0305",
     wrong_input,
     "value is not one of those allowed",
     "Only certain words, or numbers within limits, are allowed here, and this value is not one of "
     "them: a coupling type that does not exist, a negative stiffness, or a coefficient of "
     "friction where there is no normal force. The hint gives the permitted values; 'kinestat help "
     "couplings' explains the coupling types."},
    {"E0306",
     wrong_input,
     "name cannot be used",
     "Names consist of letters, digits, '_' and '-', and begin with a letter or '_'. Names of "
     "parameters have no '-', which would be a subtraction, and are never a unit, a function, pi "
     "or a word used in conditions (and, or, not): with a parameter 'm', '2 m' would no longer be "
     "two metres. Labels of cases are free text."},
    {"E0307",
     wrong_input,
     "name is declared twice",
     "Two things of one kind have the same name, so that a reference could mean either, or a name "
     "is given twice where it is allowed only once. Bodies have one namespace; couplings and "
     "actuators share another. The note shows the first occurrence; rename or remove one of the "
     "two."},
    {"E0308",
     wrong_input,
     "number or expression cannot be read",
     "A value is a number or an expression such as (N1 + N5)/2*module or 20 deg. The caret marks "
     "where reading failed: a parenthesis, an operator or a unit that does not exist, or a "
     "notation that readers interpret differently (017, 0x1F, 1,5). 'kinestat help expressions' "
     "and 'kinestat help units' show what is allowed."},
    {"E0309",
     wrong_input,
     "dimensions do not fit",
     "The value does not have the dimension required here, or quantities of different dimensions "
     "are added, or a function requires another one. A bare number takes the unit that 'units:' "
     "sets for the quantity, but inside an expression it remains a pure number: write its unit "
     "there."},
    {"E0310",
     wrong_input,
     "parameters in a circle, or open ones that depend on each other",
     "Parameters may use each other in any order, but not in a circle: none of them would ever "
     "have a value. The message lists the circle; give one of them a number. Nor may a parameter "
     "that is left open, {free: …}, use another open one: it would depend on that one and no "
     "longer be open."},
    {"E0311",
     wrong_input,
     "unknown name in an expression",
     "The name in an expression is neither a parameter nor a unit nor a function. The hint gives "
     "the nearest match; otherwise declare it in the section 'parameters'. Names are "
     "case-sensitive."},
    {"E0312",
     wrong_input,
     "body is not declared",
     "Couplings, loads, gear members and cables name the ground or bodies of the section 'bodies'. "
     "A name that is not declared there is treated as a misspelling and not as a new body, since a "
     "mechanism with an additional body has other results."},
    {"E0313",
     wrong_input,
     "reference to something that is not declared",
     "The name refers to something not declared in this file: a coupling, an actuator, a freedom "
     "(coupling.wz) or an action (coupling.Rx). The hint lists what there is. Bodies are not "
     "actuators: a motion belongs to a coupling."},
    {"E0314",
     wrong_input,
     "geometry is missing, surplus or degenerate",
     "Each type of coupling needs its own geometry and no other, and a direction must not be zero: "
     "otherwise its freedoms and constraints are undefined. The message names what is missing, "
     "surplus or degenerate; 'kinestat help couplings' lists what each type requires."},
    {"E0315",
     no_answer,
     "mechanism is not analysed yet",
     "The file is correct, but something in it that affects the result is part of the format and "
     "not yet of the analysis in this version: a freewheel that 'shift' does not name, a point "
     "that differs from body to body (only 'kinestat motion' closes it), friction of some types, "
     "or a coupling without its location. A result that ignored it would be wrong, so there is "
     "none, and the exit status is 5. The hint says what to write instead; 'kinestat help format' "
     "lists what is not analysed."},
    {"E0316",
     wrong_input,
     "value has no result",
     "The expression is well-formed, but has no value: a division by zero, a root of a negative "
     "number, or a result that is too large or too small for a number. The message names the "
     "operation; with parameters, their values may be the cause."},
    {"E0317",
     wrong_input,
     "cable cannot run as it is drawn",
     "A cable, belt or chain runs straight from one station to the next and touches pulleys from "
     "outside. Here no such line exists, because a point lies inside a pulley, pulleys overlap or "
     "do not lie in one plane, or the line passes through another pulley of the cable. The message "
     "gives the distances; 'kinestat help cables' shows how cables run."},
    {"E0318",
     wrong_input,
     "clutch joins bodies on two axes",
     "A clutch joins bodies that turn about one axis. Here their distances differ, by "
     "'centre_distance' or by the teeth: when engaged, the clutch would hold both still, and every "
     "gear that uses it would be locked. The message gives both distances; give the gears of both "
     "the same 'centre_distance', or give one to their axis in 'axes' of 'gears', or correct the "
     "teeth."},
    {"E0319",
     wrong_input,
     "idler is not a planet",
     "A gear that turns on a shaft, meshes once and is clutched to that shaft is an idler, as on "
     "the lay shaft of a manual gearbox. With the shaft as the carrier of its mesh it would be a "
     "planet that orbits with the shaft, and every ratio would be that of another machine. Its "
     "mesh has no carrier: the centres of both gears are fixed to the ground."},
    {"E0320",
     wrong_input,
     "number is too large to compute with",
     "Distances, forces and speeds are multiplied with each other and squared. A number above 1e60 "
     "in SI units would soon exceed the range of floating-point numbers and leave no result, and "
     "so would the reciprocal size of a mechanism smaller than 1e-60 m. A point at infinity is a "
     "direction: use a prismatic coupling instead of a revolute."},
    {"E0321",
     wrong_input,
     "range without extent",
     "The range of circle points is an area, given by two opposite corners under 'vary'. Both "
     "corners are the same point, so there is nothing to choose from."},
    {"E0322",
     wrong_input,
     "impossible inertia",
     "The principal moments of inertia of a body are not negative, and none exceeds the sum of the "
     "other two, because each is an integral over the same mass; a tensor is symmetric. The "
     "message gives the three moments. Usually a decimal point is wrong, the six numbers are in "
     "another order, the tensor is not about the centre of mass, or its products have the opposite "
     "sign: here Jxy = -integral of x*y. For a rotor of which only the moment about its axis is "
     "known, write {polar: NUMBER, axis: z}."},
    {"E0323",
     wrong_input,
     "rotor turns about another axis",
     "{polar: NUMBER, axis: AXIS} gives the inertia of a body that turns about that axis alone, so "
     "that its other moments of inertia have no effect. Here the body turns about another axis, "
     "where they do. Give the three moments of inertia, or the rows of the tensor."},
    {"E0324",
     no_answer,
     "spring force is undefined in this position",
     "In this position the force of a spring is undefined: its two points coincide, so that it has "
     "no direction, and its force there is not zero; a gas spring is longer than extended or "
     "shorter than compressed; it acts on a freedom that has no position, such as those of balls "
     "and contacts; or it damps, and the case does not determine the speed of its ends. The "
     "actions of the case are unknown there. The message names the spring."},
    {"E0325",
     wrong_input,
     "points do not make a curve",
     "A curve has at least two points in increasing order. A repeating curve ends one 'period' "
     "after its start with the value with which it began, or omits that point and continues to the "
     "first by itself; no point lies beyond the period. 'kinestat help curves' shows each kind."},
    {"E0326",
     no_answer,
     "curve is undefined in this position",
     "A load or an action of the case follows a curve that is undefined in this position: the "
     "position is beyond the points of a curve without a 'period'; the curve is over time in a "
     "motion without time; it is over an actuator whose position or speed is unknown; or the "
     "expression that names it has no value there. The actions of the case are unknown there."},
});

std::vector<Code> joined() {
  std::vector<Code> codes(kErrorCodes.begin(), kErrorCodes.end());
  for (const std::span<const Code> more : {analysis_codes(), warning_codes()}) {
    codes.insert(codes.end(), more.begin(), more.end());
  }
  return codes;
}

}  // namespace

std::span<const Code> all_codes() {
  static const std::vector<Code> codes = joined();
  return codes;
}

const Code* find_code(std::string_view code) {
  const std::span<const Code> codes = all_codes();
  const auto at = std::ranges::lower_bound(codes, code, {}, &Code::code);
  return at != codes.end() && at->code == code ? &*at : nullptr;
}

}  // namespace kinestat
