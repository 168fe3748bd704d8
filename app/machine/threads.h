// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Returns the number of threads of each of `runs` concurrent runs: `most`, or, if that is 0, an equal share
/// of the processor's threads, of which all runs together use no more than pay off.
int threads_of_run(int most, int runs);

}  // namespace sherd
