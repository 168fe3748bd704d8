// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/legend/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sherd {

UnitPrefix prefixed(const std::string& unit, double largest) {
    if (unit == "m\xc2\xb2") {
        if (largest < 1e-5) return {1e6, "mm\xc2\xb2"};
        return largest < 1 ? UnitPrefix{1e4, "cm\xc2\xb2"} : UnitPrefix{1, unit};
    }
    if (unit.empty() || unit == "1/m" || !(largest > 0) || !std::isfinite(largest)) return {1, unit};
    struct {
        double size;
        const char* name;
    } constexpr prefixes[] = {{1e9, "G"},  {1e6, "M"},         {1e3, "k"}, {1, ""},
                              {1e-3, "m"}, {1e-6, "\xc2\xb5"}, {1e-9, "n"}};
    for (const auto& prefix : prefixes)
        if (largest >= prefix.size) return {1 / prefix.size, prefix.name + unit};
    return {1e9, "n" + unit};
}

std::string tick_text(double tick) {
    // Ticks are round numbers except for round-off, which six digits do not show.
    return fmt::format("{:.6g}", std::abs(tick) < 1e-300 ? 0.0 : tick);
}

std::vector<double> round_ticks(double low, double high, int most, bool whole) {
    const double rough = (high - low) / most, power = std::pow(10, std::floor(std::log10(rough)));
    double spacing = 10 * power;
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= rough * (1 - 1e-9)) {
            spacing = step * power;
            break;
        }
    if (whole) spacing = std::max(1.0, spacing);
    std::vector<double> ticks;
    const double first = std::ceil(low / spacing - 1e-9);
    for (double i = first; i * spacing <= high + 1e-9 * spacing; ++i) ticks.push_back(i * spacing);
    while (ticks.size() < 2) ticks.push_back((first + static_cast<double>(ticks.size())) * spacing);
    return ticks;
}

std::vector<double> logarithmic_ticks(double low, double high) {
    const bool few = high < 150 * low;
    std::vector<double> ticks;
    for (double e = std::floor(std::log10(low) + 1e-9); e <= std::log10(high) + 1e-9; ++e)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double tick = digit * std::pow(10, e);
            if ((few || digit == 1) && tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9))
                ticks.push_back(tick);
        }
    return ticks;
}

}  // namespace sherd
