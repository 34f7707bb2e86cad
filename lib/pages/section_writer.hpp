// What the parts of a file's section are made of: headings, pictures, and tables beside them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "draw/catalogue/catalogue.hpp"
#include "draw/chart.hpp"
#include "draw/train/gear_sections.hpp"
#include "pages/file_page.hpp"
#include "pages/html.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// A heading for the table of contents.
struct PageHeading {
  std::string id;
  std::string title;
};

/// What the points of a chart are: its own, or the rows of the motion or of the simulation of the
/// file in their order.
enum class ChartRows { own, of_motion, of_simulation };

/// Whether the title of the page is that of its only file.
enum class PageForm { one_file, many_files };

/// Writes for all parts alike. Ids begin with `id`; the figures are numbered on from `figures`. The
/// page, the counter and the HTML must outlive it.
class SectionWriter {
 public:
  SectionWriter(const FilePage& page, std::string id, PageForm form, int& figures, Html& html);

  const FilePage& page() const { return page_; }

  const std::string& id() const { return id_; }

  /// By which charts and the drawing that they follow know each other.
  std::string id_of(ChartRows rows) const;

  PageForm form() const { return form_; }

  int& figures() { return figures_; }

  Html& html() { return html_; }

  std::vector<PageHeading> take_headings() { return std::move(headings_); }

  /// Opens a part of the section, which the caller closes.
  void open_part(const std::string& name, const std::string& title);

  /// "h2" for a part of a page of one file, "h3" for what is a level below it.
  std::string level(int below) const;

  /// What pictures of the file or, with its index, of a case are made of.
  PictureSource source(std::optional<std::size_t> which = {});

  /// Side by side where there is room: two, or as many parts of one picture as there are.
  void add_pictures(const std::vector<Picture>& pictures);

  /// Each a figure of its own, so that they stand beside each other.
  void add_charts(const Figure& figure, const std::string& what, ChartRows rows = ChartRows::own);

  /// Tables, and pictures of the same beside them where there is room, else below.
  void add_pair(const TextBlocks& blocks, const std::string& name, std::vector<Picture> pictures);

  /// Below each other, behind a line that opens them.
  void add_folded(const std::string& line, const std::vector<Picture>& pictures);

  /// A part that the file has a section for, and that has come to nothing.
  void add_lack(const std::string& name, const std::string& title, bool is_asked);

 private:
  const FilePage& page_;
  std::string id_;
  PageForm form_;
  int& figures_;
  Html& html_;
  GearSections sections_;
  std::vector<PageHeading> headings_;
};

}  // namespace kinestat
