// What a value of the file may look like, as data: the schema, hints and snippets follow from it.
// All texts are literals; a declaration does not copy them.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/coupling_description.hpp"
#include "description/number_range.hpp"
#include "forms/lazy.hpp"
#include "forms/shared_list.hpp"

namespace kinestat {

enum class FormKind {
  number,    ///< or an expression
  name,      ///< of something that the file declares
  text,      ///< free text, which may look like a number
  literal,   ///< a text of a form of its own: a unit, a place of a report
  constant,  ///< `sketch` and nothing else
  word,      ///< one of `words`
  flag,      ///< true or false
  vector,    ///< of `items.front()`: as many components as the space has
  couple,    ///< of `items.front()`: one number about z in the plane, a vector in space
  list,      ///< of `items.front()`
  names,     ///< a mapping from names to `items.front()`
  mapping,   ///< with `keys`
  variants,  ///< one of the mappings `items`, each with a first key of its own
  by_word,   ///< one of the mappings `items`, by which of `words` stands behind their first key
  by_shape   ///< one of `items`, which differ in being a list, a mapping or a single value
};

struct Word {
  std::string_view text = {};
  std::string_view meaning = {};
};

/// Names of which a mapping of names may not consist, and what to write instead.
struct ForeignNames {
  SharedList<std::string_view> names = {};
  std::string_view instead = {};
};

/// How several keys of a mapping, or of the items of a list, belong together. In texts {} stands
/// for the mapping. A rule without a message is for the schema: who reads on complains himself.
struct FormRule {
  enum class Kind {
    instead,              ///< `key` stands instead of `others`
    any_of,               ///< at least one of `others`
    one_of,               ///< exactly one of `others`
    needed_beside,        ///< `key`, where `others.front()` stands and none of the rest
    needed_by_part,       ///< `key`, where one of the rest of `others` stands in `others.front()`
    needed_unless_whole,  ///< `key`, unless the bare number behind `others.front()` is whole
    spares,               ///< beside `key`, none of `others` is needed
    unless_true,          ///< where `key` is true, `others` may not stand; {1} is the one that does
    together,             ///< `key` needs `others.front()` beside it
    pointless,            ///< `key` means nothing without `others.front()`
    excludes,             ///< beside `key`, none of `others` may stand
    needs_true,           ///< where `key` is true, `others.front()` must be, too
    alone,                ///< `others` are needed, unless `key` stands without any of them
    all_or_none,          ///< of a list: `key` stands in all items or in none
    instead_of_any        ///< the path `key`, "a/b/c", is needed unless one of the paths `others`
  };

  Kind kind = Kind::instead;
  std::string_view key = {};
  SharedList<std::string_view> others = {};
  std::string_view message = {};
  std::string_view hint = {};
};

struct FormKey;

struct FormShape {
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  FormKind kind = FormKind::text;
  std::string_view definition = {};  ///< its name in the schema; empty: written where it stands
  std::string_view meaning = {};     ///< a sentence
  SharedList<std::string_view> examples = {};  ///< as in a file
  std::string_view sketch = {};                ///< "NAME", in hints; empty: follows from the rest
  std::string_view remark = {};                ///< behind the sketch: "an actuator"
  NumberRange range = {};                      ///< of a bare number, in whatever unit
  std::string_view pattern = {};               ///< of a text, as a regular expression
  std::string_view pattern_text = {};          ///< a sentence: what fits it
  SharedList<Word> words = {};                 ///< of a number: what may stand instead of it
  std::string_view item = {};                  ///< what an item is: "a load"
  std::string_view elements = {};              ///< of `names`: "meshes to losses"
  std::string_view name_definition = {};       ///< of `names`: the schema of the names
  ForeignNames foreign = {};                   ///< of `names`
  bool may_be_empty = false;                   ///< of a mapping: nothing may stand behind its key
  std::size_t least = 0;                       ///< how many items
  std::size_t most = kAnyNumber;
  SharedList<Lazy<FormShape>> items = {};
  SharedList<FormKey> keys = {};
  SharedList<FormKey> beginnings = {};  ///< of keys that the user makes up: "x-"
  SharedList<FormRule> rules = {};
};

/// A value that an editor offers.
struct Suggestion {
  std::string_view value = {};
  std::string_view meaning = {};
};

/// What is said where a key is missing.
struct Absence {
  std::string_view code = {};
  std::string_view message = {};
};

struct FormKey {
  std::string_view key = {};
  std::string_view meaning = {};  ///< a sentence
  bool is_needed = false;
  Lazy<FormShape> shape = {};
  SharedList<std::string_view> examples = {};  ///< as in a file
  std::string_view usual = {};                 ///< what holds without the key; empty: nothing does
  std::string_view missing = {};               ///< what to add; empty: follows from the shape
  Absence absence = {};                        ///< of a needed key; empty: as of every other
  SharedList<Suggestion> suggestions = {};
};

/// The form in a few characters: "[x, y]", "NAME", "{body: NAME, at: [x, y]}".
std::string sketch_of(const FormShape& shape, Space space);

/// Whether it is a mapping with keys, perhaps with those that a word chooses.
bool is_mapping(const FormShape& shape);

/// Whether points or vectors are part of it, so that it cannot be read while the space is unknown.
bool depends_on_space(const FormShape& shape);

}  // namespace kinestat
