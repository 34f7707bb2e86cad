// One mapping of the file while it is read: which keys it may have, and what is wrong with it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "io/title.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Every key that is asked for counts as known; finish() complains about all others, and about
/// required ones that are missing, unless an unknown key is a misspelling of one. Keys and
/// texts stay where they are, since without errors nothing needs them: they must outlive it.
class Fields {
 public:
  /// `what` names the mapping in messages: "coupling 'a'". `where` is where a missing key is
  /// reported. A node that is no mapping is an error; the fields are then empty.
  /// `only` is the one key that it cannot do without, if that has a name as its value: what a name
  /// in place of the mapping is meant for.
  Fields(const YamlNode& node,
         SourceRange where,
         const Title& what,
         Diagnostics& found,
         std::string_view only = {});

  /// The value of the key, or null if it is absent.
  const YamlNode* find(std::string_view key);

  /// Likewise, but absence is an error of finish(), whose hint says what to add: "'at: [x, y]'".
  const YamlNode* require(std::string_view key, std::string what_to_add);

  /// An error of finish(), likewise, of a key that is known and absent.
  void lacks(std::string_view key, std::string what_to_add);

  bool lacks_any() const { return !missing_.empty(); }

  /// Lets keys that begin so stand without being listed among the known ones.
  void ignore_prefix(std::string_view prefix);

  /// Says everything that is wrong with the keys. To be called once, after all have been asked for.
  void finish();

 private:
  struct Missing {
    std::string key;
    std::string what_to_add;
  };

  void refuse(std::size_t index);
  bool refuse_joined(const YamlEntry& entry, const std::vector<std::string>& known);

  const YamlNode* node_ = nullptr;
  SourceRange where_;
  Title what_;
  Diagnostics& found_;
  std::vector<std::string_view> known_;
  std::string_view ignored_prefix_;  ///< empty: none
  std::vector<Missing> missing_;
};

}  // namespace kinestat
