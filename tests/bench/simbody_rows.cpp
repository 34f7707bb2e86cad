#include "simbody_rows.hpp"

#include <Simbody.h>
#include <cstddef>
#include <vector>

namespace kinestat::bench {

namespace {

// As tight as positions of the program are closed.
constexpr double kClosure = 1e-12;

SimTK::Vec3 vector(const Components& of) {
  return {of[0], of[1], of[2]};
}

// At constant speed from zero.
class Steady : public SimTK::Motion::Custom::Implementation {
 public:
  explicit Steady(double speed) : speed_(speed) {}

  Implementation* clone() const override { return new Steady(*this); }

  SimTK::Motion::Level getLevel(const SimTK::State& /*state*/) const override {
    return SimTK::Motion::Position;
  }

  void calcPrescribedPosition(const SimTK::State& state,
                              int /*count*/,
                              SimTK::Real* q) const override {
    q[0] = speed_ * state.getTime();
  }

  void calcPrescribedPositionDot(const SimTK::State& /*state*/,
                                 int /*count*/,
                                 SimTK::Real* rate) const override {
    rate[0] = speed_;
  }

  void calcPrescribedPositionDotDot(const SimTK::State& /*state*/,
                                    int /*count*/,
                                    SimTK::Real* rate_rate) const override {
    rate_rate[0] = 0.0;
  }

 private:
  double speed_;
};

SimTK::MobilizedBody make_mobilizer(SimTK::MobilizedBody& tail,
                                    const LinkageJoint& joint,
                                    const LinkageBody& body) {
  // Frames of bodies are the world's in the drawn position.
  const SimTK::Body::Rigid rigid(SimTK::MassProperties(
      1.0,
      vector(body.centre),
      SimTK::Inertia(body.inertia).shiftFromMassCenter(vector(body.centre), 1.0)));
  const SimTK::UnitVec3 axis(vector(joint.axis));
  using SimTK::Transform;
  switch (joint.kind) {
    case JointKind::revolute: {
      const Transform frame(SimTK::Rotation(axis, SimTK::ZAxis), vector(joint.at));
      return SimTK::MobilizedBody::Pin(tail, frame, rigid, frame);
    }
    case JointKind::prismatic: {
      const Transform frame(SimTK::Rotation(axis, SimTK::XAxis), vector(joint.at));
      return SimTK::MobilizedBody::Slider(tail, frame, rigid, frame);
    }
    case JointKind::universal: {
      const Transform frame(
          SimTK::Rotation(axis, SimTK::XAxis, vector(joint.second_axis), SimTK::YAxis),
          vector(joint.at));
      return SimTK::MobilizedBody::Universal(tail, frame, rigid, frame);
    }
    case JointKind::spherical:
      break;
  }
  const Transform frame(vector(joint.at));
  return SimTK::MobilizedBody::Ball(tail, frame, rigid, frame);
}

}  // namespace

struct SimbodyRows::Model {
  explicit Model(const MassLinkage& linkage)
      : matter(system), forces(system), time(linkage.stroke / linkage.speed) {
    SimTK::Force::Gravity(forces, matter, vector(gravity_on(linkage)));
    std::vector<SimTK::MobilizedBody> bodies(linkage.bodies.size() + 1);
    bodies[0] = matter.Ground();
    for (std::size_t i = 0; i < linkage.joints.size(); ++i) {
      const LinkageJoint& joint = linkage.joints[i];
      const auto tail = static_cast<std::size_t>(joint.tail);
      const auto head = static_cast<std::size_t>(joint.head);
      if (!joint.closes) {
        bodies[head] = make_mobilizer(bodies[tail], joint, linkage.bodies[head - 1]);
      }
    }
    for (const LinkageJoint& joint : linkage.joints) {
      if (joint.closes) {
        SimTK::Constraint::Ball(bodies[static_cast<std::size_t>(joint.tail)],
                                vector(joint.at),
                                bodies[static_cast<std::size_t>(joint.head)],
                                vector(joint.at));
      }
    }
    for (const std::size_t drive : linkage.drives) {
      SimTK::MobilizedBody& head = bodies[static_cast<std::size_t>(linkage.joints[drive].head)];
      SimTK::Motion::Custom(head, new Steady(linkage.speed));
    }
    first = bodies[static_cast<std::size_t>(linkage.joints[linkage.drives.front()].head)];
    system.realizeTopology();
    drawn = system.getDefaultState();
    system.realizeModel(drawn);
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  double time;
  SimTK::MobilizedBody first;
  SimTK::State drawn;
  SimTK::Vector actions;
  SimTK::Vector_<SimTK::SpatialVec> reactions;
  double last = 0.0;
};

SimbodyRows::SimbodyRows(const MassLinkage& linkage) : model_(std::make_unique<Model>(linkage)) {}

SimbodyRows::~SimbodyRows() = default;

void SimbodyRows::run(int steps) {
  Model& model = *model_;
  SimTK::State state = model.drawn;
  for (int step = 0; step <= steps; ++step) {
    state.setTime(model.time * step / steps);
    model.system.realize(state, SimTK::Stage::Time);
    model.system.prescribeQ(state);
    model.system.realize(state, SimTK::Stage::Position);
    model.system.projectQ(state, kClosure);
    model.system.prescribeU(state);
    model.system.realize(state, SimTK::Stage::Velocity);
    model.system.projectU(state, kClosure);
    model.system.realize(state, SimTK::Stage::Acceleration);
    model.matter.findMotionForces(state, model.actions);
    model.matter.calcMobilizerReactionForces(state, model.reactions);
  }
  // Simbody has the forces of motions on the other side of the equation.
  model.last = -model.first.getOneFromUPartition(state, 0, model.actions);
}

double SimbodyRows::last_action() const {
  return model_->last;
}

}  // namespace kinestat::bench
