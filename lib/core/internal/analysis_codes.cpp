#include "core/internal/analysis_codes.hpp"

#include <array>

namespace kinestat {

namespace {

using enum ExitStatus;

constexpr auto kStudyCodes = std::to_array<Code>({
    {"E0401",
     wrong_input,
     "bodies are not connected",
     "Every body must be connected to the ground through couplings, otherwise nothing is known "
     "about its motion. The message lists the parts. Add the coupling that connects them, or "
     "analyse them as two files."},
    {"E0402",
     wrong_input,
     "tree is not a spanning tree",
     "'tree:' chooses the spanning tree of the coupling graph: as many couplings as there are "
     "moving bodies, so that each body is reached from the ground by exactly one path. The "
     "couplings named leave a body out or close a circuit. Without 'tree:' the program chooses "
     "one; the results do not depend on it."},
    {"E0501",
     wrong_input,
     "primary motions are missing",
     "Exactly as many independent motions must be known as the net degree of freedom; here some "
     "are missing, so that velocities remain undetermined. The message lists these velocities, the "
     "hint motions that would suffice: give one more (0 for a member that is held), or add the "
     "coupling that is missing from the model."},
    {"E0502",
     wrong_input,
     "primary motions depend on each other",
     "Some of the given motions follow from others, so they are redundant or contradict them: a "
     "set with the right number of motions is not always independent. The message states the "
     "relation; remove one of the motions it names."},
    {"E0503",
     no_answer,
     "velocities are too large",
     "A velocity is above 1e150 in SI units: products with it would exceed the range of a double. "
     "The result is proportional to the known motions, so use smaller ones."},
    {"E0504",
     no_answer,
     "mechanism cannot be assembled",
     "The bodies as drawn do not meet in every coupling, and no position of them does. The message "
     "and the report give the position with the smallest gaps, with the distance and the angle "
     "that remain in each coupling. In a four-bar the longest link must be shorter than the other "
     "three together; the gaps show by how much lengths would have to change."},
    {"E0505",
     no_answer,
     "limit before a motion begins",
     "A drive of 'motion' reaches a limit before its range begins, or in the drawn position, or "
     "drives hold each other, so that there are no positions: links are stretched or folded in "
     "line, where the motion would have to reverse. The same where one position is asked for that "
     "lies beyond a limit. Let the range begin before the limit, which the message gives, drive "
     "another coupling, or change lengths. A limit on the way is W0518."},
    {"E0506",
     no_answer,
     "motion cannot be followed",
     "Several motions begin at one position, as where all links of a parallelogram are in line, "
     "and no earlier motion tells which one continues; or the steps became so small that the "
     "branch could not be distinguished from another. The program refuses to jump between "
     "branches. Start at another position, drive something that decides between the motions, or "
     "take more steps."},
    {"E0507",
     no_answer,
     "coupling cannot be moved",
     "Instantaneous motion needs the screws of a coupling in the drawn position, finite motion its "
     "shape: the profiles of a contact, the body that holds the axes of two gears, the order of "
     "several freedoms that are listed as screws. The file does not give this for the coupling. "
     "All other analyses are unaffected; 'kinestat help motion' lists what each type needs."},
    {"E0508",
     wrong_input,
     "drives do not determine the motion",
     "With the drives of 'motion' held, the mechanism could still move, and it is unknown how. The "
     "message lists the freedoms that remain undetermined; as many must be driven as the net "
     "degree of freedom. A motion that no other body follows, such as the spin of a rod between "
     "two balls, need not be driven."},
    {"E0509",
     wrong_input,
     "motion does not fit its time",
     "In a motion with 'time', or of a case with 'acceleration', drives run as given by the case, "
     "with its speeds and constant accelerations, or by a 'law' from one end of their ranges to "
     "the other. Here the motion of a drive is given by nothing, or twice, or does not lead to "
     "'to' in that time. The message names the drive; 'to' and 'time' of one motion follow from "
     "each other."},
    {"E0510",
     no_answer,
     "cable lifts off its pulley",
     "Where the straight segments of a cable before and after a pulley come into line, the arc of "
     "contact is zero; from there on the cable runs straight past, and the equations of the cable "
     "over the pulley would have a negative arc. The motion ends there, and the report has "
     "everything up to it. End the motion earlier, or draw the mechanism beyond that position "
     "without the pulley and move it from there."},
    {"E0511",
     no_answer,
     "accelerations are not known",
     "Inertia forces need the accelerations of all bodies, and these need the shape of each "
     "coupling: the profiles of a contact, the body that holds the axes of two gears, the order of "
     "freedoms that are listed as screws. Or the position is singular, so that the speeds of the "
     "drives do not determine the accelerations. The report has the velocities of the case, but "
     "not its actions."},
    {"E0514",
     no_answer,
     "result of 'dynamics' is not available",
     "A flywheel and harmonics need a cycle: one drive that turns at constant speed through whole "
     "turns, after which all bodies are where they started. A flywheel also needs one drive whose "
     "torque follows, on a shaft of constant speed. Counterweights need bodies that turn about an "
     "axis fixed to the ground; a limit speed needs contacts whose force depends on speed as "
     "inertia forces do. The message says which condition is not met; the rows of the motion are "
     "still reported."},
    {"E0515",
     no_answer,
     "simulation cannot go on",
     "The accelerations of a mechanism are not always determined: in a singular position nothing "
     "decides which way it moves, a curve ends, a spring has no force, or something moves that has "
     "neither mass nor inertia. Stops may also be struck repeatedly without time advancing, and "
     "very stiff parts may require too many steps; where several couplings stick at once, or the "
     "normal forces are indeterminate, the magnitude of each friction force is unknown. The "
     "message gives the time and the cause; the report goes as far as the simulation did. Stops, "
     "or 'until', can end it earlier."},
    {"E0516",
     wrong_input,
     "not supported by the simulation",
     "The mechanism has something that 'kinestat simulate' does not follow, and an answer without "
     "it would be wrong. 'kinestat help simulation' lists all that is refused; 'kinestat motion' "
     "finds the forces along a given motion with all of it ('kinestat help dynamics')."},
    {"E0517",
     wrong_input,
     "initial state of the simulation is invalid",
     "'start' gives positions and speeds of as many freedoms as are independent of each other, by "
     "actuators or COUPLING.FREEDOM; the others follow. The mechanism is moved there from the "
     "drawn position, as by 'kinestat motion', and must be able to reach it. What 'motion' of the "
     "simulation holds has its speed from the start, and a freedom may not start beyond its stop."},
    {"E0518",
     wrong_input,
     "what acts in a simulation is not known",
     "Each actuator has either an action in 'action' of 'simulation', even if 0, or a speed held "
     "by 'motion', not both; the actions that couplings carry follow and are not given. At least "
     "one body needs mass or inertia, otherwise nothing determines how fast the mechanism "
     "accelerates."},
    {"E0519",
     no_answer,
     "friction has no answer, or several",
     "Dry friction follows from the normal forces, and these from the accelerations of the bodies, "
     "which friction reduces or even increases. Where friction grows faster than its cause, rigid "
     "bodies have no consistent accelerations, or several: Painleve's paradox, as with chalk that "
     "hops when pushed across a board. What really happens depends on how the bodies deform, about "
     "which the file says nothing, and the simulation ends there. The message gives the time and "
     "the coupling. Less friction, a longer guide or a lower centre of mass may give a solution."},
    {"E0601",
     wrong_input,
     "primary actions depend on each other",
     "Some of the given actions follow from others or from the loads by equilibrium, so they are "
     "redundant: one of them is a result, not an input. The message states the relation; remove "
     "one of the actions it names."},
    {"E0602",
     no_answer,
     "equilibrium has no solution",
     "The given actions and the loads cannot be in equilibrium: they act along a motion that "
     "nothing resists. The message names the body and that motion. Usually an action is given "
     "(perhaps as 0) that should be solved for, or a coupling or actuator is missing."},
    {"E0603",
     no_answer,
     "actions are too large",
     "An action is above 1e150 in SI units: products with it would exceed the range of a double. "
     "The result is proportional to the known actions and loads, so use smaller ones."},
    {"E0604",
     wrong_input,
     "friction has no direction",
     "Friction acts against the motion of its coupling, so the case must say how the coupling "
     "moves: give 'motion:'. The numbers must also have a value there: 'tau' at each speed, the "
     "tables of a torque converter at its speed ratio. See 'kinestat help friction'."},
    {"E0605",
     no_answer,
     "friction does not determine the contact side",
     "Without friction the known actions contradict equilibrium, as a torque on a crank at its "
     "dead centre does. With friction they may be in equilibrium, held by the friction that the "
     "unknown actions cause; but a bearing has the same friction when loaded either way, so the "
     "sign of these actions does not follow. The message gives the equilibria that were found. "
     "Give an action of the other member instead, or another position."},
    {"E0606",
     no_answer,
     "friction at rest",
     "A coupling with friction is at rest in the case, like the ram of a press at its dead centre: "
     "friction may have any value up to its limit there, and statics alone cannot determine it. "
     "'kinestat motion' gives the actions in the positions around it. Draw another position, or "
     "omit the friction of a coupling that is always at rest. Nor has friction a direction where a "
     "gear leaves a speed open. See 'kinestat help friction'."},
    {"E0701",
     no_answer,
     "power balance is violated",
     "The powers of all couplings and loads must sum to zero (Tellegen). A larger residual means "
     "that the numbers cannot be trusted at this position, so they are reported with this error. "
     "Compare a nearby position, and look for lengths of very different magnitude."},
    {"E0711",
     wrong_input,
     "too many combinations of shift elements",
     "'shift' enumerates every combination of as many elements as a gear engages: the net degree "
     "of freedom minus the number of inputs. With many elements these are more than a table can "
     "show. Name fewer elements, only those that you choose between; what is always engaged or "
     "always open need not be an element."},
    {"E0712",
     wrong_input,
     "slip of a change has no answer",
     "'slip' of 'shift' calculates a gear change in which one element opens and another slips at "
     "constant torque, while all others stay engaged or open: two freedoms remain, and their "
     "inertia must not change while the train turns. The message says which of these conditions is "
     "not met. Give a change of several elements as several consecutive changes."},
    {"E0801",
     wrong_input,
     "position contradicts itself",
     "A position of a synthesis task requires something that no motion has: a centre of curvature "
     "that does not lie on the normal of the path, the line from 'at' to the pole; a centre in the "
     "point itself; a point in the pole, where a path has a cusp; or two points whose curvatures "
     "give the same information, because they are collinear with the pole. The message says "
     "which."},
    {"E0802",
     no_answer,
     "no linkage is usable",
     "Every linkage through the positions of the task has a defect or exceeds a limit, or too few "
     "dyads are real, or none is of the type required by 'linkage'. The report still lists them, "
     "the nearest first, with the reasons against each; the message counts the reasons. Move a "
     "position, give fewer and let 'vary' choose the rest, or widen the limits."},
    {"E0803",
     wrong_input,
     "task of a transmission contradicts itself",
     "No transmission can meet the task, whatever its sets are: more elements are engaged than "
     "exist, more gears are required than these elements can give, the sets and elements need more "
     "shafts than they have terminals, steps are not above 1 or cannot give the spread, a range is "
     "empty, or a direct gear lies outside the ladder. The message says which, and what to "
     "change."},
    {"E0804",
     no_answer,
     "no transmission meets the requirements",
     "The search went through all structures, layouts and roles of the sets and found none that "
     "meets all requirements of the task. The report says how many remained at each stage, and the "
     "message which requirement, if it alone were omitted, would give how many. Widen that one, "
     "allow other stationary ratios, or use one more set or element."},
    {"E0901",
     check_failed,
     "published value is missed",
     "The report differs from a value of the section 'published' by more than its tolerance: the "
     "file, or what it quotes, is wrong, or the program has changed. The message gives both "
     "numbers. This is only a check: the report is complete."},
    {"E0902",
     wrong_input,
     "published value points to nothing",
     "'value:' is a JSON Pointer into the report, for example /cases/M1/ratio, and there is no "
     "number at this one. The hint names the keys at the place where the path fails; 'kinestat "
     "analyze --format json' shows the whole report."},
    {"E0903",
     wrong_input,
     "file is not a report",
     "'kinestat compare' reads what this program wrote: a JSON report or a CSV table of it. This "
     "file is something else, or was damaged or changed by another program: NaN is neither JSON "
     "nor a table value, a number with a decimal comma is not a number, and a table needs all its "
     "columns, in any order. Write the report again; both files are left unchanged."},
    {"E0904",
     wrong_input,
     "report is of another version",
     "The report has a format version that this program does not know, so a value could have "
     "another meaning than it seems to. Write the report again with this program, or compare with "
     "the program that wrote it."},
    {"E0905",
     wrong_input,
     "reports are of different forms",
     "One of the two reports is JSON and the other a CSV table. A table has only part of the "
     "report, under other keys, so the two cannot be compared. Give two JSON reports, or two "
     "tables of the same pass."},
    {"E0906",
     wrong_input,
     "shard cannot be used",
     "'kinestat merge' joins files written by 'kinestat sweep --shard', and nothing else: this "
     "file was truncated or changed, or belongs to another sweep, that is, to another file, other "
     "options or another version of the program. Nothing was written. Run the shard again."},
    {"E0907",
     wrong_input,
     "shards are incomplete",
     "A sweep that was run as N shards is complete only with each of the N exactly once. The "
     "message says which are missing or present twice. Nothing was written, since a table that "
     "lacks some rows looks like a complete one."},
    {"E0908",
     environment,
     "an interrupted sweep, or another search, is in the way",
     "The output folder contains what an earlier run of this sweep had finished when it was "
     "interrupted. With --resume the sweep continues from it, provided that the file, --set, the "
     "options and the version are unchanged; with --force it is discarded. Neither happens unless "
     "requested, since it may be hours of work. The same applies to a folder of --work that "
     "contains what a search for transmissions has found for another task."},
    {"E0909",
     wrong_input,
     "file has nothing for this picture",
     "A picture shows the results of an analysis, and here these are missing: a shift matrix needs "
     "clutches and brakes, a bar chart of forces needs a case whose actions are solved, a lever "
     "diagram needs a planetary set. The message says what is missing; 'kinestat plot list FILE' "
     "lists which pictures the file has."},
});

}  // namespace

std::span<const Code> analysis_codes() {
  return kStudyCodes;
}

}  // namespace kinestat
