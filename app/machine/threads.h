// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Returns the number of threads for each of `runs` concurrent runs. Returns `most`, or, if that is 0, an
/// equal share of the processor's threads, at least 1; all runs together then share at most 4 threads, since
/// more do not pay off.
int threads_of_run(int most, int runs);

}  // namespace sherd
