// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/element_energy.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

// Functions that call the overloads value(), gradient() and round_off() of a kind of hinge. Structs that have
// members of the same names call the overloads through them.
template <class Hinge>
double value_of(const Hinge& hinge, const HingePositions& x) {
    return value(hinge, x);
}
template <class Hinge>
HingePositions gradient_of(const Hinge& hinge, const HingePositions& x) {
    return gradient(hinge, x);
}
template <class Hinge>
double round_off_of(const Hinge& hinge) {
    return round_off(hinge);
}

/// Uncoupled hinges as elements of one kind: `Hinge` has value(), gradient() and round_off().
template <class Hinge>
struct HingeElements {
    /// The shell's stencils, which must outlive this object; they hold the vertices.
    const std::vector<HingeStencil>* stencils;
    const Positions* rest;      ///< [3, V] m, rest shape of the hinges; must exist when follow() is called
    std::vector<Hinge> hinges;  ///< hinge of each stencil

    std::size_t size() const { return hinges.size(); }
    const std::array<Index, 4>& vertices(std::size_t i) const { return (*stencils)[i].vertices; }
    double value(std::size_t i, const HingePositions& x) const { return value_of(hinges[i], x); }
    HingePositions gradient(std::size_t i, const HingePositions& x) const {
        return gradient_of(hinges[i], x);
    }
    double round_off() const {
        double sum = 0;
        for (const Hinge& hinge : hinges) sum += round_off_of(hinge);
        return sum;
    }
    void visit_state(StateVisitor& visit) {
        auto& [stencils, rest, hinges] = static_cast<HingeElements&>(*this);
        visit(hinges);
    }
    HingePositions at_rest(std::size_t i) const { return columns(*rest, vertices(i)); }
};

/// Bending energy of uncoupled hinges.
template <class Hinges>
class HingeEnergy : public ElementEnergy<Hinges> {
  public:
    using ElementEnergy<Hinges>::ElementEnergy;
    void topology_changed(const ShellChange& change, const StepContext&) override {
        this->elements.follow(change);
    }
    double round_off() const override { return this->elements.round_off(); }
    const Hinges& all() const { return this->elements; }
};

}  // namespace sherd
