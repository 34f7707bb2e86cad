#include "report/motion_json.hpp"

namespace kinestat {

namespace {

Json column_json(const MotionColumn& column) {
  Json result = object_of(4);
  result["name"] = column.name();
  result["element"] = column.element;
  result["quantity"] = column.quantity;
  result["unit"] = column.unit;
  return result;
}

Json drives_json(const MotionTable& motion) {
  Json result = Json::array();
  for (const DriveTravel& drive : motion.drives) {
    Json entry = object_of(6);
    entry["name"] = drive.name;
    entry["freedom"] = drive.freedom;
    entry["from"] = number(drive.from);
    entry["to"] = number(drive.to);
    entry["reached"] = number(drive.reached);
    entry["unit"] = drive.unit;
    result.push_back(std::move(entry));
  }
  return result;
}

Json gaps_json(const std::vector<CouplingGap>& gaps) {
  Json result = object_of(gaps.size());
  for (const CouplingGap& gap : gaps) {
    Json entry = object_of(2);
    entry["distance"] = number(gap.distance);
    entry["angle"] = number(gap.angle);
    result[gap.coupling] = std::move(entry);
  }
  return result;
}

Json corrections_json(const std::vector<BodyCorrection>& corrections) {
  Json result = object_of(corrections.size());
  for (const BodyCorrection& one : corrections) {
    Json entry = object_of(2);
    entry["shift"] = vector(one.shift);
    entry["angle"] = number(one.angle);
    result[one.body] = std::move(entry);
  }
  return result;
}

Json rows_json(const MotionTable& motion) {
  Json result = Json::array();
  for (const MotionRow& row : motion.rows) {
    Json cells = Json::array({row.step});
    for (const std::optional<double>& value : row.values) {
      cells.push_back(number(value));
    }
    cells.push_back(row.status);
    result.push_back(std::move(cells));
  }
  return result;
}

Json events_json(const MotionTable& motion) {
  Json result = Json::array();
  for (const MotionEvent& event : motion.events) {
    Json entry = object_of(5);
    entry["kind"] = event.kind;
    entry["element"] = event.element;
    entry["step"] = event.step;
    entry["drive"] = Json::array();
    for (const double position : event.drive) {
      entry["drive"].push_back(number(position));
    }
    entry["uncertainty"] = number(event.uncertainty);
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

Json motion_json(const MotionTable& motion) {
  Json result = object_of(9);
  result["status"] = word_of(motion.end);
  result["case"] = motion.label.empty() ? Json(nullptr) : Json(motion.label);
  result["drives"] = drives_json(motion);
  result["steps"] = motion.steps;
  result["columns"] = Json::array({column_json({.element = "", .quantity = "step", .unit = ""})});
  for (const MotionColumn& column : motion.columns) {
    result["columns"].push_back(column_json(column));
  }
  result["columns"].push_back(column_json({.element = "", .quantity = "status", .unit = ""}));
  result["rows"] = rows_json(motion);
  result["events"] = events_json(motion);
  result["closure"] = motion.rows.empty() ? Json(nullptr)
                                          : Json{{"largest", number(motion.worst_closure)},
                                                 {"step", motion.worst_step}};
  result["assembly"] = {{"drawn_gaps", gaps_json(motion.drawn_gaps)},
                        {"corrections", corrections_json(motion.corrections)},
                        {"nearest_gaps", gaps_json(motion.nearest_gaps)}};
  return result;
}

}  // namespace kinestat
