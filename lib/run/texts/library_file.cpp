#include "run/texts/library_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"
#include "run/texts/new_file.hpp"

namespace kinestat {

namespace {

std::string_view title_of(std::string_view text) {
  constexpr std::string_view kKey = "\nname: ";
  const std::size_t at = text.find(kKey);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = text.substr(at + kKey.size());
  return rest.substr(0, rest.find('\n'));
}

std::string_view folder_of(std::string_view name) {
  return name.substr(0, name.find('/'));
}

std::string_view file_of(std::string_view name) {
  return name.substr(name.find('/') + 1);
}

std::vector<std::string> folders() {
  std::vector<std::string> names;
  for (const EmbeddedText& one : embedded_library()) {
    if (names.empty() || names.back() != folder_of(one.name)) {
      names.emplace_back(folder_of(one.name));
    }
  }
  return names;
}

// Of all folders where none is given.
std::string list_of(std::string_view folder) {
  std::vector<LibraryFile> shown = library_files();
  std::erase_if(shown, [folder](const LibraryFile& one) {
    return !folder.empty() && folder_of(one.name) != folder;
  });
  std::size_t width = 0;
  for (const LibraryFile& one : shown) {
    width = std::max(width, one.name.size());
  }
  std::string text;
  for (const LibraryFile& one : shown) {
    text += page_lines(fmt::format("  {:<{}}  ", one.name, width), one.title, width + 4);
  }
  return text +
         "\n'kinestat examples NAME' shows a file, 'kinestat examples NAME FILE' writes it.\n";
}

// As they are called here: "four-bar.yaml" is four_bar.
std::string plain_name(std::string name) {
  if (name.ends_with(".yaml")) {
    name.resize(name.size() - std::string_view(".yaml").size());
  }
  std::ranges::replace(name, '-', '_');
  return name;
}

std::vector<const EmbeddedText*> files_called(std::string_view name) {
  std::vector<const EmbeddedText*> called;
  for (const EmbeddedText& one : embedded_library()) {
    if (one.name == name || file_of(one.name) == name) {
      called.push_back(&one);
    }
  }
  return called;
}

std::string beside_its_schema(std::string_view text) {
  constexpr std::string_view kAbove = "../../schemas/";
  std::string result(text);
  const std::size_t at = result.find(kAbove);
  if (at < result.find('\n')) {
    result.erase(at, kAbove.size());
  }
  return result;
}

void refuse_name(const std::string& name, Outcome& outcome) {
  std::vector<std::string> names = folders();
  for (const EmbeddedText& one : embedded_library()) {
    names.emplace_back(file_of(one.name));
  }
  for (const EmbeddedText& one : embedded_library()) {
    names.emplace_back(one.name);
  }
  add_message(
      "E0101",
      fmt::format("there is no example '{}'", printable(name)),
      guess_before(plain_name(name), names, "'kinestat examples' lists all, with a line each"),
      outcome);
}

void refuse_two(const std::vector<const EmbeddedText*>& called,
                const std::string& name,
                Outcome& outcome) {
  std::vector<std::string> names;
  for (const EmbeddedText* one : called) {
    names.emplace_back(one->name);
  }
  add_message("E0101",
              fmt::format("there are {} examples '{}'", called.size(), printable(name)),
              "write one of " + plain_list(names),
              outcome);
}

}  // namespace

std::vector<LibraryFile> library_files() {
  std::vector<LibraryFile> files;
  for (const EmbeddedText& one : embedded_library()) {
    files.push_back({.name = one.name, .title = title_of(one.text)});
  }
  return files;
}

Outcome library_file(const std::string& name, const std::string& path, Overwrite overwrite) {
  Outcome outcome;
  const std::vector<std::string> all = folders();
  const bool is_folder = std::ranges::find(all, name) != all.end();
  if (name.empty() || (is_folder && path.empty())) {
    outcome.out = list_of(name);
    return outcome;
  }
  const std::vector<const EmbeddedText*> called = files_called(plain_name(name));
  if (called.empty()) {
    refuse_name(name, outcome);
  } else if (called.size() > 1) {
    refuse_two(called, name, outcome);
  } else {
    give_mechanism_file(beside_its_schema(called.front()->text), path, overwrite, outcome);
  }
  return outcome;
}

}  // namespace kinestat
