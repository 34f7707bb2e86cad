#include "core/codes.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/internal/warning_codes.hpp"

namespace kinestat {

namespace {

using enum ExitStatus;

// Sorted by code, like the warnings: find_code searches by halves.
constexpr auto kErrorCodes = std::to_array<Code>({
    {"E0101",
     usage,
     "wrong use of the command line",
     "A command, an option or a value is not one that this program knows, or one is missing. "
     "Nothing was written. The message names the word and, where there is one, the nearest that "
     "exists; 'kinestat --help' lists the commands, 'kinestat COMMAND --help' the options of one."},
    {"E0102",
     usage,
     "value of --set cannot be used",
     "--set gives a parameter of the mechanism file another value for this run. It takes "
     "NAME=VALUE, where NAME is one of the section 'parameters' and VALUE a number or an "
     "expression that measures the same as the value of the file; in the shell, quotes keep a "
     "value with spaces together, as in --set 'h_z=10 mm'."},
    {"E0103",
     usage,
     "wrong use of the library",
     "A function of libkinestat, or of what is built on it, was given a name that the mechanism or "
     "its report does not have, a number that is infinite or none, or nothing at all where "
     "something is needed. Nothing was changed. The message names it and, where there is one, the "
     "nearest that exists."},
    {"E0151",
     environment,
     "input cannot be read",
     "The file does not exist, is no ordinary file, or may not be read; the message has the "
     "system's reason. A folder, a device or a pipe is refused, because reading it might never "
     "end; give '-' to read standard input."},
    {"E0152",
     environment,
     "output cannot be written",
     "The folder or the file cannot be written: it does not exist, may not be written to, or the "
     "disk is full; the message has the system's reason. Files are written whole or not at all, "
     "so what was there before is unchanged. The folder of --out is not made by this program, so "
     "that a misspelt name leaves no traces."},
    {"E0153",
     environment,
     "output would replace a foreign file",
     "A file of that name exists, and it is not a report that this program wrote before. It is "
     "left as it is, for it may hold work that is nowhere else. Choose another folder or name, or "
     "give --force if it may be replaced."},
    {"E0154",
     environment,
     "out of memory",
     "The machine, or the limit set for this process, has too little memory for the input. No "
     "file was left half written. Raise the limit ('ulimit -v'), or leave out of the file what "
     "does not belong to the mechanism."},
    {"E0155",
     bug,
     "internal error",
     "The program met something that it takes for impossible: this is a mistake in the program, "
     "not in the file. The other files of the run are analysed nevertheless. Please report it "
     "with the file and the line that was printed."},
    {"E0201",
     wrong_input,
     "file is too large",
     "A mechanism file is a few kilobytes. Larger ones are refused before they are read, so that "
     "a wrong file name cannot exhaust the machine; the message names the limit. Most often "
     "another file was meant."},
    {"E0202",
     wrong_input,
     "file is not UTF-8 text",
     "Mechanism files are UTF-8 text. The message names the first bytes that are not, and what "
     "they look like: another encoding, or no text at all. Most editors can save the file again "
     "'as UTF-8', iconv converts it."},
    {"E0203",
     wrong_input,
     "control character in the file",
     "Only line ends and spaces may shape the text. A tab may stand inside a line, not at its "
     "beginning, where YAML counts columns and editors disagree on its width; other control "
     "characters are invisible and mean nothing. Replace tabs by spaces."},
    {"E0204",
     wrong_input,
     "YAML cannot be read",
     "The text is not well-formed YAML: a bracket or a quote is not closed, or an indentation "
     "does not fit the lines around it. The place is that of the opening bracket or of the line "
     "that does not fit."},
    {"E0205",
     wrong_input,
     "document is empty",
     "The file holds no mapping: it is empty, or all of it is comments. Perhaps it was not saved, "
     "or another one was meant. 'kinestat new' writes one to begin with."},
    {"E0206",
     wrong_input,
     "several documents in one file",
     "One file describes one mechanism. YAML would allow more documents in it, separated by "
     "'---'; which of them is meant could only be guessed. Remove '---' and what follows it, or "
     "make two files, which may be analysed together."},
    {"E0207",
     wrong_input,
     "key is given twice",
     "A mapping may name each key once. Most readers of YAML silently keep one of the two values, "
     "which is never what was meant. The note shows the first place; remove or rename one of the "
     "two."},
    {"E0208",
     wrong_input,
     "YAML feature is not supported",
     "Tags, merge keys, directives and keys that are not plain text belong to YAML, but not to "
     "this format: the file must mean the same to every reader. Write the value itself."},
    {"E0209",
     wrong_input,
     "alias cannot be used",
     "An alias (*name) repeats what an anchor (&name) before it marks. Here the anchor is "
     "missing, stands further below, or contains the alias itself. Define the anchor first, or "
     "use a parameter, which may stand anywhere."},
    {"E0210",
     wrong_input,
     "file is too deep or too large inside",
     "Nesting, the number of values or the length of one value is above a limit that no mechanism "
     "needs; aliases count with all that they repeat. The limits keep a broken or hostile file "
     "from exhausting the machine. The message names the one that was met."},
    {"E0301",
     wrong_input,
     "format version is missing or not supported",
     "Every mechanism file has 'kinestat: 1', the version of the format it is written in, so that "
     "a later format cannot be mistaken for this one. Add the line, or use a newer program for a "
     "file of a newer format."},
    {"E0302",
     wrong_input,
     "unknown key",
     "The key is not one that is known at this place, so its value would be ignored without a "
     "word. Most often it is misspelt or stands one level too deep or too high; the hint names "
     "the keys that may stand. Own notes may stand at the top level under keys that begin with "
     "'x-'."},
    {"E0303",
     wrong_input,
     "required key is missing",
     "The mapping lacks a key without which it has no meaning; nothing sensible could be assumed "
     "in its place. The hint says what to add."},
    {"E0304",
     wrong_input,
     "value has the wrong shape",
     "A list, a mapping or a single value is expected where another one stands, or a list has the "
     "wrong length: points are [x, y] in the plane and [x, y, z] in space. The hint shows the "
     "form. A decimal comma turns one number into two, and true and false are no texts without "
     "quotes."},
    {"E0305",
     wrong_input,
     "value is not one of those allowed",
     "The place takes one of a few words, or numbers within limits, and this is another: a type "
     "of coupling that does not exist, a negative stiffness, or a coefficient of friction where "
     "nothing presses. The hint says what may stand; 'kinestat help couplings' says what the "
     "types of couplings mean."},
    {"E0306",
     wrong_input,
     "name cannot be used",
     "Names are letters, digits, '_' and '-', beginning with a letter or '_'; parameters without "
     "'-', which would be a subtraction, and never a unit, a function, pi or a word of conditions "
     "(and, or, not): with a parameter 'm', '2 m' would no longer be two metres. Labels of cases "
     "are free text."},
    {"E0307",
     wrong_input,
     "name is declared twice",
     "Two things of one kind have the same name, so that a reference to it could mean either, or "
     "one name is given twice where it may stand once. Bodies have one name space; couplings and "
     "actuators share another. The note shows the first place; rename or remove one of the two."},
    {"E0308",
     wrong_input,
     "number or expression cannot be read",
     "A value is a number or an expression such as (N1 + N5)/2*module or 20 deg. The caret marks "
     "where reading failed: a parenthesis, an operator or a unit that does not exist, or a way of "
     "writing numbers on whose meaning readers disagree (017, 0x1F, 1,5). 'kinestat help "
     "expressions' and 'kinestat help units' show what may stand."},
    {"E0309",
     wrong_input,
     "dimensions do not fit",
     "The value has another dimension than its place, or quantities of different dimensions are "
     "added, or a function takes another one. A bare number takes the unit that 'units:' names "
     "for the place, but inside an expression it stays bare: write its unit there."},
    {"E0310",
     wrong_input,
     "parameters depend on each other as they may not",
     "A parameter may use others in any order, but not itself through them: none of them would "
     "ever have a value. The message lists the circle; give one of them a number. Nor may one that "
     "is left open, {free: …}, use another open one: with that one it would no longer be open."},
    {"E0311",
     wrong_input,
     "unknown name in an expression",
     "The name in an expression is neither a parameter nor a unit nor a function. The hint has "
     "the nearest one; otherwise declare it in the section 'parameters'. Capitals count."},
    {"E0312",
     wrong_input,
     "body is not declared",
     "Couplings, loads, gear members and cables name the ground or bodies of the section 'bodies'. "
     "A name that is not declared there is taken for a misspelling and not for a new body, since a "
     "mechanism with one body more has other answers."},
    {"E0313",
     wrong_input,
     "reference to something that is not declared",
     "The name refers to something that this file does not declare: a coupling, an actuator, a "
     "freedom (coupling.wz) or an action (coupling.Rx). The hint lists what there is. Bodies are "
     "not actuators: a motion belongs to a coupling."},
    {"E0314",
     wrong_input,
     "geometry is missing, surplus or degenerate",
     "Each type of coupling needs its own geometry and no other, and a direction must not be "
     "zero: otherwise its freedoms and constraints are not defined. The message names what is "
     "missing, surplus or degenerate; 'kinestat help couplings' lists what each type takes."},
    {"E0315",
     no_answer,
     "mechanism is not analysed yet",
     "The file is right, but something in it that decides the answer belongs to the format and not "
     "yet to the analysis of this version: a freewheel that 'shift' does not name, a point that "
     "differs from body to body (only 'kinestat motion' closes it), friction of some types, or a "
     "coupling without its place. Without it an answer would be wrong, so there is none, and the "
     "exit status is 5. The hint says what to write instead; 'kinestat help format' lists what is "
     "not analysed."},
    {"E0316",
     wrong_input,
     "value has no result",
     "The expression is well written, but has no value: a division by zero, a root of a negative "
     "number, or a result that is too large or too small for a number. The message names the "
     "operation; with parameters, their values may be the cause."},
    {"E0317",
     wrong_input,
     "cable cannot run as it is drawn",
     "A cable, belt or chain runs straight from one station to the next and touches pulleys from "
     "outside. Here no such line exists, because a point lies within a pulley, pulleys overlap or "
     "do not lie in one plane, or the line passes through another pulley of the cable. The message "
     "has the distances; 'kinestat help cables' shows how cables run."},
    {"E0318",
     wrong_input,
     "clutch joins bodies on two axes",
     "A clutch joins bodies that turn about one axis. Here one stands at another distance than the "
     "other, by its 'centre_distance' or by its teeth: engaged, the clutch would hold both still, "
     "and every gear that uses it would be locked. The message has both distances; give the gears "
     "of both the same 'centre_distance', or one to their axis in 'axes' of 'gears', or correct "
     "the "
     "teeth."},
    {"E0319",
     wrong_input,
     "idler is no planet",
     "A gear that turns on a shaft, meshes once and is clutched to that shaft is an idler, as on "
     "the lay shaft of a manual gearbox. With the shaft as the carrier of its mesh it would be a "
     "planet that the shaft carries round, and every ratio would be that of another machine. Its "
     "mesh has no carrier: the centres of both gears stand still on the ground."},
    {"E0320",
     wrong_input,
     "number beyond what can be computed with",
     "Distances, forces and speeds are multiplied with each other and squared. A number above 1e60 "
     "in SI units would soon leave the range of numbers, and no answer would be left. A point that "
     "is meant to be infinitely far is a direction: a prismatic instead of a revolute."},
    {"E0321",
     wrong_input,
     "range without extent",
     "Where circle points may lie is an area, given by two opposite corners under 'vary'. Both "
     "corners are the same point, so that there is nothing to choose from."},
    {"E0401",
     wrong_input,
     "mechanism falls apart",
     "Every body must be joined to the ground through couplings, or nothing is known of its "
     "motion. The message lists the parts. Add the coupling that joins them, or analyse them as "
     "two files."},
    {"E0402",
     wrong_input,
     "tree is not a spanning tree",
     "'tree:' chooses the spanning tree of the coupling graph: as many couplings as there are "
     "moving bodies, so that from the ground each body is reached on exactly one way. Those named "
     "leave a body out or close a circuit. Without 'tree:' the program chooses one; the results "
     "do not depend on it."},
    {"E0501",
     wrong_input,
     "primary motions are missing",
     "Exactly as many independent motions must be known as the net degree of freedom; here some "
     "are missing, so that velocities remain open. The message lists these, the hint motions that "
     "would do: give one more (0 for a member that is held), or add the coupling that is missing "
     "in the model."},
    {"E0502",
     wrong_input,
     "primary motions depend on each other",
     "Some of the motions given follow from others, so that they are surplus or contradict them: "
     "not every set of as many motions as degrees of freedom is independent. The message states "
     "the relation; remove one of those it names."},
    {"E0503",
     no_answer,
     "velocities are too large",
     "A velocity is above 1e150 in SI units: products with it would leave the range of a double. "
     "The answer is proportional to the known motions, so smaller ones show it."},
    {"E0504",
     no_answer,
     "mechanism cannot be assembled",
     "The bodies as they are drawn do not meet in every coupling, and no position of them does. "
     "The message and the report have the position in which they miss least, with the distance and "
     "the angle that each coupling still misses by. In a four-bar the longest link must be shorter "
     "than the other three together; the gaps say by how much lengths would have to change."},
    {"E0505",
     no_answer,
     "motion comes to a limit",
     "A drive of 'motion' cannot reach the end of its range: links are stretched or folded in "
     "line, where the motion would have to turn back. The report goes up to the limit, which the "
     "message has and the report brackets. End the motion before, drive another coupling, or "
     "change lengths; in a four-bar a crank turns fully if it is the shortest link, and shortest "
     "and longest together are less than the other two."},
    {"E0506",
     no_answer,
     "motion cannot be followed",
     "At a position several motions begin, as where all links of a parallelogram are in line, and "
     "none before it says which goes on; or the steps became so small that the branch could not "
     "be told from another. The program refuses to jump. Begin at another position, drive what "
     "decides between the motions, or take more steps."},
    {"E0507",
     no_answer,
     "coupling cannot be moved",
     "Instantaneous motion needs the screws of a coupling in the drawn position, finite motion its "
     "shape: the profiles of a contact, the body that holds the axes of two gears, the order of "
     "several freedoms that are listed as screws. The file does not say it for this coupling. All "
     "other passes are unaffected; 'kinestat help motion' lists what each type needs."},
    {"E0508",
     wrong_input,
     "drives leave a motion open",
     "With the drives of 'motion' held, the mechanism could still move, and it is not known how. "
     "The message lists the freedoms that stay open; as many must be driven as the net degree of "
     "freedom says. What nobody else feels, such as the spin of a rod between two balls, need "
     "not be driven."},
    {"E0510",
     no_answer,
     "cable lifts off its pulley",
     "Where the straight parts of a cable before and behind a pulley come into one line, it lies "
     "on the pulley by an arc of zero; from there on it runs straight past, and the equations of "
     "the cable over the pulley would count a negative arc. The motion ends there, and the report "
     "has everything before. End the motion earlier, or draw the mechanism behind that position "
     "without the pulley and move it from there."},
    {"E0601",
     wrong_input,
     "primary actions depend on each other",
     "Some of the actions given follow from others or from the loads by equilibrium, so that they "
     "are surplus: one of them is the answer, not a datum. The message states the relation; remove "
     "one of those it names."},
    {"E0602",
     no_answer,
     "equilibrium has no solution",
     "The actions given and the loads cannot be in equilibrium: they act along a motion that "
     "nothing resists. The message names the body and that motion. Most often an action is given "
     "(0 among them) that should be solved, or a coupling or actuator is missing."},
    {"E0603",
     no_answer,
     "actions are too large",
     "An action is above 1e150 in SI units: products with it would leave the range of a double. "
     "The answer is proportional to the "
     "known actions and loads, so smaller ones show it."},
    {"E0604",
     wrong_input,
     "friction has no direction",
     "Friction acts against the motion of its coupling, so the case must say how that moves: "
     "give 'motion:'. Where the coupling rests, friction may have any size up to its limit, and "
     "statics alone cannot tell: leave it out of such a coupling. See 'kinestat help friction'."},
    {"E0605",
     no_answer,
     "friction leaves open how it is pressed",
     "Without friction the known actions contradict equilibrium, as a torque on a crank at its "
     "dead centre does. With friction they may be in equilibrium, because what the unknown actions "
     "press holds them; but a bearing has as much friction pressed one way as the other, so that "
     "the sign of these actions does not follow. The message has the equilibria that were found. "
     "Give an action of the other member instead, or another position."},
    {"E0701",
     no_answer,
     "power balance is violated",
     "The powers of all couplings and loads must sum to zero (Tellegen). A larger residual means "
     "that the numbers cannot be trusted at this position, so they are reported with this error. "
     "Compare a position nearby, and look for lengths of very different size."},
    {"E0711",
     wrong_input,
     "too many combinations of shift elements",
     "'shift' enumerates every combination of as many elements as a gear engages: the net degree "
     "of freedom less the inputs. With many elements that are more than a table can show. Name "
     "fewer elements, those between which you choose; what is always engaged or always open needs "
     "no element."},
    {"E0801",
     wrong_input,
     "position contradicts itself",
     "A position of a synthesis task asks for what no motion has: a centre of curvature that does "
     "not lie on the normal of the path, the line from 'at' to the pole; a centre in the point "
     "itself; a point in the pole, where a path has a cusp; or two points whose curvatures say the "
     "same, because they lie on one line with the pole. The message says which."},
    {"E0901",
     check_failed,
     "published value is missed",
     "The report differs from a value of the section 'published' by more than its tolerance: the "
     "file, or what it quotes, is wrong, or the program has changed. The message has both "
     "numbers. It is a check and no obstacle: the report is complete."},
    {"E0902",
     wrong_input,
     "published value points to nothing",
     "'value:' is a JSON Pointer into the report, for example /cases/M1/ratio, and there is no "
     "number at this one. The hint names the keys at the place where the path ends; 'kinestat "
     "analyze --format json' shows the whole report."},
    {"E0903",
     wrong_input,
     "file is no report",
     "'kinestat compare' reads what this program wrote: a JSON report or a CSV table of it. This "
     "file is something else, or was damaged or changed by another program: NaN is neither JSON "
     "nor a value of a table, a decimal comma is no number, and a table needs all its columns, in "
     "any order. Write the report again; both files are left as they are."},
    {"E0904",
     wrong_input,
     "report is of another version",
     "The report names another version of its format than this program knows, so that a value "
     "could mean something else than it seems to. Write the report again with this program, or "
     "compare with the program that wrote it."},
    {"E0905",
     wrong_input,
     "reports are of different forms",
     "One of the two reports is JSON and the other a CSV table. A table has only a part of the "
     "report, under other keys, so the two are not compared. Give two JSON reports, or two tables "
     "of the same pass."},
    {"E0906",
     wrong_input,
     "shard cannot be used",
     "'kinestat merge' joins what 'kinestat sweep --shard' has written, and takes nothing else: "
     "this file was cut off, changed, or belongs to another sweep, that is to another file, other "
     "options or another version of the program. Nothing was written. Run the shard again."},
    {"E0907",
     wrong_input,
     "shards do not make a whole",
     "A sweep that was run as N shards is whole only with each of the N, once. The message says "
     "which are missing or there twice. Nothing was written, since a table that lacks some of its "
     "rows looks like one that has them all."},
    {"E0908",
     environment,
     "an interrupted sweep is in the way",
     "The output folder holds what an earlier run of this sweep had finished when it was "
     "interrupted. With --resume the sweep goes on with it, provided that the file, --set, the "
     "options and the version are still the same; with --force it is thrown away. Neither happens "
     "unasked, for it may be the work of hours."},
    {"E0909",
     wrong_input,
     "file has nothing for this picture",
     "A picture shows what an analysis found, and here that is missing: a shift matrix needs "
     "clutches and brakes, bars of forces a case whose actions are solved, a lever diagram a "
     "planetary set. The message says what is missing; 'kinestat plot list FILE' says of every "
     "picture whether the file has it."},
});

std::vector<Code> joined() {
  std::vector<Code> codes(kErrorCodes.begin(), kErrorCodes.end());
  const std::span<const Code> warnings = warning_codes();
  codes.insert(codes.end(), warnings.begin(), warnings.end());
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
