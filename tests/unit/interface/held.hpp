// Handles of the C interface that free themselves.
#pragma once

#include <kinestat.h>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace kinestat::interface_test {

struct Free {
  void operator()(kinestat_mechanism* handle) const { kinestat_free_mechanism(handle); }

  void operator()(kinestat_report* handle) const { kinestat_free_report(handle); }

  void operator()(kinestat_tape* handle) const { kinestat_free_tape(handle); }
};

using Mechanism = std::unique_ptr<kinestat_mechanism, Free>;
using Report = std::unique_ptr<kinestat_report, Free>;
using Tape = std::unique_ptr<kinestat_tape, Free>;

inline const std::string kRavigneaux = KINESTAT_MECHANISMS "/transmissions/ravigneaux.yaml";
inline const std::string kPlanetary = KINESTAT_STARTERS "/planetary.yaml";

/// Null where there is none.
inline Mechanism read(const std::string& path) {
  kinestat_mechanism* handle = nullptr;
  kinestat_read_file(path.c_str(), &handle);
  return Mechanism(handle);
}

inline Mechanism parse(const std::string& text) {
  kinestat_mechanism* handle = nullptr;
  kinestat_read_text(text.data(), text.size(), "text", &handle);
  return Mechanism(handle);
}

inline Report analyze(const Mechanism& mechanism) {
  kinestat_report* handle = nullptr;
  kinestat_analyze(mechanism.get(), &handle);
  return Report(handle);
}

inline double number(const Report& report, const std::string& pointer) {
  double result = 0.0;
  EXPECT_EQ(kinestat_number(report.get(), pointer.c_str(), &result), KINESTAT_DONE) << pointer;
  return result;
}

/// Of the last call; one without a place where there is none.
inline kinestat_message message(std::size_t index = 0) {
  kinestat_message result = {};
  kinestat_message_at(index, &result);
  return result;
}

}  // namespace kinestat::interface_test
