// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/design.h"
#include "app/sweep/study/study.h"
#include "tests/fuzz/read_input.h"

namespace {

/// Whether a study is fast to expand: studies may have ten million rows.
bool is_small(const sherd::Study& study) {
    double rows = static_cast<double>(study.samples + 1);
    for (const sherd::StudyParameter& parameter : study.parameters)
        rows *= static_cast<double>(parameter.values.size() + 1);
    return rows < 1000;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd;
    for (const bool quick : {false, true})
        test::read_or_refuse([&] {
            const Study study = parse_study(test::text_of(data, size), "a.toml", quick);
            if (is_small(study)) design_points(study);
        });
    return 0;
}
