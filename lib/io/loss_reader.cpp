#include "io/loss_reader.hpp"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

struct FormKey {
  std::string_view key;
  LossForm form = LossForm::fraction;
};

constexpr auto kLossForms = std::to_array<FormKey>(
    {{"loss", LossForm::fraction}, {"eta", LossForm::efficiency}, {"k", LossForm::teeth}});

// 0.02, {loss: 0.02}, {eta: 0.98} or {k: 0.23}.
std::optional<LossValue> read_loss(const YamlNode& node,
                                   const std::string& what,
                                   Diagnostics& found) {
  const int errors_before = found.error_count();
  LossValue loss;
  if (node.kind != YamlKind::mapping) {
    loss.value = read_value(node, what, found).value_or(Value{});
    return found.error_count() == errors_before ? std::optional(std::move(loss)) : std::nullopt;
  }
  Fields fields(node, node.where, what, found);
  int count = 0;
  for (const FormKey& row : kLossForms) {
    if (const auto value = find_value(fields, row.key, found)) {
      loss = {.form = row.form, .value = *value};
    }
    count += node.find(row.key) != nullptr ? 1 : 0;
  }
  fields.finish();
  if (found.error_count() == errors_before && count != 1) {
    found.error(count == 0 ? "E0303" : "E0302",
                node.where,
                fmt::format("{} needs one of 'loss', 'eta' and 'k'", what),
                "write the share that is lost, 0.02; or {eta: 0.98}; or {k: 0.23} for "
                "eta = 1 - k (1/z1 + 1/z2)");
  }
  return found.error_count() == errors_before ? std::optional(std::move(loss)) : std::nullopt;
}

std::optional<LossValue> find_loss(Fields& fields, std::string_view key, Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  return node == nullptr ? std::nullopt
                         : read_loss(*node, fmt::format("'{}' of 'losses'", key), found);
}

std::vector<MeshLoss> read_mesh_losses(const YamlNode& node, Diagnostics& found) {
  std::vector<MeshLoss> losses;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                "'meshes' of 'losses' must be a mapping of meshes to losses",
                "write for example meshes: {h: 0.015}");
    return losses;
  }
  for (const YamlEntry& entry : node.entries) {
    const std::string what = fmt::format("the loss of mesh '{}'", entry.key);
    if (auto loss = read_loss(entry.value, what, found)) {
      losses.push_back(
          {.coupling = {.text = entry.key, .where = entry.key_where}, .loss = *std::move(loss)});
    }
  }
  return losses;
}

}  // namespace

std::optional<LossDescription> read_losses(const YamlNode& node, Diagnostics& found) {
  static const std::vector<std::string> kModels = {"carrier", "absolute"};
  const int errors_before = found.error_count();
  LossDescription losses;
  losses.where = node.where;
  Fields fields(node, node.where, "'losses'", found);
  const bool is_absolute = find_word(fields, "model", kModels, found) == std::size_t{1};
  losses.model = is_absolute ? LossModel::absolute : LossModel::carrier;
  losses.gear_external = find_loss(fields, "gear_external", found);
  losses.gear_internal = find_loss(fields, "gear_internal", found);
  if (const YamlNode* meshes = fields.find("meshes")) {
    losses.meshes = read_mesh_losses(*meshes, found);
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(losses)) : std::nullopt;
}

}  // namespace kinestat
