#include "mass_linkage.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/types.hpp"

namespace kinestat::bench {

namespace {

constexpr double kInertia = 0.01;

Components components(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

std::string written(const Components& of, bool is_planar) {
  return is_planar ? fmt::format("[{}, {}]", of[0], of[1])
                   : fmt::format("[{}, {}, {}]", of[0], of[1], of[2]);
}

LinkageJoint revolute(int tail, int head, const Vec3& at, const Vec3& axis = Vec3::UnitZ()) {
  return {.kind = JointKind::revolute,
          .tail = tail,
          .head = head,
          .at = components(at),
          .axis = components(axis)};
}

LinkageJoint closing(LinkageJoint joint) {
  joint.closes = true;
  return joint;
}

// Each where the joints of the body are on average.
void put_masses(MassLinkage& linkage, std::size_t count) {
  linkage.bodies.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    Vec3 sum = Vec3::Zero();
    int joints = 0;
    for (const LinkageJoint& joint : linkage.joints) {
      const int body = static_cast<int>(b) + 1;
      if (joint.tail == body || joint.head == body) {
        sum += Vec3(joint.at[0], joint.at[1], joint.at[2]);
        ++joints;
      }
    }
    linkage.bodies[b] = {.centre = components(sum / joints), .inertia = kInertia};
  }
}

MassLinkage four_bar() {
  MassLinkage linkage{.name = "four-bar", .is_planar = true};
  linkage.joints = {revolute(0, 1, Vec3(0.0, 0.0, 0.0)),
                    revolute(1, 2, Vec3(0.1, 0.3, 0.0)),
                    revolute(0, 3, Vec3(0.9, 0.0, 0.0)),
                    closing(revolute(2, 3, Vec3(0.8, 0.6, 0.0)))};
  put_masses(linkage, 3);
  linkage.drives = {0};
  linkage.stroke = 2.0 * std::numbers::pi;
  linkage.speed = 10.0;
  return linkage;
}

MassLinkage watt_six_bar() {
  MassLinkage linkage{.name = "Watt six-bar", .is_planar = true};
  linkage.joints = {revolute(0, 1, Vec3(0.0, 0.0, 0.0)),
                    revolute(1, 2, Vec3(0.1, 0.4, 0.0)),
                    revolute(0, 3, Vec3(0.8, 0.0, 0.0)),
                    closing(revolute(2, 3, Vec3(0.7, 0.6, 0.0))),
                    revolute(2, 4, Vec3(0.5, 0.9, 0.0)),
                    revolute(3, 5, Vec3(1.1, 0.5, 0.0)),
                    closing(revolute(4, 5, Vec3(1.2, 1.1, 0.0)))};
  put_masses(linkage, 5);
  linkage.drives = {0};
  linkage.stroke = 2.0 * std::numbers::pi;
  linkage.speed = 10.0;
  return linkage;
}

// A universal joint at one end of the rod, so that it does not spin.
MassLinkage spatial_crank_and_rocker() {
  MassLinkage linkage{.name = "spatial crank and rocker"};
  const Vec3 pin(0.4, 0.2, 0.0);
  const Vec3 end(1.0, 0.8, 0.6);
  const Vec3 rod = end - pin;
  LinkageJoint at_pin{.kind = JointKind::universal, .tail = 1, .head = 2, .at = components(pin)};
  at_pin.axis = components(Vec3::UnitZ());
  at_pin.second_axis = components(Vec3::UnitZ().cross(rod).normalized());
  linkage.joints = {
      revolute(0, 1, Vec3::Zero()),
      at_pin,
      revolute(0, 3, Vec3(1.2, 0.2, 0.4), Vec3::UnitY()),
      {.kind = JointKind::spherical, .tail = 2, .head = 3, .at = components(end), .closes = true}};
  put_masses(linkage, 3);
  linkage.drives = {0};
  linkage.stroke = 1.0;
  linkage.speed = 10.0;
  return linkage;
}

MassLinkage platform_on_legs() {
  MassLinkage linkage{.name = "platform on six legs"};
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr int kPlatform = 13;
  const double below[] = {10.0, 110.0, 130.0, 230.0, 250.0, 350.0};
  const double above[] = {50.0, 70.0, 170.0, 190.0, 290.0, 310.0};
  for (int leg = 0; leg < 6; ++leg) {
    const double b = below[leg] * kDegree;
    const double a = above[leg] * kDegree;
    const Vec3 foot(1.2 * std::cos(b), 1.2 * std::sin(b), 0.0);
    const Vec3 top(0.7 * std::cos(a), 0.7 * std::sin(a), 1.0);
    const Vec3 along = (top - foot).normalized();
    const int lower = 2 * leg + 1;
    const Vec3 tangent(-std::sin(b), std::cos(b), 0.0);
    LinkageJoint hinge{
        .kind = JointKind::universal, .tail = 0, .head = lower, .at = components(foot)};
    hinge.axis = components(tangent);
    hinge.second_axis = components(tangent.cross(along).normalized());
    linkage.joints.push_back(hinge);
    linkage.drives.push_back(linkage.joints.size());
    linkage.joints.push_back({.kind = JointKind::prismatic,
                              .tail = lower,
                              .head = lower + 1,
                              .at = components(0.5 * (foot + top)),
                              .axis = components(along)});
    linkage.joints.push_back({.kind = JointKind::spherical,
                              .tail = lower + 1,
                              .head = kPlatform,
                              .at = components(top),
                              .closes = leg > 0});
  }
  put_masses(linkage, kPlatform);
  linkage.stroke = 0.2;
  linkage.speed = 1.0;
  return linkage;
}

std::string word_of(const LinkageJoint& joint, bool is_planar) {
  switch (joint.kind) {
    case JointKind::revolute:
      return is_planar ? "type: revolute" : "type: revolute, axis: " + written(joint.axis, false);
    case JointKind::prismatic:
      return "type: prismatic, axis: " + written(joint.axis, is_planar);
    case JointKind::universal:
      return fmt::format("type: universal, axes: [{}, {}]",
                         written(joint.axis, false),
                         written(joint.second_axis, false));
    case JointKind::spherical:
      return "type: spherical";
  }
  return "";
}

}  // namespace

Components gravity_on(const MassLinkage& linkage) {
  return {0.0, linkage.is_planar ? -9.81 : 0.0, linkage.is_planar ? 0.0 : -9.81};
}

std::vector<MassLinkage> mass_linkages() {
  return {four_bar(), watt_six_bar(), spatial_crank_and_rocker(), platform_on_legs()};
}

std::string file_text(const MassLinkage& linkage, bool has_inertia, int steps) {
  const bool is_planar = linkage.is_planar;
  std::string text = fmt::format("kinestat: 1\nspace: {}\nground: b0\ngravity: {}\nbodies:\n",
                                 is_planar ? "planar" : "spatial",
                                 written(gravity_on(linkage), is_planar));
  for (std::size_t b = 0; b < linkage.bodies.size(); ++b) {
    const LinkageBody& body = linkage.bodies[b];
    const double j = body.inertia;
    text += fmt::format("  b{}: {{mass: 1, centre_of_mass: {}, inertia: {}}}\n",
                        b + 1,
                        written(body.centre, is_planar),
                        is_planar ? fmt::format("{}", j) : fmt::format("[{0}, {0}, {0}]", j));
  }
  text += "couplings:\n";
  for (std::size_t i = 0; i < linkage.joints.size(); ++i) {
    const LinkageJoint& joint = linkage.joints[i];
    text += fmt::format("  j{}: {{{}, bodies: [b{}, b{}], at: {}}}\n",
                        i,
                        word_of(joint, is_planar),
                        joint.tail,
                        joint.head,
                        written(joint.at, is_planar));
  }
  std::string actuators;
  std::string speeds;
  std::string drives;
  for (const std::size_t drive : linkage.drives) {
    const char* comma = actuators.empty() ? "" : ", ";
    actuators += fmt::format("{}d{}: {{coupling: j{}}}", comma, drive, drive);
    speeds += fmt::format("{}d{}: {}", comma, drive, linkage.speed);
    drives += fmt::format("{}{{drive: d{}, to: {}}}", comma, drive, linkage.stroke);
  }
  text += fmt::format("actuators: {{{}}}\ncases:\n  c: {{motion: {{{}}}, action: {{}}{}}}\n",
                      actuators,
                      speeds,
                      has_inertia ? ", acceleration: {}" : "");
  text += fmt::format(
      "motion: {{drives: [{}], steps: {}, case: c, report: [action]}}\n", drives, steps);
  return text;
}

}  // namespace kinestat::bench
