#!/usr/bin/env python3
"""Checks motions with friction against closed forms where what slides comes to rest.

Usage: motion_friction_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
import program
from motion_case import Motion, MotionTest, run

# Upright, the crank is a quarter of a turn past the dead centre of a slide with friction.
SLIDE_WITH_FRICTION = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [g, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, 40]}
  c: {type: revolute, bodies: [rod, ram], at: [120, 0]}
  d: {type: prismatic, bodies: [g, ram], at: [120, 0], axis: x, friction: 0.1}
actuators: {m: {coupling: a}, o: {coupling: d}}
cases: {c: {motion: {m: 10 rad/s}, action: {o: 900 N}}}
motion: {drive: m, to: 360 deg, steps: %d, case: c, report: [action]}
"""

# The pin slides in its slot by cos of the angle of the crank, which starts at atan(3/4).
YOKE = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, yoke]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  s: {type: pin_in_slot, bodies: [crank, yoke], at: [0.8, 0.6], slot: y, friction: 0.2}
  d: {type: prismatic, bodies: [frame, yoke], at: [2, 0], axis: x}
actuators: {Tin: {coupling: a}, F: {coupling: d}}
cases: {one: {motion: {Tin: 1 rad/s}, action: {F: -10 N}, input: Tin, output: F}}
motion:
  drive: Tin
  to: 2*(90 deg - atan(0.75))
  steps: %d
  case: one
  report: [velocity, action]
"""

# The block goes on steadily, and the ram is a little faster for three degrees of the crank.
OVERTAKEN = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: f
bodies: [crank, rod, ram, block]
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.1, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [0.3, 0]}
  d: {type: prismatic, bodies: [f, ram], at: [0.3, 0], axis: x}
  e: {type: prismatic, bodies: [ram, block], at: [0.3, 0], axis: x, friction: {mu: 0.3}}
  g: {type: prismatic, bodies: [f, block], at: [0.3, 0], axis: x, passive: []}
actuators: {M: {coupling: a}, G: {coupling: g}}
loads: {weight: {body: block, at: [0.3, 0], force: [0, -100]}}
cases: {c: {motion: {M: 1, G: %r}, action: {}}}
motion: {drives: [{drive: M}, {drive: G}], time: 3, steps: %d, case: c, report: [M/action, G/action]}
"""

# A tenth of a degree behind its dead centre it comes to rest.
RESTS_BEHIND_DEAD_CENTRE = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: f
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.1, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [0.4, 0]}
  d: {type: prismatic, bodies: [f, ram], at: [0.4, 0], axis: x, friction: {mu: 0.2}}
loads: {weight: {body: ram, at: [0.4, 0], force: [0, -1000]}}
actuators: {M: {coupling: a}}
cases: {c: {motion: {}, acceleration: {}, action: {}}}
motion: {drive: M, from: FROM, to: TO, time: 1, law: polynomial_345, steps: %d, case: c,
         report: [M/action]}
"""


# Two strokes, out and back, between two dwells: as short as a step, or a part of it.
STROKES_BETWEEN_DWELLS = """\
kinestat: 1
space: planar
ground: bed
bodies: {table: {mass: 60, centre_of_mass: [0, 0]}}
gravity: [0, -9.81]
couplings: {g: {type: prismatic, bodies: [bed, table], at: [0, 0], axis: x, friction: 0.1}}
actuators: {servo: {coupling: g}}
cases: {move: {motion: {servo: 0}, acceleration: {}, action: {}}}
motion:
  drives:
    - drive: servo
      profile:
        - {dwell: 1 s}
        - {to: 0.2, time: 0.04 s, law: LAW}
        - {to: 0, time: 0.04 s, law: LAW}
        - {dwell: 0.92 s}
  case: move
  steps: %d
  report: [velocity, action]
