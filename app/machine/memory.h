// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

double machine_memory();   ///< bytes, memory of the machine
double resident_memory();  ///< bytes, resident memory of this program now
double peak_memory();      ///< bytes, largest resident memory since the start or reset_peak_memory()

/// Gives unused memory back to the system, and resets peak_memory() to resident_memory(). Linux may not allow
/// the reset; peak_memory() then stays as it is.
void reset_peak_memory();

/// Returns the bytes per second that one thread reads from an array larger than any cache: the largest rate
/// of three rounds.
double memory_bandwidth();

}  // namespace sherd
