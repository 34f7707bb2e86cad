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
     "It may stand, but nothing depends on it: a parameter in no expression, a stiffness that "
     "'statics:' does not ask for, gravity without masses, a load on the ground. Often a name is "
     "misspelt where it is used, or something was forgotten there."},
    {"W0302",
     done,
     "section is not analysed yet",
     "The section or key is read and checked, but this version has no analysis for it, or has it "
     "in a command of its own, which the hint names. The rest of the file is analysed as if it "
     "were absent; no other answer depends on it. 'kinestat check' warns in this way also of what "
     "leaves 'kinestat analyze' without an answer (E0315)."},
    {"W0303",
     done,
     "angle is more than a full turn",
     "A bare number stands for an angle and counts in radians, the unit that holds unless 'units:' "
     "names another, but it is more than a full turn: degrees were probably meant. Write the unit, "
     "30 deg, or 'units: {angle: deg}' for the whole file."},
    {"W0304",
     done,
     "gravity is of an unlikely size",
     "A bare number of 'gravity' counts in the units of the file, length by time squared: with "
     "'units: {length: mm}', 9.81 is 9.81 mm/s^2, a thousandth of the earth's. Write the unit, "
     "9.81 m/s^2; with its unit, any value is taken without a word."},
    {"W0305",
     done,
     "teeth ask for different centre distances",
     "Two gears without profile shift mesh where their centres are half the sum of their teeth, "
     "or with a ring half the difference, times the module apart. The meshes of a planet ask for "
     "different distances, or for another one than 'centre_distance' and the triangle of two "
     "planets give, or a bearing stands beside the axis of its gears; of a plain set, ring = sun "
     "+ 2*planet is not met. Ratios are exact all the same, because each pitch point divides the "
     "distance in the ratio of teeth. With profile shift write 'centre_distance' of the planet; a "
     "difference of less than a module is then taken without a word."},
    {"W0306",
     done,
     "planets cannot be assembled at equal angles",
     "From one of several equal planets to the next, the teeth of the gears on the main axis must "
     "repeat: of a sun and a ring, (sun + ring)/count must be whole, and of stepped or paired "
     "planets the number that the message gives. Planets at unequal angles, or turned against "
     "each other on their shafts, may be meant; motions and actions do not change."},
    {"W0307",
     done,
     "neighbouring planets touch",
     "With so many planets the tip circles of two neighbours, one module outside their pitch "
     "circles, would overlap. The message gives the distance of their centres and the one they "
     "need. Motions and actions do not change."},
    {"W0308",
     done,
     "cable does not run around its pulley as it should",
     "It is led around the far side, turns by more than half a turn and comes back over itself; or "
     "its 'points' give it two levers about the axis. The first is right for a capstan, on which a "
     "cable lies beside itself, and 'turns: 0' says so, but more often 'wrap', the sense of "
     "turning for someone who follows the cable in listed order, names the other sense: then "
     "torques and speeds have the wrong sign. The second is a cable on an arm rather than on a "
     "round pulley: the tensions of its two sides differ as the levers do."},
    {"W0309",
     done,
     "link has no length",
     "In a file with a motion, a body is joined to two others by revolute couplings on one axis "
     "and to nothing else, so that it is a sleeve that may turn by itself, and the two others turn "
     "about that axis together. More often two points are the same by mistake. Give the couplings "
     "different points, or join the two other bodies directly."},
    {"W0310",
     done,
     "body is counted as a point mass",
     "A body with a mass and without 'inertia' turns in a case with 'acceleration'. Its mass "
     "counts "
     "as if it were all at the centre, so that turning it about that asks for nothing. Give "
     "'inertia' about the centre of mass, or 0 where it is small enough to be left out."},
    {"W0311",
     done,
     "inertia does not suit the mechanism",
     "The radius of gyration, the root of inertia over mass, is the distance at which all the mass "
     "would have that inertia. Here it is larger than the whole mechanism, or a thousand times "
     "smaller. Most often the unit of the inertia is another one than was meant: bare numbers "
     "count in the unit of inertia, kg*m^2 unless 'units' says otherwise, whatever the unit of "
     "length is."},
    {"W0312",
     done,
     "accelerations change nothing",
     "A case has the key 'acceleration', so that the forces of inertia act, but no body has a mass "
     "or an inertia. Give bodies 'mass', 'centre_of_mass' and 'inertia', or remove the key."},
    {"W0313",
     done,
     "damping counts by the unit of speed",
     "A damping is a couple by an angular velocity, or a force by a velocity, and a bare number "
     "counts in these units of the file: with 'units: {angular_velocity: rpm}' in N*m/rpm, which "
     "is "
     "9.55 N*m*s/rad, with 'units: {length: mm}' in N/(mm/s), a thousand N*s/m. Write the unit; "
     "with it, any value is taken without a word."},
    {"W0501",
     done,
     "rounding decides on a rank",
     "The numbers as typed and the same numbers rounded to double give different ranks: one says "
     "that the mechanism is redundant, or stands in a singular position, and the other that it is "
     "not. Both answers are in the report; counts and solutions are those of the rounded numbers, "
     "unless '--accuracy exact' solves a case as typed. Coordinates that were calculated and then "
     "typed with a few decimals make a redundant mechanism regular: write expressions instead, "
     "such as 100*sqrt(2) mm."},
    {"W0502",
     done,
     "fewer digits than asked for",
     "The bound of the error of a value exceeds what '--digits' asks for, also after refinement. "
     "It is a bound: the value may be better. '--accuracy exact' solves the numbers as typed."},
    {"W0503",
     done,
     "motion passes a singular position",
     "On the way there is a position at which another motion crosses, as where the links of a "
     "parallelogram are in line: there the drive does not determine the motion. The report "
     "continues on the same branch, as inertia would carry the links, and lists the position. A "
     "machine needs a flywheel, or a second linkage that leads it across."},
    {"W0504",
     done,
     "drawn position does not close",
     "Points of two bodies that do not meet in the reference position, or lengths that do "
     "not fit, were closed before the motion began: the drives stay where they are drawn, and "
     "everything else moves by as little as it must. The report has the gaps as drawn and how far "
     "each body moved; motions are measured from the drawn position all the same."},
    {"W0505",
     done,
     "no transmission angle",
     "The transmission angle is that of the force which drives the body of the output through its "
     "one other coupling. There is none where several couplings drive it, where a couple does, or "
     "where equilibrium leaves the force open: in a plane mechanism drawn in space the bearings "
     "may press on each other along their axes, as far as equilibrium says, and that belongs to "
     "the force."},
    {"W0506",
     done,
     "motions that no other body feels",
     "A body can turn or shift without any other body feeling it, as a rod between two balls about "
     "its own line. A case that does not give such a rate has none in its report, and all others. "
     "In each step of a motion it moves by as little as it must, so that how far it has turned "
     "depends on the number of steps, and is not what its velocities add up to. All other "
     "positions are determined. A case may give its rate: velocities meet that."},
    {"W0507",
     done,
     "velocities or accelerations left out",
     "A row of a motion lacks velocities, although the case knows speeds: in this position the "
     "drives do not determine them, or the known speeds do not tell how fast the drives run. "
     "Beside such a position single velocities, and accelerations a little earlier, are left out "
     "where the error of the position, some roundings, would be most of them. What is there is "
     "right. Give the speeds of the drives themselves, or take steps that miss the position."},
    {"W0508",
     done,
     "friction turns round",
     "Where a coupling with friction comes to rest and turns back, its friction does too: actions "
     "jump from those of one direction to those of the other. At the dead point itself they may "
     "be anything between the two, and a row that falls on it has none. The message names the "
     "rows before and behind, or the end of the range where it lies there; take more steps to "
     "narrow them."},
    {"W0509",
     done,
     "dead points may be missing",
     "Dead points are looked for between the positions, as often as the fastest part asks for. The "
     "motion has so many turns of it that this would take minutes: from some place on only the "
     "positions themselves were looked at. Let the motion run through a shorter range."},
    {"W0510",
     done,
     "positions that do not close",
     "An overconstrained mechanism moves only if its dimensions fit exactly. With coordinates of a "
     "few figures they do not: as typed it is a structure, and 'analyze' and 'mobility' say so. "
     "The motion is followed all the same, each position as near to closed as it can be, if none "
     "misses by more than 1e-5 of the size; what is missed is in the report. Type more figures, "
     "or expressions; or let an uncertain link go, if one too many is drawn."},
    {"W0511",
     done,
     "no limit was found",
     "'to: limit' runs until the drive turns back. A drive that turns is followed through a full "
     "turn: one that comes round meets no limit, as the crank of a crank-rocker, but for trains "
     "in which a later turn differs from the first. A drive that slides is followed over twice "
     "what the other bodies of its circuits could bridge; a limit farther away would need another "
     "slide, a screw or teeth. Everything up to there is in the report."},
    {"W0512",
     done,
     "law whose speed jumps",
     "With the law constant_speed a drive begins and ends at full speed, which would take an "
     "infinite acceleration and an infinite force there. The rows at both ends have the values of "
     "the steady motion between them. The laws polynomial_345 and cycloidal begin and end at rest "
     "and without a jump of the acceleration; 'kinestat help motion' lists all."},
    {"W0513",
     done,
     "a simulation ends before its goal",
     "'until' says where a simulation ends; it came to the end of 'time' without that. The message "
     "has the row that came nearest. Where the value still grows there, give more 'time'; where it "
     "has been higher before, or settles, what drives is too weak, or the goal is another than "
     "meant: a speed in the unit of the file, a position counted from the drawn one."},
    {"W0601",
     done,
     "actions are statically indeterminate",
     "Equilibrium alone does not determine every action with those that are known: the mechanism "
     "is overconstrained, or fewer actions are given than it needs. Determined ones have values, "
     "the others are listed, and the report has the self-stresses that are possible. Friction "
     "that such actions cause is open, too. Give more actions (the hint names sets that would "
     "do), release constraints by 'passive:', give couplings a stiffness, or ask for the values "
     "of least norm; 'kinestat help stiffness' has examples."},
    {"W0602",
     done,
     "mechanism is self-locking in this case",
     "With friction the input alone does not move the output: the output, too, must give power, "
     "although without friction it would take some. In a screw jack it means that the load does "
     "not lower itself; then it is a result and no mistake."},
    {"W0603",
     done,
     "friction locks the mechanism",
     "The friction grows with the actions that it causes, and at these coefficients there is no "
     "finite solution for the motion of the case: the mechanism jams. The report has the status "
     "'locked' and no actions for the case. Less friction, a longer guide or another direction "
     "of motion may have an answer; 'kinestat help friction' says how friction is counted."},
    {"W0604",
     done,
     "a reaction has no friction",
     "The coupling has friction and bears a force or couple that would press too, but the file "
     "does not say on what radius or length, so that it adds nothing to the friction. Give the "
     "dimension that the hint names; where the surface runs on rollers or balls, tau may stand "
     "for it."},
    {"W0605",
     done,
     "a contact would have to pull",
     "Two surfaces that touch can only push each other apart: along the normal, which points from "
     "the tail to the head, the action must not be negative. In reality they would part, and the "
     "answer of the case holds only for a contact that is held from both sides."},
    {"W0606",
     done,
     "cable would be in compression",
     "A cable, belt or chain pulls and cannot push. Equilibrium asks for a force that would push "
     "this segment, so in truth it goes slack and the answer does not hold. Where a pretension, a "
     "self-stress that pulls on segments and pushes on none, keeps all segments in tension, the "
     "hint has the least one: add it to the tension that the case knows."},
    {"W0607",
     done,
     "cable would slip",
     "Friction holds a cable on a pulley as long as the ratio of its tensions is at most exp(mu "
     "theta), theta being the contact angle (Euler and Eytelwein). The case does not let the cable "
     "slip, and the ratio is larger: so it will slip, or needs more pretension."},
    {"W0608",
     done,
     "friction allows another equilibrium",
     "The friction of a bearing depends on the size of its load and not on the sense. Where "
     "friction is large beside what it works against, as near a dead centre or in a wedge, the "
     "known actions may be in equilibrium in two ways: pressed one way, or the other way and so "
     "hard that friction holds what would drive. The report has the one into which the equilibrium "
     "without friction changes as the friction grows from nothing, and the message has the other. "
     "Which holds depends on what happened before, unless one of them asks of a member what it "
     "cannot give. Give the action of that member instead of a known one, and there is one "
     "answer."},
    {"W0701",
     done,
     "loss of a mesh is not known",
     "A mesh loses a share of the power that rolls as seen from its carrier, the body in which the "
     "axes of both gears stand. Here no body holds both axes, or several do, so that the carrier "
     "model gives no efficiency. The axes of a gear are those of its revolute and cylindrical "
     "couplings, clutches and brakes; the absolute model needs no carrier."},
    {"W0702",
     done,
     "losses of meshes lock the case",
     "With the losses of its meshes the train cannot be driven by the input alone: whichever gears "
     "drive, the output, too, would have to give power. It is a result and no mistake: a train of "
     "high ratio may hold a load without a brake. The report has the efficiency of the other "
     "direction; 'kinestat help losses' has an example."},
    {"W0703",
     done,
     "losses of meshes have two answers",
     "Losses so large change which gear of a mesh drives, and here two choices agree with all the "
     "powers that they cause: the train may run with either efficiency, as how it was started "
     "decides. The report gives the answer that turns the fewest meshes against the lossless "
     "train, and names the other. Losses of real teeth, some hundredths, have one answer."},
    {"W0711",
     done,
     "too few shift elements for a gear",
     "A gear engages as many elements as the net degree of freedom has more than there are "
     "inputs, and 'shift' names fewer: so no combination holds all that must be held. An element "
     "is missing, or a body of the train is held by nothing."},
    {"W0712",
     done,
     "a gear exceeds a limit",
     "A torque or a speed of a gear is larger than 'limits' of 'shift' allows. With losses of "
     "meshes "
     "the larger of the torques without and with them counts. Nothing else changes: the shift "
     "table "
     "has what each gear takes of its limits, and a sweep drops such states with 'limit_use <= 1' "
     "in "
     "'keep'."},
    {"W0713",
     done,
     "a change of gear does not end as asked",
     "The element that slips at 'capacity' does not bring the train into the gear: the torques of "
     "input and output outweigh it, it could not hold the gear once it is there, or a freewheel "
     "stands on the wrong side. The message has the torque that it takes."},
    {"W0801",
     done,
     "positions leave too few digits",
     "Positions that close in on each other differ in their last digits only, and the dyads follow "
     "from the differences: with five positions at a distance h about four times the digits of h "
     "are lost, and numbers have 16. Fewer than three are left. Write the positions with more "
     "digits, which count as typed, and ask for them with --digits or 'digits:'; or give "
     "derivatives at one position instead of several close to it."},
    {"W0802",
     done,
     "linkage does not move as its verdict says",
     "Synthesis judges circuits, branches and order of a linkage by closed forms; moved as a "
     "mechanism, step by step, the linkage did not meet the positions that the verdict promises, "
     "or met those that it denies. Either the linkage is so close to a dead point that rounding "
     "decides, or this program is wrong: please report it with the file."},
    {"W0803",
     done,
     "layouts stay undecided",
     "Over ranges of stationary ratios a layout is refuted by the exact ranges of its ratios, or "
     "solved by a point; between both the ranges are cut in two, a number of times. The layouts "
     "counted here were neither when that ended: as a rule they meet a requirement on its edge "
     "alone. Narrow 'stationary_ratio', or give its values as a list, which has an exact answer."},
    {"W0804",
     done,
     "transmission differs from its mechanism",
     "The mechanism in teeth of a transmission was solved gear by gear, as 'kinestat shift' does. "
     "Its "
     "ratio, a torque or an efficiency differs from that of the search by more than rounding, or "
     "it has no such gear. This program is wrong then: please report it with the task."},
    {"W0805",
     done,
     "stationary ratio without common teeth",
     "A transmission is written with the smallest teeth that have the stationary ratios of the "
     "search, or have them to a thousandth, and with planets of 15 teeth or more. Of a simple set "
     "close to 1 sun and ring are nearly of one size, and there is no room for such planets: the "
     "teeth told here have another ratio, or planets that nobody would cut. Begin "
     "'stationary_ratio' higher, or give 'teeth': all that is found is met by such teeth then."},
    {"W0901",
     done,
     "tolerance meets no value",
     "No value of the two reports is at the place that '--tolerance' names, or below it, so it "
     "loosens nothing: a key is misspelt, or a name has changed. Places are JSON Pointers as in "
     "the differences, for example /cases/drive/ratio; '*' stands for any one key."},
});

}  // namespace

std::span<const Code> warning_codes() {
  return kWarningCodes;
}

}  // namespace kinestat