"""

# Yokes at r cos(t) and cos(3 t), r = 9 - 12 sin^2(1 deg): the one slides on the other by
# 12 sin(t) (sin^2(t) - sin^2(1 deg)), which has three zeros within two degrees.
THREE_TURNS = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: f
bodies: [crank, yoke, crank3, yoke3]
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0]}
  s: {type: pin_in_slot, bodies: [crank, yoke], at: [9 - 12*sin(1 deg)^2, 0], slot: y}
  d: {type: prismatic, bodies: [f, yoke], at: [0, 0], axis: x}
  a3: {type: revolute, bodies: [f, crank3], at: [0, 0]}
  s3: {type: pin_in_slot, bodies: [crank3, yoke3], at: [1, 0], slot: y}
  e: {type: prismatic, bodies: [yoke, yoke3], at: [0, 0], axis: x, friction: {mu: 0.3}}
loads: {weight: {body: yoke3, at: [0, 0], force: [0, -100]}}
actuators: {M: {coupling: a}, M3: {coupling: a3}}
cases: {c: {motion: {M: 1, M3: 3}, action: {}}}
motion: {drives: [{drive: M, from: -100, to: 97}, {drive: M3, from: -300, to: 291}], steps: %d,
         case: c, report: [M3/action]}
"""


def ram_speed(degrees: float) -> float:
    """Of OVERTAKEN, at 1 rad/s: x = 0.1 cos + sqrt(0.04 - (0.1 sin)^2)."""
    turn = math.radians(degrees)
    s, c = 0.1 * math.sin(turn), 0.1 * math.cos(turn)
    return -s - s * c / math.sqrt(0.04 - s * s)


class FrictionWithinAStep(MotionTest):
    def test_that_turns_round_twice_is_seen(self) -> None:
        fastest = min(ram_speed(one / 1000) for one in range(180000))
        for share in (0.9997, 0.99999):
            block = share * fastest
            crossings = []
            for low, high in ((30.0, 67.7), (67.7, 110.0)):
                side = ram_speed(low) > block
                for _ in range(60):
                    middle = 0.5 * (low + high)
                    low, high = (middle, high) if (ram_speed(middle) > block) == side else (low, middle)
                crossings.append(low)
            for steps in (1, 12, 24, 25, 31, 72):
                done = program.call("motion", "-", text=OVERTAKEN % (block, steps))
                motion = Motion(program.report(done))
                found = motion.events("friction_reversal", "e")
                self.assertEqual(len(found), 2, f"{steps} steps")
                for place, expected in zip(found, crossings):
                    self.close(place, expected, 1e-6, f"{steps} steps")
                force = program.report(done)["motion"]["figures"]["G/action"]
                self.close(force["least"], -30.0, 1e-12, f"{steps} steps")
                self.close(force["greatest"], 30.0, 1e-12, f"{steps} steps")

    def test_that_moves_between_two_rests_alone_is_seen(self) -> None:
        """A stroke within a step, whose ends are at rest: what is said of it is the same in any steps."""
        for law in ("cycloidal", "constant_speed", "polynomial_345"):
            rests = " at 1.04," if law != "constant_speed" else ""
            for steps in (1, 10, 12, 24, 25, 31, 50, 100, 400):
                text = STROKES_BETWEEN_DWELLS.replace("LAW", law) % steps
                done = program.call("motion", "-", text=text)
                where = f"{law}, {steps} steps"
                found = [one for one in program.report(done)["motion"]["events"]
                         if one["kind"] == "friction_reversal"]
                self.assertEqual(len(found), 1, where)
                self.close(found[0]["time"], 1.04, 1e-9, where)
                self.close(found[0]["drive"][0], 0.2, 1e-9, where)
                sides = found[0]["jumps"]["servo/action"]
                if law != "constant_speed":
                    self.close(sides["before"], 58.86, 1e-3, where)
                    self.close(sides["after"], -58.86, 1e-3, where)
                self.assertIn("friction of 'g' reverses at time = 1.04 s\n", done.stderr, where)
                self.assertIn(f"(from 0 to 1,{rests} from 1.08 to 2 s, ", done.stderr, where)

    def test_that_turns_round_three_times_is_seen(self) -> None:
        for steps in (1, 12, 24, 25, 31, 72, 197):
            done = program.call("motion", "-", text=THREE_TURNS % steps)
            found = Motion(program.report(done)).events("friction_reversal", "e")
            self.assertEqual(len(found), 3, f"{steps} steps: {found} {done.stderr}")
            for place, expected in zip(found, (-1.0, 0.0, 1.0)):
                self.assertAlmostEqual(place, expected, delta=1e-6, msg=f"{steps} steps")

    def test_just_beside_a_rest_is_seen(self) -> None:
        for begin, end in (("20", "180.1"), ("179.9", "340")):
            for steps in (1, 24, 48, 200):
                text = RESTS_BEHIND_DEAD_CENTRE.replace("FROM", begin).replace("TO", end) % steps
                motion = Motion(program.report(program.call("motion", "-", text=text)))
                found = motion.events("friction_reversal", "d")
                self.assertEqual(len(found), 1, f"to {end} in {steps} steps")
                self.close(found[0], 180.0, 1e-6, f"to {end} in {steps} steps")


