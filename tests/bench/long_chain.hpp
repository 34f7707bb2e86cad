// A long mechanism file, to time how long the reading of one takes.
#pragma once

#include <string>

namespace kinestat::bench {

/// An open planar chain of `count` revolutes; each stands at a point with a parameter of its own.
std::string long_chain(int count);

}  // namespace kinestat::bench
