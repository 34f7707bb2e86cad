#include "core/internal/analysis_codes.hpp"

#include <array>

namespace kinestat {

namespace {

using enum ExitStatus;

constexpr auto kStudyCodes = std::to_array<Code>({
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
    {"E0509",
     wrong_input,
     "motion does not fit its time",
     "In a motion with 'time', or of a case with 'acceleration', drives run as the case says, with "
     "its speeds and steady accelerations, or by a 'law' from one end of their ranges to the "
     "other. "
     "Here nothing says how a drive runs, or two things do, or it is not where 'to' says after "
     "that "
     "time. The message names the drive; 'to' and 'time' of one motion follow from each other."},
    {"E0510",
     no_answer,
     "cable lifts off its pulley",
     "Where the straight parts of a cable before and behind a pulley come into one line, it lies "
     "on the pulley by an arc of zero; from there on it runs straight past, and the equations of "
     "the cable over the pulley would count a negative arc. The motion ends there, and the report "
     "has everything before. End the motion earlier, or draw the mechanism behind that position "
     "without the pulley and move it from there."},
    {"E0511",
     no_answer,
     "accelerations are not known",
     "Forces of inertia need the accelerations of all bodies, and these the shape of each "
     "coupling: "
     "the profiles of a contact, the body that holds the axes of two gears, the order of freedoms "
     "that are listed as screws. Or the position is singular, so that speeds of the drives "
     "determine no accelerations. The velocities of the case are given, its actions are not."},
    {"E0514",
     no_answer,
     "a motion does not tell what 'dynamics' asks",
     "A flywheel and harmonics are of a cycle: one drive that turns steadily, whole turns, at the "
     "end of which all bodies stand as at the begin. A flywheel also needs one drive whose torque "
     "follows, on a shaft of steady speed. Counterweights need bodies that turn about an axis of "
     "the ground; a limit speed needs contacts whose force hangs on speed as the forces of inertia "
     "do. The message says what is not so; the rows of the motion are given all the same."},
    {"E0515",
     no_answer,
     "simulation cannot go on",
     "The accelerations of a mechanism are not known everywhere: in a singular position nothing "
     "says which way it goes, a curve ends, a spring has no force, or something moves that has "
     "neither mass nor inertia. Stops may also be struck again and again without time going on, "
     "and "
     "what is very stiff may ask for too many steps; where several couplings stick at once, or "
     "what presses is indeterminate, nothing says how large each friction is. The message has the "
     "time and the cause; the "
     "report goes as far as the simulation did. Stops, or 'until', end it before."},
    {"E0516",
     wrong_input,
     "simulation does not know this",
     "'kinestat simulate' knows bodies with inertia, loads, weights, springs, dampers, friction of "
     "couplings with one freedom, actions that follow curves, and stops. Losses of teeth, cables "
     "and contacts, which can part, torque converters, and bodies that turn freely about a point "
     "are refused, because an answer without them would be wrong. Forces along a given motion have "
     "all of these: 'kinestat help dynamics'."},
    {"E0517",
     wrong_input,
     "start of a simulation does not fit",
     "'start' gives places and speeds of as many freedoms as are independent of each other, by "
     "actuators or COUPLING.FREEDOM; the others follow. The mechanism is led there from the drawn "
     "position, as 'kinestat motion' does it, and must come there. What 'motion' of the simulation "
     "holds keeps its speed from the begin on, and a freedom does not begin beyond its stop."},
    {"E0518",
     wrong_input,
     "what acts in a simulation is not known",
     "Each actuator has an action in 'action' of 'simulation', be it 0, or a speed in 'motion' "
     "that "
     "something holds, and not both; what couplings bear follows and is not given. Some body has "
     "mass or inertia, or nothing says how fast the mechanism speeds up."},
    {"E0519",
     no_answer,
     "friction has no answer, or several",
     "Dry friction follows from what presses, and what presses from how the bodies speed up, which "
     "friction slows down or even speeds up. Where friction grows faster than what it causes, "
     "rigid "
     "bodies have no accelerations that fit, or several: Painleve's paradox, as of chalk that is "
     "pushed over a board and hops. What really happens is decided by how the bodies bend, of "
     "which "
     "the file says nothing, and the simulation ends there. The message has the time and the "
     "coupling. Less friction, a longer guide or a lower centre of mass make an answer."},
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
     "give 'motion:'. Its numbers must have a value there, too: 'tau' at each speed, the tables of "
     "a "
     "torque converter at its speed ratio. See 'kinestat help friction'."},
    {"E0605",
     no_answer,
     "friction leaves open how it is pressed",
     "Without friction the known actions contradict equilibrium, as a torque on a crank at its "
     "dead centre does. With friction they may be in equilibrium, because what the unknown actions "
     "press holds them; but a bearing has as much friction pressed one way as the other, so that "
     "the sign of these actions does not follow. The message has the equilibria that were found. "
     "Give an action of the other member instead, or another position."},
    {"E0606",
     no_answer,
     "friction at rest",
     "A coupling with friction stands still in the case, as the ram of a press does at its dead "
     "centre: friction may have any size up to its limit there, and statics alone cannot tell. "
     "Actions in the positions around it are those of 'kinestat motion'. Draw another position, or "
     "leave the friction out of a coupling that always rests. See 'kinestat help friction'."},
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
    {"E0712",
     wrong_input,
     "slip of a change has no answer",
     "'slip' of 'shift' follows a change in which one element opens and another one slips at a "
     "steady torque, while all others stay engaged or open: so two freedoms are left, and their "
     "inertia must not change while the train turns. The message says which of this does not hold. "
     "Give a change of several elements as several changes, one after the other."},
    {"E0801",
     wrong_input,
     "position contradicts itself",
     "A position of a synthesis task asks for what no motion has: a centre of curvature that does "
     "not lie on the normal of the path, the line from 'at' to the pole; a centre in the point "
     "itself; a point in the pole, where a path has a cusp; or two points whose curvatures say the "
     "same, because they lie on one line with the pole. The message says which."},
    {"E0802",
     no_answer,
     "no linkage is usable",
     "The task asks for linkages through its positions, and each that there is has a defect or "
     "breaks a limit, or too few dyads are real, or none is of the kind that 'linkage' asks for. "
     "The report has them all the same, the nearest first, with what speaks against each; the "
     "message counts the reasons. Move a position, give fewer and let 'vary' choose the rest, or "
     "widen the limits."},
    {"E0803",
     wrong_input,
     "task of a transmission contradicts itself",
     "No transmission can be what the task asks for, whatever its sets are: more elements are "
     "engaged than there are, more gears are wanted than so many elements make, the shafts that "
     "the sets and elements need are more than their terminals, steps are not above 1 or cannot "
     "give the spread, a range is empty, or a direct gear lies outside of the ladder. The message "
     "says which, and what to change."},
    {"E0804",
     no_answer,
     "no transmission does what is asked",
     "The search went through all structures, layouts and roles of the sets and found none that "
     "does all that the task asks for. The report says how many were left at each stage, and the "
     "message which requirement, left out alone, would give how many. Widen that one, allow other "
     "stationary ratios, or take a set or an element more."},
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
     "an interrupted sweep, or another search, is in the way",
     "The output folder holds what an earlier run of this sweep had finished when it was "
     "interrupted. With --resume the sweep goes on with it, provided that the file, --set, the "
     "options and the version are still the same; with --force it is thrown away. Neither happens "
     "unasked, for it may be the work of hours. So is a folder of --work that holds what a search "
     "for transmissions has found for another task."},
    {"E0909",
     wrong_input,
     "file has nothing for this picture",
     "A picture shows what an analysis found, and here that is missing: a shift matrix needs "
     "clutches and brakes, bars of forces a case whose actions are solved, a lever diagram a "
     "planetary set. The message says what is missing; 'kinestat plot list FILE' says of every "
     "picture whether the file has it."},
});

}  // namespace

std::span<const Code> analysis_codes() {
  return kStudyCodes;
}

}  // namespace kinestat
