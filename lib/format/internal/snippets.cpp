#include "format/internal/snippets.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "format/internal/example_json.hpp"
#include "format/internal/json_types.hpp"

namespace kinestat {

Json snippet(std::string_view label, const Json& body, std::string_view meaning) {
  Json result = {{"label", std::string(label)}, {body.is_object() ? "body" : "bodyText", body}};
  if (!meaning.empty()) {
    result["description"] = std::string(meaning);
  }
  return result;
}

bool fits(const FormShape& shape, const Json& example) {
  const bool is_mapping = types_of(shape).dump().find("object") != std::string::npos;
  return is_collection(shape) ? (is_mapping ? example.is_object() : example.is_array())
                              : !example.is_object() && !example.is_array();
}

namespace {

// "${1:wind}:\n  body: …" would be long: the element stands behind its name in brackets.
Json named_snippet(const FormShape& shape, const Json& example) {
  std::string body = flow_snippet(example);
  body = body.substr(1, body.size() - 2);
  return snippet(shape.item, "${0:" + example.begin().key() + "}" + body.substr(body.find(':')));
}

// "{type: revolute, bodies: [${1:frame}, ${2:crank}]}" of each kind: the word is no placeholder.
// Behind a name in a mapping of names, with that name as the first.
Json worded_snippets(const FormShape& shape, std::string_view name = {}) {
  Json snippets = Json::array();
  for (std::size_t i = 0; i < shape.items.size(); ++i) {
    Json example = example_json(std::string(shape.items[i]->examples.front()));
    const std::string key = example.begin().key();
    example.erase(key);
    const std::string rest = flow_snippet(example);
    snippets.push_back(snippet(shape.words[i].text,
                               fmt::format("{}{{{}: {}, {}",
                                           name.empty() ? "" : fmt::format("${{0:{}}}: ", name),
                                           key,
                                           shape.words[i].text,
                                           rest.substr(1)),
                               shape.words[i].meaning));
  }
  return snippets;
}

// One of each number of components that there is an example of.
Json vector_snippets(const FormShape& shape, const Json& examples) {
  Json snippets = Json::array();
  for (const Space space : {Space::planar, Space::spatial}) {
    const std::size_t count = space == Space::planar ? 2 : 3;
    const auto at = std::ranges::find_if(
        examples, [&](const Json& one) { return fits(shape, one) && one.size() == count; });
    if (at != examples.end()) {
      snippets.push_back(snippet(sketch_of(shape, space), flow_snippet(*at)));
    }
  }
  return snippets;
}

// The first example, of a mapping all of them.
Json example_snippets(const FormShape& shape, const Json& examples) {
  Json snippets = Json::array();
  for (const Json& one : examples) {
    if (fits(shape, one) && (snippets.empty() || shape.kind == FormKind::mapping)) {
      snippets.push_back(snippet(shape.sketch.empty() ? outline(one) : std::string(shape.sketch),
                                 flow_snippet(one)));
    }
  }
  return snippets;
}

}  // namespace

Json snippets_of(const FormShape& shape, const Json& examples) {
  if (shape.kind == FormKind::by_word) {
    return worded_snippets(shape);
  }
  if (shape.kind == FormKind::variants) {
    Json snippets = Json::array();
    for (const FormShape& one : shape.items) {
      const Json example = example_json(std::string(one.examples.front()));
      snippets.push_back(snippet(outline(example), flow_snippet(example), one.meaning));
    }
    return snippets;
  }
  const auto at = std::ranges::find_if(examples, [&](const Json& one) { return fits(shape, one); });
  if (at == examples.end()) {
    return Json::array();
  }
  if (shape.kind == FormKind::names && shape.items.front()->kind == FormKind::by_word) {
    return worded_snippets(shape.items.front(), at->begin().key());
  }
  if (shape.kind == FormKind::names && !shape.item.empty()) {
    return Json::array({named_snippet(shape, *at)});
  }
  return shape.kind == FormKind::vector ? vector_snippets(shape, examples)
                                        : example_snippets(shape, examples);
}

}  // namespace kinestat
