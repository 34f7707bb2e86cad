// Which numbers of teeth bring a planetary gear set nearest to a ratio, with the ring held:
// teeth_search FILE CASE RATIO, for files with the parameters Ns (sun) and Np (planet).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <kinestat.hpp>
#include <limits>
#include <vector>

namespace {

void search(const char* file, const char* label, double wanted) {
  const auto mechanism = kinestat::MechanismFile::read(file);
  kinestat::Tape tape = mechanism.record({"Ns", "Np"}, {"ratio"}, label);
  std::vector<double> teeth;
  for (int sun = 17; sun <= 80; ++sun) {
    for (int planet = 17; planet <= 80; ++planet) {
      teeth.push_back(sun);
      teeth.push_back(planet);
    }
  }
  const std::vector<double> ratios = tape.play(teeth);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double error = std::abs(ratios[i] - wanted);
    if (error < least) {
      least = error;
      best = i;
    }
  }
  std::printf("%zu sets tried; nearest: Ns = %g, Np = %g, ratio %.6g\n",
              ratios.size(),
              teeth[2 * best],
              teeth[2 * best + 1],
              ratios[best]);
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fprintf(stderr, "usage: teeth_search FILE CASE RATIO\n");
    return KINESTAT_USAGE;
  }
  try {
    search(words[1], words[2], std::strtod(words[3], nullptr));
  } catch (const kinestat::CallError& problem) {
    std::fputs(problem.what(), stderr);
    return problem.status();
  }
  return 0;
}
