#include "io/published_reader.hpp"

#include <cmath>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

bool is_whole(double value) {
  return std::floor(value) == value;
}

// A whole number without a tolerance is met exactly: counts are. Of others the source prints some
// digits only.
double read_tolerance(Fields& fields, bool may_lack, Diagnostics& found) {
  const YamlNode* node = may_lack ? fields.find("tolerance") : fields.require("tolerance");
  if (node == nullptr) {
    return 0.0;
  }
  const double tolerance = read_number(*node, "a tolerance", found).value_or(0.0);
  if (tolerance < 0.0) {
    found.error("E0305", node->where, "a tolerance cannot be negative");
  }
  return tolerance;
}

std::optional<PublishedValue> read_one(const YamlNode& node, Diagnostics& found) {
  PublishedValue result;
  const int errors_before = found.error_count();
  Fields fields(node, node.where, "a published value", found);
  if (const YamlNode* value = fields.require("value")) {
    result.pointer = read_reference(*value, "the pointer", found).value_or(Name{});
  }
  if (const YamlNode* is = fields.require("is")) {
    result.is_where = is->where;
    result.is = read_number(*is, "a published value", found).value_or(0.0);
  }
  result.tolerance = read_tolerance(fields, is_whole(result.is), found);
  if (const YamlNode* where = fields.find("where")) {
    result.where = read_text(*where, "'where'", found).value_or("");
  }
  if (const YamlNode* printed = fields.find("printed")) {
    (void)read_number(*printed, "the printed value", found);
  }
  if (const YamlNode* erratum = fields.find("erratum")) {
    (void)read_text(*erratum, "the erratum", found);
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

std::vector<PublishedValue> read_published(const YamlNode& node, Diagnostics& found) {
  std::vector<PublishedValue> values;
  if (node.kind != YamlKind::sequence) {
    found.error("E0304",
                node.where,
                "'published' must be a list",
                "begin each value with '- {value: /…, is: …, tolerance: …}'");
    return values;
  }
  for (const YamlNode& item : node.items) {
    if (auto value = read_one(item, found)) {
      values.push_back(*std::move(value));
    }
  }
  return values;
}

}  // namespace kinestat
