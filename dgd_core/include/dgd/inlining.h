// What of a query is inlined into what, for speed alone.
#pragma once

/// All that such a function calls is inlined into it. Only where DGD_FLATTEN_QUERIES is defined before the first header
/// of the solver is included, as in the files of the library that a pair of sets is compiled in: queries take 0.79 to
/// 0.97 of the instructions there, and of the compiler 1.2 times the time and twice the space (dgd_core/README.md).
#ifdef DGD_FLATTEN_QUERIES
#define DGD_FLATTEN [[gnu::flatten]]
#else
#define DGD_FLATTEN
#endif

/// A function that is rare and long, or long and called from several places, and would be inlined with its registers
/// into one that is neither.
#define DGD_NOINLINE [[gnu::noinline]]
/// The same for the rarest: the compiler also keeps its code out of the way of what comes before.
#define DGD_COLD [[gnu::cold, gnu::noinline]]
