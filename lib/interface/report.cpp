// Reports: made, and read by places.
#include <kinestat.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interface/last_messages.hpp"
#include "interface/mechanism_handle.hpp"
#include "report/json_pointer.hpp"
#include "run/analyse.hpp"

struct kinestat_report {
  std::string text;
  kinestat::Json values;
};

namespace kinestat {

namespace {

void analyse(const kinestat_mechanism& mechanism, kinestat_report** report, Diagnostics& found) {
  std::optional<FileReport> made = analyse_description(mechanism.source.path,
                                                       mechanism.description,
                                                       {.accuracy = Accuracy::automatic},
                                                       {.json = true},
                                                       found);
  if (made) {
    auto handle = std::make_unique<kinestat_report>();
    handle->values = Json::parse(made->json);
    handle->text = std::move(made->json);
    *report = handle.release();
  }
}

void read_number(const Json& report, const char* pointer, double* number, Diagnostics& found) {
  const PointerTarget target = follow_pointer(report, pointer);
  if (target.value == nullptr) {
    refuse_argument(target.problem, target.hint, found);
  } else if (target.value->is_number()) {
    *number = target.value->get<double>();
  } else if (target.value->is_null()) {
    *number = std::numeric_limits<double>::quiet_NaN();
  } else if (target.value->is_boolean()) {
    *number = target.value->get<bool>() ? 1.0 : 0.0;
  } else {
    refuse_argument(fmt::format("'{}' is {}, not a number", pointer, kind_of_json(*target.value)),
                    "let the pointer lead to a single number of the report",
                    found);
  }
}

}  // namespace

}  // namespace kinestat

int kinestat_analyze(const kinestat_mechanism* mechanism, kinestat_report** report) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (kinestat::is_given(mechanism, "the mechanism", messages.found) &&
        kinestat::is_given(report, "the place of the report", messages.found)) {
      messages.source = mechanism->source;
      kinestat::analyse(*mechanism, report, messages.found);
    }
  });
}

void kinestat_free_report(kinestat_report* report) {
  delete report;
}

const char* kinestat_json(const kinestat_report* report) {
  return report != nullptr ? report->text.c_str() : nullptr;
}

int kinestat_number(const kinestat_report* report, const char* pointer, double* number) {
  return kinestat::answer_call([&](kinestat::CallMessages& messages) {
    if (kinestat::is_given(report, "the report", messages.found) &&
        kinestat::is_given(pointer, "the pointer", messages.found) &&
        kinestat::is_given(number, "the place of the number", messages.found)) {
      kinestat::read_number(report->values, pointer, number, messages.found);
    }
  });
}
