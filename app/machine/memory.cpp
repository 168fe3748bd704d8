// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machine/memory.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "app/machine/processor_time.h"
#include "core/vector.h"

namespace sherd {
namespace {

double page_size() {
    return static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

double machine_memory() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * page_size();
}

double resident_memory() {
    std::ifstream statistics("/proc/self/statm");
    double all = 0, resident = 0;
    statistics >> all >> resident;
    return resident * page_size();
}

double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void reset_peak_memory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // proc(5): "5" resets the peak to the resident memory
}

double memory_bandwidth() {
    constexpr Eigen::Index doubles = 1 << 25;
    const VectorXd array = VectorXd::Ones(doubles);
    volatile double sum = 0;
    const double seconds = least_seconds([&] { sum = array.sum(); });
    return sizeof(double) * static_cast<double>(doubles) / seconds;
}

}  // namespace sherd
