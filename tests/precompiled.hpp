// What nearly every test includes, compiled once for all of them; see core/precompiled.hpp.
#pragma once

#include <gtest/gtest.h>

#include "core/precompiled.hpp"
