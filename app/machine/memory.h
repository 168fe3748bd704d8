// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

double machine_memory();   ///< bytes that the machine has
double resident_memory();  ///< bytes that this program holds now
double peak_memory();      ///< bytes, the most that it held since its start, or forget_peak_memory()

/// From now on peak_memory() is of what comes. Does nothing where Linux does not let a program do this.
void forget_peak_memory();

/// Bytes a second that one thread reads from an array larger than any cache: the most of some rounds.
double memory_bandwidth();

}  // namespace sherd
