// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/contact/friction/friction.h"
#include "core/state_visitor.h"

namespace sherd {

/// Elastic slip of contacts (Friction::elastic_slip), stored from one step to the next in multiples of
/// Friction::smoothing, so that the force stays the same when the step's length changes. Key: of a contact,
/// with an order.
template <class Key>
class StickMemory {
  public:
    /// Returns zero for a contact that the last step did not have.
    Vector3d slip_of(const Key& key) const {
        const auto found = std::ranges::lower_bound(entries, key, {}, &Entry::first);
        return found != entries.end() && found->first == key ? found->second : Vector3d::Zero();
    }
    void clear() { entries.clear(); }
    /// Stores the elastic slip of a contact. Each contact comes once, in ascending order, unless sort()
    /// follows.
    void keep(const Key& key, const Vector3d& elastic_slip) { entries.emplace_back(key, elastic_slip); }
    void sort() { std::ranges::sort(entries, {}, &Entry::first); }

    void visit_state(StateVisitor& visit) { visit(entries); }

  private:
    using Entry = std::pair<Key, Vector3d>;
    std::vector<Entry> entries;
};

}  // namespace sherd
