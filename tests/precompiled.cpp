// Only here so that there is something to compile tests/precompiled.hpp for.
