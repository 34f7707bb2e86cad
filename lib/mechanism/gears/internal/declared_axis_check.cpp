#include <fmt/format.h>

#include "core/index.hpp"
#include "mechanism/gears/internal/gear_train_check.hpp"

namespace kinestat {

namespace {

// What an axis says of its bodies.
class DeclaredAxisCheck {
 public:
  DeclaredAxisCheck(const SectionContext& context, const GearTrain& train)
      : context_(context), axes_(context.description.gears->axes), train_(train) {}

  void run() {
    for (const GearAxisDescription& axis : axes_) {
      for (const Name& body : axis.bodies) {
        check_body(axis, body);
      }
      check_words(axis);
    }
  }

 private:
  void check_body(const GearAxisDescription& axis, const Name& body) {
    const Name& first = axis.bodies.front();
    if (train_.axis_on(body.text) == train_.axis_on(first.text)) {
      return;
    }
    context_.found.error(
        "E0314",
        body.where,
        fmt::format("axis '{}' is of '{}' and '{}', of which one is a planet of a carrier and the "
                    "other is not",
                    axis.name.text,
                    first.text,
                    body.text),
        "planets of one carrier turn about one axis, or what turns on the ground: write two axes");
  }

  void check_words(const GearAxisDescription& axis) {
    const int index = train_.axis_on(axis.bodies.front().text);
    if (index < 0 && axis.centre_distance) {
      context_.found.error(
          "E0314",
          axis.centre_distance->where,
          fmt::format("axis '{}' is the main axis and has no 'centre_distance'", axis.name.text),
          "the first of 'axes' is the main axis: write that first, or remove the distance");
    } else if (axis.side == PlanetSide::right &&
               (index < 0 || train_.axes[at(index)].neighbour < 0)) {
      context_.found.warning(
          "W0301",
          axis.name.where,
          fmt::format("'side' of axis '{}' is never used: it {}",
                      axis.name.text,
                      index < 0 ? "is the main axis" : "is on +y, as the first of its chain"),
          "write it for another axis, which meshes with the first, or remove it");
    }
  }

  const SectionContext& context_;
  const std::vector<GearAxisDescription>& axes_;
  const GearTrain& train_;
};

}  // namespace

std::string_view word_of(const GearAxis& axis, const SectionContext& context) {
  return axis.carrier == context.description.ground.text ? "gear" : "planet";
}

std::string name_of_axis(const GearTrain& train, int axis) {
  return axis < 0 ? "the main axis"
                  : fmt::format("the axis of '{}'", train.axes[at(axis)].bodies.front());
}

void check_declared_axes(const SectionContext& context, const GearTrain& train) {
  DeclaredAxisCheck(context, train).run();
}

}  // namespace kinestat
