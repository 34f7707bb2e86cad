#include "pages/spatial_scene.hpp"

#include <array>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "couplings/kinds.hpp"
#include "draw/linkage/linkage_canvas.hpp"
#include "draw/linkage/linkage_parts.hpp"

namespace kinestat {

namespace {

std::string numbers(std::span<const Vec3> vectors) {
  std::vector<std::string> texts;
  for (const Vec3& one : vectors) {
    texts.push_back(fmt::format("{:.5g},{:.5g},{:.5g}", one.x(), one.y(), one.z()));
  }
  return fmt::format("[{}]", fmt::join(texts, ","));
}

std::string list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ","));
}

std::string_view word_of(SpaceSymbol symbol) {
  constexpr std::array<std::string_view, 8> kWords = {
      "square", "hinge", "sleeve", "box", "cross", "ball", "plate", "touching plate"};
  return kWords.at(static_cast<std::size_t>(symbol));
}

class SceneWriter {
 public:
  explicit SceneWriter(const Analysis& analysis)
      : analysis_(analysis), topology_(analysis.mechanism.topology) {}

  std::string json(const std::vector<LinkagePosition>& positions,
                   const std::vector<TracedPath>& paths) const {
    std::vector<std::string> steps;
    for (const LinkagePosition& position : positions) {
      steps.push_back(step_json(position.geometry, position.poses));
    }
    if (steps.empty()) {
      steps.push_back(step_json(analysis_.mechanism.geometry, {}));
    }
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      lines.push_back(fmt::format(
          R"({{"ink":"{}","points":{}}})", ink_name(path_ink(i)), numbers(paths[i].points)));
    }
    return fmt::format(R"({{"bodies":{},"couplings":{},"paths":{},"steps":[{}]}})",
                       list(bodies()),
                       list(couplings()),
                       list(lines),
                       fmt::join(steps, ",\n"));
  }

 private:
  std::vector<std::string> bodies() const {
    std::vector<std::string> items;
    for (int b = 0; b < topology_.body_count(); ++b) {
      items.push_back(fmt::format(R"({{"name":{},"ink":"{}"}})",
                                  script_string(topology_.body(BodyId{b}).name),
                                  ink_name(body_ink(BodyId{b}))));
    }
    return items;
  }

  std::vector<std::string> couplings() const {
    std::vector<std::string> items;
    for (const CouplingTopology& one : topology_.couplings) {
      items.push_back(fmt::format(R"({{"name":{},"symbol":"{}"}})",
                                  script_string(one.name),
                                  word_of(kind_of(one.type).space_symbol)));
    }
    return items;
  }

  bool is_drawn(const CouplingTopology& one, const LinkageParts& parts) const {
    const auto is_virtual = [&](BodyId body) {
      return parts.is_virtual[static_cast<std::size_t>(body.value)];
    };
    return one.type != CouplingType::cable && one.type != CouplingType::gear &&
           !is_virtual(one.tail) && !is_virtual(one.head);
  }

  // The place, then the axes of its freedoms; null without a symbol.
  std::string coupling_json(std::size_t e,
                            const Geometry& geometry,
                            const LinkageParts& parts) const {
    const CouplingTopology& one = topology_.couplings[e];
    if (!is_drawn(one, parts)) {
      return "null";
    }
    std::vector<Vec3> vectors = {geometry.points[e]};
    for (int f = one.first_freedom; f < one.first_freedom + one.freedom_count; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const auto& unit = geometry.motions[i];
      vectors.push_back(topology_.freedoms[i].is_rotation ? unit.angular : unit.linear);
    }
    return numbers(vectors);
  }

  std::string step_json(const Geometry& geometry, std::span<const BodyPose> poses) const {
    const LinkageParts parts =
        find_linkage_parts(analysis_.description, analysis_.mechanism, poses);
    std::vector<std::string> bodies;
    for (const std::vector<BodyPoint>& of_body : parts.points) {
      std::vector<Vec3> points;
      for (const BodyPoint& point : of_body) {
        points.push_back(point.at);
      }
      bodies.push_back(numbers(points));
    }
    std::vector<std::string> couplings;
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      couplings.push_back(coupling_json(e, geometry, parts));
    }
    std::vector<std::string> wheels;
    for (const Wheel& wheel : parts.wheels) {
      const std::array<Vec3, 2> placed = {wheel.centre, wheel.axis};
      wheels.push_back(fmt::format(R"({{"body":{},"radius":{:.5g},"at":{}}})",
                                   wheel.body.value,
                                   wheel.radius,
                                   numbers(placed)));
    }
    std::vector<std::string> spans;
    for (const CableLine& span : parts.spans) {
      const std::array<Vec3, 2> ends = {span.from, span.to};
      spans.push_back(numbers(ends));
    }
    return fmt::format(R"({{"bodies":{},"couplings":{},"wheels":{},"cables":{}}})",
                       list(bodies),
                       list(couplings),
                       list(wheels),
                       list(spans));
  }

  const Analysis& analysis_;
  const Topology& topology_;
};

}  // namespace

void add_spatial_scene(const Analysis& analysis,
                       const std::vector<LinkagePosition>& positions,
                       const std::vector<TracedPath>& paths,
                       const std::string& id,
                       Html& html) {
  html.open("script", {{"type", "application/json"}, {"id", id}});
  html.markup(script_json(SceneWriter(analysis).json(positions, paths)));
  html.close();
}

}  // namespace kinestat
