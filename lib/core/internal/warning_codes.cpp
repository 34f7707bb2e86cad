#include "core/internal/warning_codes.hpp"

#include <array>

namespace kinestat {

namespace {

using enum ExitStatus;

constexpr auto kWarningCodes = std::to_array<Code>({
    {"W0101",
     done,
     "value of an option is reduced",
     "The option asks for more than this program uses, such as more threads than any machine has "
     "cores. The message says what is used instead; the result does not depend on it."},
    {"W0301",
     done,
     "declared but never used",
     "This is allowed, but nothing depends on it: a parameter in no expression, a stiffness that "
     "'statics:' does not use, gravity without masses, a load on the ground. Often a name is "
     "misspelt where it is used, or something was forgotten there."},
    {"W0302",
     done,
     "section is not analysed yet",
     "The section or key is read and checked, but this version has no analysis for it, or has one "
     "in a separate command, which the hint names. The rest of the file is analysed as if it were "
     "absent; no other result depends on it. 'kinestat check' gives the same warning for anything "
     "that leaves 'kinestat analyze' without a result (E0315)."},
    {"W0303",
     done,
     "angle is more than a full turn",
     "A bare number is used for an angle and is in radians, the unit unless 'units:' sets another, "
     "but it is more than a full turn: degrees were probably meant. Write the unit, 30 deg, or "
     "'units: {angle: deg}' for the whole file."},
    {"W0304",
     done,
     "gravity has an unlikely magnitude",
     "A bare number in 'gravity' is in the units of the file, length over time squared: with "
     "'units: {length: mm}', 9.81 is 9.81 mm/s^2, a thousandth of the earth's. Write the unit, "
     "9.81 m/s^2; with a unit, any value is accepted without a warning."},
    {"W0305",
     done,
     "teeth require different centre distances",
     "Two gears without profile shift mesh at a centre distance of the module times half the sum "
     "of their teeth, or half the difference with a ring. The meshes of a planet require different "
     "distances, or another one than 'centre_distance' and the triangle of two planets give, or a "
     "bearing is not on the axis of its gears; for a simple set, ring = sun + 2*planet is not met. "
     "Ratios are still exact, because each pitch point divides the distance in the ratio of the "
     "teeth. With profile shift, write 'centre_distance' for the planet; a difference of less than "
     "a module is then accepted without a warning."},
    {"W0306",
     done,
     "planets cannot be assembled at equal angles",
     "From one of several equal planets to the next, the teeth of the gears on the main axis must "
     "repeat: for a sun and a ring, (sun + ring)/count must be a whole number, and for stepped or "
     "paired planets the number that the message gives. Planets at unequal angles, or rotated "
     "relative to each other on their shafts, may be intended; motions and actions do not change."},
    {"W0307",
     done,
     "neighbouring planets touch",
     "With this number of planets the tip circles of two neighbours, one module outside their "
     "pitch circles, would overlap. The message gives the distance between their centres and the "
     "required distance. Motions and actions do not change."},
    {"W0308",
     done,
     "cable does not run around its pulley as it should",
     "It runs around the far side, wraps more than half a turn and crosses itself; or its 'points' "
     "give it two different lever arms about the axis. The first is correct for a capstan, on "
     "which a cable lies beside itself, and 'turns: 0' says so; but more often 'wrap', the "
     "direction of rotation for someone who follows the cable in listed order, is reversed, and "
     "torques and speeds then have the wrong sign. The second is a cable on an arm rather than on "
     "a round pulley: the tensions of its two sides differ in the ratio of the lever arms."},
    {"W0309",
     done,
     "link has no length",
     "In a file with a motion, a body is joined to two others by revolute couplings on one axis "
     "and to nothing else, so that it is a sleeve that can turn by itself, and the other two "
     "bodies turn about that axis together. Usually two points are the same by mistake. Give the "
     "couplings different points, or join the other two bodies directly."},
    {"W0310",
     done,
     "body is counted as a point mass",
     "A body with a mass and without 'inertia' turns in a case with 'acceleration'. It is treated "
     "as if all its mass were at the centre of mass, so that rotating it about that point takes no "
     "moment. Give 'inertia' about the centre of mass, or 0 if it is negligible."},
    {"W0311",
     done,
     "inertia is unlikely for the mechanism",
     "The radius of gyration, the root of inertia over mass, is the distance at which all the mass "
     "would have that inertia. Here it is larger than the whole mechanism, or a thousand times "
     "smaller. Usually the unit of the inertia is not the one intended: bare numbers are in the "
     "unit of inertia, kg*m^2 unless 'units' says otherwise, whatever the unit of length is."},
    {"W0312",
     done,
     "accelerations have no effect",
     "A case has the key 'acceleration', so that inertia forces act, but no body has a mass or an "
     "inertia. Give bodies 'mass', 'centre_of_mass' and 'inertia', or remove the key."},
    {"W0313",
     done,
     "damping is in the unit of speed",
     "Damping is a couple over an angular velocity, or a force over a velocity, and a bare number "
     "is in these units of the file: with 'units: {angular_velocity: rpm}' in N*m/rpm, which is "
     "9.55 N*m*s/rad, with 'units: {length: mm}' in N*s/mm, a thousand N*s/m. Write the unit; "
     "with it, any value is accepted without a warning."},
    {"W0314",
     done,
     "large loss of a mesh",
     "The loss of a mesh is the fraction of the rolling power that is lost, a few hundredths for "
     "real teeth, and this is above 0.3. If it is an efficiency, write it as one: {eta: 0.98}."},
    {"W0315",
     done,
     "friction counts forces of planets that cancel",
     "Equal planets press a central bearing from all sides, so that their radial forces cancel, "
     "and "
     "its friction counts only what else presses it. The mechanism has one planet in the place of "
     "all, and its radial force is taken out of what the bearing bears; but here a second bearing "
     "of the same shaft shares it, or the planets have inertia beside other loads, and that part "
     "is "
     "not known, so that friction is too large. Draw one bearing, or give 'tau' in place of 'mu'."},
    {"W0501",
     done,
     "rounding decides on a rank",
     "The numbers as typed and the same numbers rounded to double give different ranks: one says "
     "that the mechanism is redundant, or in a singular position, and the other that it is not. "
     "Both results are in the report; counts and solutions are those of the rounded numbers, "
     "unless '--accuracy exact' solves a case as typed. Coordinates that were calculated and then "
     "typed with few decimals make a redundant mechanism appear regular: write expressions "
     "instead, such as 100*sqrt(2) mm."},
    {"W0502",
     done,
     "fewer digits than requested",
     "The error bound of a value exceeds what '--digits' requires, even after refinement. It is a "
     "bound: the value may be more accurate. '--accuracy exact' solves the numbers as typed."},
    {"W0503",
     done,
     "motion passes a singular position",
     "The motion passes a position at which it crosses another motion, as where the links of a "
     "parallelogram are in line: there the drive does not determine the motion. The report "
     "continues on the same branch, as inertia would carry the links, and lists the position. A "
     "machine needs a flywheel, or a second linkage that guides it through."},
    {"W0504",
     done,
     "drawn position does not close",
     "Points of two bodies that do not meet in the reference position, or lengths that do not fit, "
     "were closed before the motion began: the drives stay where they are drawn, and everything "
     "else moves as little as necessary. The report gives the gaps as drawn and how far each body "
     "moved; motions are still measured from the drawn position."},
    {"W0505",
     done,
     "no transmission angle",
     "The transmission angle is that of the force which drives the body of the output through its "
     "one other coupling. There is none where several couplings drive it, where a couple does, or "
     "where equilibrium leaves the force undetermined: in a planar mechanism drawn in space, "
     "equilibrium allows the bearings to load each other along their axes, and that load is part "
     "of the force."},
    {"W0506",
     done,
     "idle freedoms",
     "A body can turn or slide without moving any other body, such as a rod between two balls "
     "about its own axis. If a case does not give such a rate, its report omits it and has all "
     "others. In each step of a motion its couplings move as little as necessary, so the angle it "
     "has turned depends on the number of steps and on which of the couplings comes first, and is "
     "not the integral of its velocity. All other positions are determined. A case may give the "
     "rate: "
     "velocities then agree with it."},
    {"W0507",
     done,
     "velocities or accelerations omitted",
     "A row of a motion lacks velocities, although the case gives speeds: in this position the "
     "drives do not determine them, or the known speeds do not determine how fast the drives run. "
     "A row of a simulation lacks them where it falls on such a position. "
     "Near such a position individual velocities, and accelerations a little earlier, are left out "
     "where the error of the position, some roundings, would dominate them. The values given are "
     "correct. Give the speeds of the drives themselves, or choose steps that avoid the position."},
    {"W0508",
     done,
     "friction reverses or rests",
     "Where a coupling with friction comes to rest and reverses, its friction reverses too: "
     "actions jump from those of one direction to those of the other. At the reversal itself "
     "they may be anything between the two, and a row exactly there has none. The message names "
     "the rows before and after, or the end of the range if it lies there; take more steps to "
     "narrow the interval. The same holds for what rests while a drive does, in the dwells of a "
     "profile and where it begins and ends, and where the mechanism of a motion is drawn at rest. "
     "Means and RMS of actions leave friction out there; those of friction itself are over the "
     "time in which it has a direction."},
    {"W0509",
     done,
     "dead points may be missing",
     "The program looks for dead points between the positions, as closely as the fastest part "
     "requires. The motion has so many turns of this part that this would take minutes: from some "
     "position on, only the positions themselves were checked. Let the motion run through a "
     "shorter range. Or several drives run by different laws at the same time: there dead points "
     "are not looked for."},
    {"W0510",
     done,
     "positions that do not close",
     "An overconstrained mechanism moves only if its dimensions fit exactly. With coordinates of a "
     "few digits they do not: as typed it is a structure, and 'analyze' and 'mobility' say so. The "
     "motion is still followed, with each position closed as nearly as possible, if no gap exceeds "
     "1e-5 of the size; the gaps are in the report. Type more digits, or expressions; or remove a "
     "doubtful link, if there is one too many."},
    {"W0511",
     done,
     "no limit was found",
     "'to: limit' runs until the drive reverses. A rotating drive is followed through a full turn: "
     "one that completes it has no limit, like the crank of a crank-rocker, except in trains in "
     "which a later turn differs from the first. A sliding drive is followed over twice the "
     "distance that the other bodies of its circuits could span; a limit farther away would need "
     "another slide, a screw or teeth. Everything up to there is in the report."},
    {"W0512",
     done,
     "law whose speed jumps",
     "With the law constant_speed a drive starts and ends at full speed, which would take an "
     "infinite acceleration and an infinite force there. The rows at both ends have the values of "
     "the steady motion between them. The laws polynomial_345 and cycloidal start and end at rest "
     "and without a jump in acceleration; 'kinestat help motion' lists all."},
    {"W0513",
     done,
     "a simulation ends before its goal",
     "'until' says where a simulation ends; it reached the end of 'time' first. The message gives "
     "the row that came nearest. If the value is still growing there, give more 'time'; if it was "
     "higher before, or settles, the drive is too weak, or the goal is not the one intended: a "
     "speed is in the unit of the file, a position is measured from the drawn one."},
    {"W0514",
     done,
     "a simulation ends where something parts",
     "A cable pulls and cannot push, surfaces in contact push and cannot pull, a cable leaves its "
     "pulley where its arc of contact becomes zero, and friction holds it there up to a ratio of "
     "tensions. Where equilibrium with inertia asks for more, the mechanism becomes another one: "
     "the simulation ends there with the event, and its rows are valid up to it. An impact that "
     "would part something is not carried out."},
    {"W0515",
     done,
     "the energy of a simulation is not explained",
     "Energy that is stored, supplied and lost should add up; here a share of it is missing that "
     "is no rounding, so positions and speeds are wrong by as much. Give a smaller 'tolerance', or "
     "more 'steps' if something acts for a moment only: what happens between steps is looked for "
     "in each of them."},
    {"W0516",
     done,
     "no efficiency in a position of a motion",
     "The efficiency of a case is the power of its outputs over that of its inputs. It has no "
     "value where the power of an input is not positive, where an output supplies power, or where "
     "something else supplies or absorbs power, such as a load that the case names neither as "
     "'input' nor as 'output': rows there have the status 'no_efficiency', or 'self_locking' where "
     "friction takes more than the inputs supply. Where nothing loses power there is none either, "
     "and rows are solved."},
    {"W0517",
     done,
     "forces of inertia hardly known",
     "Forces of inertia follow from accelerations, which are hardly determined beside a singular "
     "position, and where the case gives the speed of something that hardly moves while other "
     "parts run. The bound is the worst that rounding can do; the values are mostly far better. "
     "Move a little away from such a position, or give the speed of a coupling that moves more."},
    {"W0518",
     done,
     "motion ends at a limit",
     "A drive of 'motion' cannot reach the end of its range: links are stretched or folded in "
     "line, where the motion would have to reverse. The report goes up to the limit, which the "
     "message gives and the report brackets; extremes are those of this way, and there are no "
     "means. Where the limit is what is sought write 'to: limit', which tells the means, too. "
     "Otherwise end the motion earlier, drive another coupling, or change lengths: in a four-bar a "
     "crank turns fully if it is the shortest link and the shortest and longest together are "
     "shorter than the other two."},
    {"W0601",
     done,
     "actions are statically indeterminate",
     "Equilibrium alone does not determine every action from those that are known: the mechanism "
     "is overconstrained, or fewer actions are given than it needs. Determined actions have "
     "values, the others are listed, and the report gives the possible self-stresses. Friction "
     "caused by such actions is undetermined, too. Give more actions (the hint names sets that "
     "would suffice), release constraints with 'passive:', give couplings a stiffness, or request "
     "the values of least norm; 'kinestat help stiffness' has examples."},
    {"W0602",
     done,
     "mechanism is self-locking in this case",
     "With friction the input alone does not move the output: the output must also supply power, "
     "although without friction it would receive some. In a screw jack this means that the load "
     "does not lower itself; then it is a result and not a mistake."},
    {"W0603",
     done,
     "friction jams the mechanism",
     "Friction grows with the actions that it causes, and at these coefficients there is no finite "
     "solution for the motion of the case: the mechanism jams. The report has the status 'locked' "
     "and no actions for the case. Less friction, a longer guide or another direction of motion "
     "may have a solution; 'kinestat help friction' explains how friction is calculated."},
    {"W0604",
     done,
     "friction ignores a reaction",
     "The coupling has friction and carries a force or couple that would also press on its "
     "surfaces, but the file does not say at what radius or over what length, so it adds nothing "
     "to the friction. Give the dimension that the hint names; for a surface on rollers or balls, "
     "tau may be used instead."},
    {"W0605",
     done,
     "a contact would have to pull",
     "Two surfaces in contact can only push each other apart: along the normal, which points from "
     "the tail to the head, the action must not be negative. In reality they would separate, and "
     "the result of the case is valid only for a contact that is held from both sides."},
    {"W0606",
     done,
     "cable would be in compression",
     "A cable, belt or chain pulls and cannot push. Equilibrium requires a force that would push "
     "this segment, so in reality it goes slack and the result is not valid. If a pretension, a "
     "self-stress that pulls on segments and pushes on none, keeps all segments in tension, the "
     "hint gives the least one: add it to the tension given in the case."},
    {"W0607",
     done,
     "cable would slip",
     "Friction holds a cable on a pulley as long as the ratio of its tensions is at most exp(mu "
     "theta), theta being the contact angle (Euler and Eytelwein). The case does not let the cable "
     "slip, but the ratio is larger: the cable will slip, or needs more pretension."},
    {"W0608",
     done,
     "friction allows another equilibrium",
     "The friction of a bearing depends on the magnitude of its load and not on its direction. "
     "Where friction is large compared with what it opposes, as near a dead centre or in a wedge, "
     "the known actions may be in equilibrium in two ways: loaded one way, or the other way and so "
     "heavily that friction holds what would drive. The report has the one into which the "
     "equilibrium without friction changes as the friction grows from zero, and the message has "
     "the other. Which one occurs depends on what happened before, unless one of them requires of "
     "a member what it cannot provide. Give the action of that member instead of a known one, and "
     "there is one solution."},
    {"W0609",
     done,
     "loss of a cable at rest",
     "The 'eta' of a pulley or drum is friction, and friction opposes motion. Here the drum is at "
     "rest and an actuator holds it: the action of that actuator may be anything between the "
     "values for the two directions of motion, and the report has the one without loss, which lies "
     "between them. To start from rest takes the larger of the two. Give the drive a very small "
     "speed in the direction of the coming motion to get it."},
    {"W0610",
     done,
     "other flank of teeth is not known",
     "Teeth only push. Under a load of the other sense they press with their other flank, whose "
     "line of action is mirrored in the common pitch plane. The program finds this plane from the "
     "'tangent' of a gear, or from the axes about which the two bodies turn, their revolutes, "
     "cylindrical couplings, clutches and brakes, and the guide of a rack. Here there are none, or "
     "they do not agree with the motion of the teeth, the teeth are only a contact ('contact: "
     "true'), or their force changes its sense with the flank. The case has the line of action of "
     "the file with a negative force, so that the two bodies pull on each other: torques are "
     "right, the forces that part the bodies have the wrong sense. Write 'flank: fixed' for teeth "
     "whose line of action holds for both loads."},
    {"W0611",
     done,
     "freewheel on the wrong side",
     "A freewheel ('one_way') holds torques of one sign and slips in one sense. The case lets it "
     "hold a torque of the other sign, where it would overrun, or slip in the other sense, where "
     "it "
     "would lock, so that its numbers hold for a clutch in its place, not for this mechanism. "
     "'kinestat shift' decides by itself which of its gears a freewheel allows: there such a state "
     "is neutral or a tie-up."},
    {"W0612",
     done,
     "clutch or brake that drives",
     "A clutch or brake that slips takes power: its torque acts against its slip. In this case the "
     "torque acts along the slip, so that the clutch supplies power, which counts as power of the "
     "inputs. The sign of the torque is that of its first body on the second, and slip that of the "
     "second relative to the first."},
    {"W0701",
     done,
     "loss of a mesh is not known",
     "A mesh loses a fraction of the rolling power relative to its carrier, the body that holds "
     "the axes of both gears. Here no body holds both axes, or several do, so the carrier model "
     "gives no efficiency. The axes of a gear are those of its revolute and cylindrical couplings, "
     "clutches and brakes; the absolute model needs no carrier."},
    {"W0702",
     done,
     "mesh losses lock the case",
     "With its mesh losses the train cannot be driven by the input alone: whichever gears drive, "
     "the output would also have to supply power. It is a result and not a mistake: a train of "
     "high ratio may hold a load without a brake. The report gives the efficiency in the other "
     "direction; 'kinestat help losses' has an example."},
    {"W0703",
     done,
     "mesh losses have two answers",
     "Losses this large change which gear of a mesh drives, and here two choices are consistent "
     "with all the powers that they cause: the train may run with either efficiency, depending on "
     "how it was started. The report gives the solution that reverses the fewest meshes compared "
     "with the lossless train, and names the other. Losses of real teeth, a few hundredths, have "
     "one solution."},
    {"W0711",
     done,
     "too few shift elements for a gear",
     "The number of elements engaged in a gear is the net degree of freedom minus the number of "
     "inputs, and 'shift' names fewer, so no combination holds everything that must be held. An "
     "element is missing, or nothing holds a body of the train."},
    {"W0712",
     done,
     "a gear exceeds a limit",
     "A torque or a speed in a gear is larger than 'limits' of 'shift' allows. With mesh losses "
     "the larger of the torques without and with them counts. Nothing else changes: the shift "
     "table shows how much of its limits each gear uses, and a sweep drops such states with "
     "'limit_use <= 1' in 'keep'."},
    {"W0713",
     done,
     "gear change does not end as requested",
     "The element that slips at 'capacity' does not bring the train into the gear: the torques of "
     "input and output exceed it, it could not hold the gear once engaged, or a freewheel acts in "
     "the wrong direction. The message gives the required torque."},
    {"W0801",
     done,
     "positions leave too few digits",
     "Positions that close in on each other differ in their last digits only, and the dyads follow "
     "from the differences: with five positions at a distance h about four times the digits of h "
     "are lost, and numbers have 16. Fewer than three are left. Write the positions with more "
     "digits, which are used as typed, and request them with --digits or 'digits:'; or give "
     "derivatives at one position instead of several close to it."},
    {"W0802",
     done,
     "linkage does not move as its verdict says",
     "Synthesis judges circuits, branches and order of a linkage by closed-form solutions; moved "
     "as a mechanism, step by step, the linkage did not meet the positions that the verdict "
     "promises, or met those that it denies. Either the linkage is so close to a dead point that "
     "rounding decides, or this program is wrong: please report it with the file."},
    {"W0803",
     done,
     "layouts stay undecided",
     "Over ranges of stationary ratios a layout is refuted by the exact ranges of its ratios, or "
     "solved by a point; otherwise the ranges are bisected, a limited number of times. The layouts "
     "counted here were neither refuted nor solved at the end: usually they meet a requirement "
     "only at its limit. Narrow 'stationary_ratio', or give its values as a list, which gives an "
     "exact answer."},
    {"W0804",
     done,
     "transmission differs from its mechanism",
     "The mechanism with the tooth numbers of a transmission was solved gear by gear, as 'kinestat "
     "shift' does. A ratio, a torque or an efficiency differs from that of the search by more than "
     "rounding, or the gear does not exist. This is a bug in the program: please report it with "
     "the task."},
    {"W0805",
     done,
     "stationary ratio without common teeth",
     "A transmission is written with the smallest tooth numbers whose stationary ratios are those "
     "of the search, or within a thousandth of them, and with planets of 15 teeth or more. In a "
     "simple set with a ratio close to 1, sun and ring are nearly the same size and leave no room "
     "for such planets: the tooth numbers shown have another ratio, or planets that nobody would "
     "cut. Begin 'stationary_ratio' higher, or give 'teeth', so that whole tooth numbers meet all "
     "requirements."},
    {"W0806",
     done,
     "best linkage of a search is degenerate",
     "A search with 'vary' ranks linkages by their transmission angle between the positions. Where "
     "nothing bounds the ratio of their lengths, it can run to two dyads that almost coincide, or "
     "to a pivot far away: a link of less than a hundredth of the longest is reported. A linkage "
     "that turns fully can fold flat elsewhere and change its branch there: less than a degree "
     "from "
     "a dead point is reported. Give 'link_ratio', usually 5 to 12, or 'full_transmission_angle' "
     "in "
     "'limits'."},
    {"W0901",
     done,
     "tolerance matches no value",
     "Neither report has a value at the place that '--tolerance' names, or below it, so it has no "
     "effect: a key is misspelt, or a name has changed. Places are JSON Pointers as in the "
     "differences, for example /cases/drive/ratio; '*' stands for any one key."},
});

}  // namespace

std::span<const Code> warning_codes() {
  return kWarningCodes;
}

}  // namespace kinestat
