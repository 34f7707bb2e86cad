// How accurate an answer has to be, and what is known of its error.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace kinestat {

/// What the user trades for what.
enum class Accuracy {
  automatic,  ///< doubles with a bound; refined, or exact, where the bound asks for it
  fast,       ///< doubles without a bound
  high,       ///< always refined with residuals of twice the digits
  exact       ///< the numbers as typed
};

/// The word on the command line.
constexpr std::string_view word_of(Accuracy accuracy) {
  switch (accuracy) {
    case Accuracy::automatic:
      return "auto";
    case Accuracy::fast:
      return "fast";
    case Accuracy::high:
      return "high";
    case Accuracy::exact:
      return "exact";
  }
  return "";
}

inline constexpr int kUsualDigits = 9;
inline constexpr int kMostAskedDigits = 15;  ///< values are reported as doubles

struct AccuracyRequest {
  Accuracy accuracy = Accuracy::fast;
  int digits = kUsualDigits;  ///< asked for, of each value
};

/// The way on which an answer was found.
enum class Precision {
  plain,    ///< elimination in doubles
  refined,  ///< corrected by residuals of twice the digits
  exact     ///< the equations as typed: fractions, or numbers of 60 digits
};

/// The word in reports.
constexpr std::string_view word_of(Precision precision) {
  switch (precision) {
    case Precision::plain:
      return "double";
    case Precision::refined:
      return "refined";
    case Precision::exact:
      return "exact";
  }
  return "";
}

/// What is known of the error of an answer.
struct AnswerEvidence {
  Precision precision = Precision::plain;
  std::optional<double> error_bound;  ///< relative, of the worst value; 1: not one digit is sure.
                                      ///< Empty: none was asked for, or there is none
  std::vector<double> bounds;         ///< [SI] of each magnitude, where there is an error bound
  bool is_exact_input = false;  ///< the bound refers to the numbers as typed, else to the doubles
                                ///< that stand for them in the equations
  bool is_exact = false;        ///< fractions all the way; only the written value is rounded
};

/// Whether a bound promises that many digits; without one nothing is promised.
bool reaches(const AnswerEvidence& evidence, int digits);

}  // namespace kinestat
