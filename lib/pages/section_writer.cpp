#include "pages/section_writer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "pages/chart_figure.hpp"
#include "pages/figures.hpp"
#include "pages/tables.hpp"

namespace kinestat {

namespace {

// Of the frame of a chart [px]: with the words at its axes it fits a telephone, so that one drawing
// serves every screen, and three stand beside each other on a wide one.
constexpr double kChartWidth = 300.0;

// What it shows; where others of the figure show the same, also of what.
std::string shown_in(const Chart& chart, const Figure& figure) {
  constexpr std::size_t kMostNames = 3;
  const std::string shown = chart.title.empty() ? chart.y.label : chart.title;
  const auto is_same = [&](const Chart& other) {
    return other.title == chart.title && other.y.label == chart.y.label;
  };
  if (std::ranges::count_if(figure.charts, is_same) < 2) {
    return shown;
  }
  std::vector<std::string> names;
  for (const Series& one : chart.series) {
    names.push_back(one.name);
  }
  return fmt::format("{} of {}", shown, plain_list(names, kMostNames));
}

// How high blocks stand on a page [px]: tables side by side.
double height_of(const TextBlocks& blocks) {
  constexpr double kRow = 23.0;
  std::size_t most = 0;
  for (const TextBlock& one : blocks.blocks()) {
    most = std::max(most, one.table ? one.table->rows().size() + 1 : 1);
  }
  return kRow * static_cast<double>(most);
}

double height_of(const Picture& picture) {
  constexpr double kCaption = 40.0;
  return picture.view.height() + kCaption;
}

// Of pictures, narrow ones first, how many stand beside the blocks in a column, so that with the
// others below, two in a row, the whole is as low as can be.
std::size_t count_beside(const std::vector<Picture>& pictures, const TextBlocks& blocks) {
  double least = std::numeric_limits<double>::infinity();
  double column = 0.0;
  std::size_t best = 0;
  for (std::size_t beside = 0; beside <= pictures.size(); ++beside) {
    double height = std::max(height_of(blocks), column);
    for (std::size_t i = beside; i < pictures.size(); ++i) {
      const bool is_first =
          !is_broad(pictures[i]) && i + 1 < pictures.size() && !is_broad(pictures[i + 1]);
      height += is_first ? std::max(height_of(pictures[i]), height_of(pictures[i + 1]))
                         : height_of(pictures[i]);
      i += is_first ? 1 : 0;
    }
    if (height < least) {
      least = height;
      best = beside;
    }
    if (beside < pictures.size()) {
      if (is_broad(pictures[beside])) {
        break;
      }
      column += height_of(pictures[beside]);
    }
  }
  return best;
}

}  // namespace

SectionWriter::SectionWriter(
    const FilePage& page, std::string id, PageForm form, int& figures, Html& html)
    : page_(page), id_(std::move(id)), form_(form), figures_(figures), html_(html) {}

void SectionWriter::open_part(const std::string& name, const std::string& title) {
  const std::string part = fmt::format("{}-{}", id_, name);
  headings_.push_back({.id = part, .title = title});
  html_.open("section", {{"id", part}, {"class", name}, {"aria-labelledby", part + "-title"}});
  html_.element(level(0), title, {{"id", part + "-title"}, {"class", "part-title"}});
}

std::string SectionWriter::level(int below) const {
  return fmt::format("h{}", (form_ == PageForm::one_file ? 2 : 3) + below);
}

std::string SectionWriter::id_of(ChartRows rows) const {
  switch (rows) {
    case ChartRows::own:
      return "";
    case ChartRows::of_motion:
      return id_;
    case ChartRows::of_simulation:
      return id_ + "-simulated";
  }
  return "";
}

PictureSource SectionWriter::source(std::optional<std::size_t> which) {
  return {.analysis = page_.analysis ? &*page_.analysis : nullptr,
          .motion = page_.motion ? &page_.motion->table : nullptr,
          .synthesis = page_.synthesis ? &*page_.synthesis : nullptr,
          .transmissions = page_.transmissions ? &*page_.transmissions : nullptr,
          .simulation = page_.simulation ? &page_.simulation->rows.table : nullptr,
          .maps = page_.duty ? &page_.duty->maps : nullptr,
          .which = which,
          .name = page_title(page_),
          .sections = &sections_};
}

void SectionWriter::add_pictures(const std::vector<Picture>& pictures) {
  if (pictures.empty()) {
    return;
  }
  const bool are_parts = pictures.size() > 1 && pictures[0].name == pictures[1].name;
  html_.open("div",
             {{"class",
               are_parts              ? "pictures parts"
               : pictures.size() == 1 ? "pictures"
                                      : "pictures two"}});
  add_figures(pictures, page_title(page_), id_, figures_, html_);
  html_.close();
}

void SectionWriter::add_pair(const TextBlocks& blocks,
                             const std::string& name,
                             std::vector<Picture> pictures) {
  std::stable_partition(
      pictures.begin(), pictures.end(), [](const Picture& one) { return !is_broad(one); });
  const auto below = pictures.begin() + static_cast<std::ptrdiff_t>(count_beside(pictures, blocks));
  const std::vector<Picture> beside(pictures.begin(), below);
  html_.open("div", {{"class", beside.empty() || blocks.is_empty() ? "pair" : "pair both"}});
  html_.open("div");
  add_blocks(blocks, name, html_);
  html_.close();
  if (!beside.empty()) {
    html_.open("div");
    add_figures(beside, page_title(page_), id_, figures_, html_);
    html_.close();
  }
  html_.close();
  add_pictures({below, pictures.end()});
}

void SectionWriter::add_charts(const Figure& figure, const std::string& what, ChartRows rows) {
  if (figure.charts.empty()) {
    return;
  }
  html_.open("div", {{"class", "charts"}});
  for (Chart chart : figure.charts) {
    chart.width = kChartWidth;
    // The caption has the title, which may be wider than the chart.
    const std::string caption = fmt::format("{}: {}", what, shown_in(chart, figure));
    chart.title.clear();
    ++figures_;
    add_chart_figure({.name = figure.name,
                      .title = fmt::format("{}, {}", caption, page_title(page_)),
                      .description = figure.description,
                      .charts = {chart}},
                     {.id = fmt::format("{}-figure-{}", id_, figures_),
                      .number = figures_,
                      .caption = caption,
                      .follows = id_of(rows)},
                     html_);
  }
  html_.close();
}

void SectionWriter::add_folded(const std::string& line, const std::vector<Picture>& pictures) {
  html_.open("details");
  html_.element("summary", line);
  for (const Picture& one : pictures) {
    add_pictures({one});
  }
  html_.close();
}

void SectionWriter::add_lack(const std::string& name, const std::string& title, bool is_asked) {
  if (is_asked) {
    open_part(name, title);
    html_.element("p", "There is nothing to show: the findings say what is wrong.");
    html_.close();
  }
}

}  // namespace kinestat
