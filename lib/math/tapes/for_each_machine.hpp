// Functions that are compiled for several machines.
#pragma once

// A function is compiled once for each of these, and the machine's own is chosen as the program
// starts; the bits are the same in all. A sanitizer is not ready when that is done.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define KINESTAT_ONE_MACHINE
#endif
#endif
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(KINESTAT_ONE_MACHINE)
#define KINESTAT_FOR_EACH_MACHINE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define KINESTAT_FOR_EACH_MACHINE
#endif
