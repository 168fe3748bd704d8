// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// The threads of each of so many runs at a time: `most`, or, if that is 0, as many as the processor runs at
/// once, shared among them, but no more than pay.
int threads_of_run(int most, int runs);

}  // namespace sherd
