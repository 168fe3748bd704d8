// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

double machine_memory();   ///< bytes, memory of the machine
double resident_memory();  ///< bytes, memory of this program now
double peak_memory();      ///< bytes, largest memory since its start, or since reset_peak_memory()

/// Returns free memory to the system, and resets peak_memory(). Linux may not allow this.
void reset_peak_memory();

/// Bytes per second that one thread reads from an array larger than any cache: the largest of several rounds.
double memory_bandwidth();

}  // namespace sherd
