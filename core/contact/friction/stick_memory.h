// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/contact/friction/friction.h"
#include "core/state_visitor.h"

namespace sherd {

/// What contacts hold of their slip from one step to the next, in multiples of Friction::smoothing: so the
/// force stays when the step's length changes. Key: of a contact, with an order.
template <class Key>
class StickMemory {
  public:
    /// Zero for a contact that the last step did not have.
    Vector3d of(const Key& key) const {
        const auto found = std::ranges::lower_bound(kept, key, {}, &Kept::first);
        return found != kept.end() && found->first == key ? found->second : Vector3d::Zero();
    }
    void clear() { kept.clear(); }
    /// Each contact once, in ascending order, or sort() when all are kept.
    void keep(const Key& key, const Vector3d& held) { kept.emplace_back(key, held); }
    void sort() { std::ranges::sort(kept, {}, &Kept::first); }

    void visit_state(StateVisitor& visit) { visit(kept); }

  private:
    using Kept = std::pair<Key, Vector3d>;
    std::vector<Kept> kept;
};

}  // namespace sherd
