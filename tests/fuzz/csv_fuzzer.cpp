// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that are read from an input must be the same after they are written and read again.
#include <cstdlib>

#include "app/sweep/table/csv.h"
#include "tests/fuzz/read_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd;
    test::read_or_refuse([&] {
        const CsvRows rows = parse_csv(test::text_of(data, size), "a.csv");
        if (parse_csv(csv_text(rows), "a.csv") != rows) std::abort();
    });
    return 0;
}
