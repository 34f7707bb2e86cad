// The guides of a chart with their words above its frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/chart_frame.hpp"

namespace kinestat {

inline constexpr double kWordsHeight = 17.0;  ///< of a row [px]

/// Words stand over their guides, in several rows where there are many, so that none covers another
/// and no guide runs through the words of another; where they are too long for that, numbers stand
/// there, and the words of each below each other.
class GuideWords {
 public:
  /// Of guides within the frame, in any order; the first of them have words, if they are named.
  GuideWords(std::span<const ChartGuide> guides, const ChartFrame& frame);

  int row_count() const;

  void draw(const ChartFrame& frame, Svg& svg) const;

 private:
  struct Words {
    std::string text;
    double x = 0.0;  // of the guide
    double width = 0.0;
    Anchor anchor = Anchor::middle;
    int row = -1;  // from below; none yet

    double left() const;

    double right() const { return left() + width; }

    bool spans(double place) const { return place > left() && place < right(); }
  };

  void lay_out(const ChartFrame& frame);
  void turn_inwards(const ChartFrame& frame);
  void find_row(std::size_t i, std::size_t depth);
  bool has_room(const ChartFrame& frame) const;
  int words_rows() const;

  std::span<const ChartGuide> guides_;
  std::vector<Words> words_;
  bool is_numbered_ = false;
};

}  // namespace kinestat
