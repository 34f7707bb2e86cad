// A record as JSON, as far as somebody looks at it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/json_archive.hpp"

namespace kinestat {

/// Keys of an object or names of a map, each with those below it.
struct WantedKeys {
  std::string key;  ///< empty: the whole
  std::vector<WantedKeys> below;

  /// Null if there is none.
  const WantedKeys* find(std::string_view name) const;

  /// Likewise, added if there is none.
  WantedKeys& with(std::string name);
};

/// The value of a key that is not wanted is null, objects by a name that is not wanted are empty,
/// and lists are whole.
class PartialArchive : public JsonArchive {
 public:
  PartialArchive(const FileUnits& units, const WantedKeys& wanted)
      : JsonArchive(units, JsonLayout::line), within_{&wanted} {}

  bool begin(const Property& property) override;
  void end(const Property& property) override;
  void element(std::string_view name, std::string_view status) override;
  void begin_map() override;
  void end_map() override;
  void begin_list() override;
  void end_list() override;

 private:
  const WantedKeys* wanted_below(const WantedKeys* keys, std::string_view name) const;

  WantedKeys all_;                         // stands for all keys there are
  std::vector<const WantedKeys*> within_;  // of all that is open; null: nothing
};

}  // namespace kinestat