class FrictionInSlides(MotionTest):
    def test_turns_round_at_dead_points_whatever_the_steps(self) -> None:
        for steps in (36, 50, 71, 72):
            done = program.call("motion", "-", text=SLIDE_WITH_FRICTION % steps)
            self.assertEqual(done.returncode, 0, f"{steps} steps: {done.stderr}")
            self.assertNotIn("E0606", done.stderr, f"{steps} steps")
            self.assertIn("friction of 'd' reverses", done.stderr, f"{steps} steps")
            self.assertIn("and once more", done.stderr, f"{steps} steps")


TWO_OPPOSED_SLIDES = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, ram, rod2, ram2]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [160, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [160, 0], axis: x, friction: 0.1}
  b2: {type: revolute, bodies: [crank, rod2], at: [-40, 0]}
  c2: {type: revolute, bodies: [rod2, ram2], at: [-160, 0]}
  d2: {type: prismatic, bodies: [frame, ram2], at: [-160, 0], axis: x, friction: 0.1}
actuators: {m: {coupling: a}, o: {coupling: d}, o2: {coupling: d2}}
cases: {c: {motion: {m: 10 rad/s}, action: {o: 900 N, o2: -500 N}}}
motion: {drive: m, to: 360 deg, steps: %d, case: c, report: [action]}
"""


class SeveralFrictions(MotionTest):
    def test_reverse_in_one_row_each_with_an_event_of_its_own(self) -> None:
        for steps in (2, 3, 4, 8, 36):
            done = program.call("motion", "-", text=TWO_OPPOSED_SLIDES % steps)
            self.assertEqual(done.returncode, 0, f"{steps} steps: {done.stderr}")
            motion = Motion(program.report(done))
            for slide in ("d", "d2"):
                places = motion.events("friction_reversal", slide)
                self.assertEqual(len(places), 3, f"{slide}, {steps} steps")
                for place, expected in zip(places, (0.0, 180.0, 360.0)):
                    self.assertAlmostEqual(place, expected, delta=1e-5)


class FrictionInSlots(MotionTest):
    def test_turns_round_where_the_pin_does_whatever_the_steps(self) -> None:
        for steps in (1, 2, 3, 6, 7):
            done = program.call("motion", "-", text=YOKE % steps)
            self.assertEqual(done.returncode, 0, f"{steps} steps: {done.stderr}")
            self.assertIn("friction of 's' reverses", done.stderr, f"{steps} steps")
            self.assertNotIn("E0606", done.stderr, f"{steps} steps")
            status = Motion(program.report(done))["status"]
            dead = {steps // 2} if steps % 2 == 0 else set()
            self.assertEqual({r for r, one in enumerate(status) if one == "friction_reversal"}, dead)

    def test_rests_at_the_ends_of_a_range_as_it_does_within(self) -> None:
        """The pin runs along the slot as sin(a), from -90 to 90 deg."""
        ends = YOKE.replace("to:", "from: -90 deg - atan(0.75)\n  to:")
        ends = ends.replace("2*(90 deg - atan(0.75))", "90 deg - atan(0.75)")
        for steps in (2, 3, 8):
            done = program.call("motion", "-", text=ends % steps)
            self.assertEqual(done.returncode, 0, f"{steps} steps: {done.stderr}")
            self.assertIn("friction of 's' reverses at Tin = -2.2143 rad, and once more",
                          done.stderr)
            status = Motion(program.report(done))["status"]
            self.assertEqual(status, ["friction_reversal", *["solved"] * (steps - 1), "friction_reversal"])


IN_LINE_WITH_FRICTION = """kinestat: 1
name: in-line slider-crank, drawn at its outer dead centre
units: {angle: deg}
space: planar
ground: frame
bodies: [crank, rod, slide]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [1, 0]}
  c: {type: revolute, bodies: [rod, slide], at: [4, 0]}
  d: {type: prismatic, bodies: [frame, slide], at: [4, 0], axis: x, friction: 0.1}
