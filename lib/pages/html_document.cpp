#include "pages/html_document.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "core/sha256.hpp"
#include "core/version.hpp"
#include "draw/palette.hpp"
#include "draw/picture.hpp"
#include "pages/embedded.hpp"
#include "pages/page_parts.hpp"

namespace kinestat {

namespace {

using Headings = std::vector<PageHeading>;

constexpr std::string_view kBegin = "<!doctype html>\n<!-- A report of kinestat. -->\n";

std::string report_title(std::span<const FilePage> pages) {
  return pages.size() == 1 ? page_title(pages.front()) : fmt::format("{} mechanisms", pages.size());
}

void add_head(const std::string& title, const std::string& script, Html& html) {
  const std::string style = page_style();
  html.open("head");
  html.single("meta", {{"charset", "utf-8"}});
  html.single(
      "meta",
      {{"http-equiv", "Content-Security-Policy"}, {"content", content_policy(style, script)}});
  html.single("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  html.single("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  html.single("meta", {{"name", "generator"}, {"content", fmt::format("kinestat {}", kVersion)}});
  // Without it a browser may ask a server for one.
  html.single("link", {{"rel", "icon"}, {"href", "data:,"}});
  html.element("title", title);
  html.open("style");
  html.markup(style);
  html.close();
  html.close();
}

void add_theme_choice(Html& html) {
  html.open("p", {{"class", "theme script"}, {"hidden", ""}});
  html.element("label", "Colours ", {{"for", "theme"}});
  html.open("select", {{"id", "theme"}});
  html.open("option", {{"value", "auto"}});
  html.text("system");
  html.close();
  html.element("option", "light", {{"value", "light"}});
  html.element("option", "dark", {{"value", "dark"}});
  html.close();
  html.close();
}

void add_links(const Headings& headings, Html& html) {
  html.open("ol");
  for (const PageHeading& one : headings) {
    html.open("li");
    html.element("a", one.title, {{"href", "#" + one.id}});
    html.close();
  }
  html.close();
}

void add_contents(const std::vector<Headings>& files, Html& html) {
  html.open("nav", {{"aria-label", "Contents"}, {"class", files.size() == 1 ? "one" : "many"}});
  if (files.size() == 1) {
    add_links({files.front().begin() + 1, files.front().end()}, html);
  } else {
    html.open("ol");
    for (const Headings& file : files) {
      html.open("li", {{"class", "file"}});
      html.element("a", file.front().title, {{"href", "#" + file.front().id}});
      add_links({file.begin() + 1, file.end()}, html);
      html.close();
    }
    html.close();
  }
  html.close();
}

}  // namespace

std::string_view html_signature() {
  return kBegin;
}

std::string html_report(std::span<const FilePage> pages) {
  Html sections;
  std::vector<Headings> headings;
  const PageForm form = pages.size() == 1 ? PageForm::one_file : PageForm::many_files;
  int figures = 0;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::string id = fmt::format("file-{}", i + 1);
    Headings of_file = {{.id = id, .title = page_title(pages[i])}};
    for (PageHeading& one : add_file_section(pages[i], id, form, figures, sections)) {
      of_file.push_back(std::move(one));
    }
    headings.push_back(std::move(of_file));
  }
  const std::string title = report_title(pages);
  const std::string script = page_script(sections.html());
  Html html;
  html.markup(kBegin);
  html.open("html", {{"lang", "en"}});
  add_head(title, script, html);
  html.open("body");
  html.element("a", "Skip to the report", {{"class", "skip"}, {"href", "#report"}});
  html.open("header");
  html.open("div", {{"class", "head"}});
  html.open("div");
  html.element("h1", title);
  html.element(
      "p",
      fmt::format("Kinematics, statics and power flow by Davies' method, kinestat {}", kVersion),
      {{"class", "made"}});
  html.close();
  add_theme_choice(html);
  html.close();
  add_contents(headings, html);
  html.close();
  html.open("main", {{"id", "report"}});
  html.markup(sections.html());
  html.close();
  html.open("script");
  html.markup(script);
  html.close();
  html.close();
  html.close();
  return html.html();
}

namespace {

std::string source_of(std::string_view text) {
  return fmt::format("'sha256-{}'", base64(sha256(text)));
}

// Parts of the script that work on some pages alone, and what marks these.
struct WorksOn {
  std::string_view part;
  std::string_view mark;
};

constexpr auto kWorksOn = std::to_array<WorksOn>(
    {{"charts", " data-chart="}, {"turning", "-scene\""}, {"motion", " data-poses="}});

// Without comments and what lines are set in by, which readers of a page have no use for.
std::string packed_script(std::string_view source) {
  std::string text;
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size());
    std::string_view line = source.substr(0, end);
    source.remove_prefix(std::min(end + 1, source.size()));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty() && !line.starts_with("//")) {
      text.append(line) += '\n';
    }
  }
  return text;
}

std::string packed_style(std::string_view source) {
  std::string text;
  while (!source.empty()) {
    const std::size_t begin = std::min(source.find("/*"), source.size());
    text.append(source.substr(0, begin));
    const std::size_t end = source.find("*/", begin);
    source.remove_prefix(end == std::string_view::npos ? source.size() : end + 2);
  }
  return packed_script(text);
}

}  // namespace

std::string page_style() {
  // Paper is light, whatever the reader prefers on a screen.
  return fmt::format(
      ":root{{{0}}}\n"
      "@media screen and (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{1}}}}}\n"
      "@media screen{{:root[data-theme=dark]{{{1}}}}}\n{2}{3}\n{4}",
      light_variables(),
      dark_variables(),
      ink_rules(),
      kPictureRules,
      packed_style(embedded_style().front().text));
}

std::string page_script(std::string_view content) {
  std::string script;
  for (const EmbeddedText& part : embedded_scripts()) {
    const auto* const row = std::ranges::find(kWorksOn, part.name, &WorksOn::part);
    if (row == kWorksOn.end() ||
        memmem(content.data(), content.size(), row->mark.data(), row->mark.size()) != nullptr) {
      script += packed_script(part.text);
    }
  }
  return script;
}

std::string content_policy(std::string_view style, std::string_view script) {
  return fmt::format(
      "default-src 'none'; style-src {}; script-src {}; img-src data:; base-uri 'none'; "
      "form-action 'none'",
      source_of(style),
      source_of(script));
}

}  // namespace kinestat
