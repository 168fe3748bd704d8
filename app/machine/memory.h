// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

double machine_memory();   ///< bytes that the machine has
double resident_memory();  ///< bytes that this program holds now
double peak_memory();      ///< bytes, the most that it held since its start, or forget_peak_memory()

/// Gives back what is free, and from now on peak_memory() is of what comes. Linux may not let a program do
/// so.
void forget_peak_memory();

/// Bytes a second that one thread reads from an array larger than any cache: the most of some rounds.
double memory_bandwidth();

}  // namespace sherd