actuators: {Tin: {coupling: a}, F: {coupling: d}}
cases: {one: {motion: {Tin: 1 rad/s}, action: {F: -10 N}, input: Tin, output: F}}
motion: {drive: Tin, to: %s deg, steps: %d, case: one, report: [action]}
"""


OVERCONSTRAINED_SCREW = """kinestat: 1
units: {length: mm, angle: deg}
ground: frame
bodies: [screw, nut]
couplings:
  a: {type: revolute, bodies: [frame, screw], at: [0, 0, 0], axis: z,
      friction: {mu: 0.1, radius: 8, thrust_radius: 15}}
  h: {type: helical, bodies: [screw, nut], at: [0, 0, 100], axis: z, lead: 6 mm,
      friction: {mu: 0.15, radius: 11}}
  g: {type: prismatic, bodies: [frame, nut], at: [0, 0, 100], axis: z}
actuators: {m: {coupling: a}, out: {coupling: g}}
cases: {run: {motion: {m: 10 rad/s}, action: {out: -1000 N}}}
motion: {drive: m, to: 360 deg, steps: 2, case: run, report: [reaction]}
"""


class OpenFriction(MotionTest):
    def test_that_redundant_supports_share_has_no_value(self) -> None:
        """How bearing and guide share side forces is open, and what follows from these."""
        motion = run(OVERCONSTRAINED_SCREW)
        self.assertEqual(set(motion["status"]), {"indeterminate"})
        for quantity in ("friction", "loss", "force"):
            self.assertEqual(set(motion[f"a/{quantity}"]), {None}, quantity)


class DeadCentresAtTheEnds(MotionTest):
    def test_are_events_and_leave_open_what_those_on_the_way_do(self) -> None:
        for end, steps in ((360, 4), (360, 8), (360, 7), (180, 3), (-180, 3), (540, 12),
                           (180, 1), (360, 1), (360, 2), (720, 4)):
            done = program.call("motion", "-", text=IN_LINE_WITH_FRICTION % (end, steps))
            self.assertEqual(done.returncode, 0, f"{end} deg: {done.stderr}")
            self.assertNotIn("E0606", done.stderr)
            self.assertIn("friction of 'd' reverses at Tin = 0 deg", done.stderr)
            motion = Motion(program.report(done))
            dead = [r for r in range(steps + 1) if r * end % (180 * steps) == 0]
            self.assertEqual([r for r, one in enumerate(motion["status"]) if one == "friction_reversal"],
                             dead)
            places = motion.events("dead_point", "d.vx")
            sense = 1 if end > 0 else -1
            self.assertEqual(len(places), abs(end) // 180 + 1)
            for k, place in enumerate(places):
                self.close(place, sense * 180.0 * k, 1e-6, f"to {end} deg")

    def test_a_friction_that_never_slides_has_no_dead_point(self) -> None:
        still = IN_LINE_WITH_FRICTION.replace("Tin: 1 rad/s", "Tin: 0 rad/s") % (180, 3)
        done = program.call("motion", "-", text=still)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("E0606", done.stderr)


if __name__ == "__main__":
    motion_case.main()
