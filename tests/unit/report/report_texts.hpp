// Small reports as text, for the tests of comparisons.
#pragma once

#include <string>

namespace kinestat {

/// A JSON report with the given units, and with more of its top level, which begins with a comma.
inline std::string json_report(const std::string& length,
                               const std::string& moment,
                               const std::string& more) {
  return R"({"kinestat": {"version": "0.1.0", "report": 1},
    "mechanism": {"name": "Crank", "file": "crank.yaml", "space": "planar", "units": {
      "length": ")" +
         length + R"(", "angle": "rad", "time": "s", "mass": "kg", "force": "N", "moment": ")" +
         moment + R"(", "velocity": ")" + length +
         R"(/s", "angular_velocity": "rad/s", "power": "W", "stiffness": "N/m"},
      "parameters": {}})" +
         more + "}";
}

/// The same in SI units.
inline std::string json_report(const std::string& more) {
  return json_report("m", "N*m", more);
}

/// A table with the given rows.
inline std::string csv_report(const std::string& rows) {
  return "mechanism,case,pass,element,quantity,value,unit,status\n" + rows;
}

}  // namespace kinestat
