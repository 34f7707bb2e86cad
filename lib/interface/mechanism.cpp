// Mechanisms: read, named, given other values.
#include <algorithm>
#include <kinestat.h>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/version.hpp"
#include "expression/parameters.hpp"
#include "interface/last_messages.hpp"
#include "interface/mechanism_handle.hpp"

namespace kinestat {

namespace {

// What a program hands over on purpose is no accident of the command line.
ReadLimits read_limits() {
  constexpr std::size_t kMostBytes = std::size_t{1} << 26U;
  return ReadLimits::for_size(kMostBytes);
}

void read_source(SourceFile source, kinestat_mechanism** mechanism, CallMessages& messages) {
  messages.source = source;
  std::optional<MechanismDescription> description =
      read_description(source, {.overrides = {}, .limits = read_limits()}, messages.found);
  const std::optional<Loaded> loaded =
      description ? bind_loaded(*description, messages.found) : std::nullopt;
  if (loaded) {
    *mechanism =
        std::make_unique<kinestat_mechanism>(kinestat_mechanism{.source = std::move(source),
                                                                .file = *description,
                                                                .overrides = {},
                                                                .description = *description,
                                                                .names = names_of(*loaded)})
            .release();
  }
}

// Whether an override is of that parameter.
bool sets(const Override& one, std::string_view parameter) {
  return one.size() > parameter.size() && one[parameter.size()] == '=' &&
         one.starts_with(parameter);
}

// Whether the value can be worked out.
void check_value(std::string_view parameter,
                 std::string_view value,
                 const MechanismDescription& description,
                 Diagnostics& found) {
  const std::vector<Parameter> parameters = parameters_of(description);
  for (const ParameterError& one : evaluate_parameters(parameters).errors) {
    if (!found.has_errors() &&
        parameters[static_cast<std::size_t>(one.parameter)].name == parameter) {
      found.error("E0102",
                  {},
                  fmt::format("{} cannot be '{}': {}", parameter, value, one.error.message),
                  one.error.hint);
    }
  }
}

void set_parameter(kinestat_mechanism& mechanism,
                   std::string_view parameter,
                   std::string_view value,
                   Diagnostics& found) {
  std::vector<Override> overrides = mechanism.overrides;
  std::erase_if(overrides, [&](const Override& one) { return sets(one, parameter); });
  overrides.push_back(fmt::format("{}={}", parameter, value));
  MechanismDescription description = mechanism.file;
  apply_overrides(overrides, description, found);
  check_value(parameter, value, description, found);
  if (!found.has_errors()) {
    mechanism.overrides = std::move(overrides);
    mechanism.description = std::move(description);
  }
}

const std::vector<std::string>* list_of(const FileNames& names, int which) {
  switch (which) {
    case KINESTAT_PARAMETERS:
      return &names.parameters;
    case KINESTAT_ACTUATORS:
      return &names.actuators;
    case KINESTAT_CASES:
      return &names.cases;
    default:
      return nullptr;
  }
}

}  // namespace

}  // namespace kinestat

const char* kinestat_version(void) {
  return kinestat::kVersion.data();  // a literal
}

int kinestat_read_file(const char* path, kinestat_mechanism** mechanism) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (!kinestat::is_given(path, "the path", messages.found) ||
        !kinestat::is_given(mechanism, "the place of the mechanism", messages.found)) {
      return;
    }
    messages.source.path = path;
    if (auto source = kinestat::read_file(path, kinestat::read_limits(), messages.found)) {
      kinestat::read_source(*std::move(source), mechanism, messages);
    }
  });
}

int kinestat_read_text(const char* text,
                       size_t length,
                       const char* name,
                       kinestat_mechanism** mechanism) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (kinestat::is_given(text, "the text", messages.found) &&
        kinestat::is_given(name, "the name of the text", messages.found) &&
        kinestat::is_given(mechanism, "the place of the mechanism", messages.found)) {
      kinestat::read_source({.path = name, .text = std::string(text, length)}, mechanism, messages);
    }
  });
}

void kinestat_free_mechanism(kinestat_mechanism* mechanism) {
  delete mechanism;
}

int kinestat_set(kinestat_mechanism* mechanism, const char* parameter, const char* value) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (kinestat::is_given(mechanism, "the mechanism", messages.found) &&
        kinestat::is_given(parameter, "the name of the parameter", messages.found) &&
        kinestat::is_given(value, "the value of the parameter", messages.found)) {
      messages.source = mechanism->source;
      kinestat::set_parameter(*mechanism, parameter, value, messages.found);
    }
  });
}

const char* kinestat_name(const kinestat_mechanism* mechanism, int names, size_t index) {
  const std::vector<std::string>* list =
      mechanism != nullptr ? kinestat::list_of(mechanism->names, names) : nullptr;
  return list != nullptr && index < list->size() ? (*list)[index].c_str() : nullptr;
}
