// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/contact/friction/friction.h"
#include "core/state_visitor.h"

namespace sherd {

/// Elastic slip of contacts (Friction::elastic_slip), stored from one step to the next in multiples of
/// Friction::smoothing, so that the force does not change with the length of the step. A Key identifies a
/// contact; keys have an order.
template <class Key>
class StickMemory {
  public:
    /// Returns the stored elastic slip, or zero for a contact that has none.
    Vector3d slip_of(const Key& key) const {
        const auto found = std::ranges::lower_bound(entries, key, {}, &Entry::first);
        return found != entries.end() && found->first == key ? found->second : Vector3d::Zero();
    }
    void clear() { entries.clear(); }
    /// Stores the elastic slip of a contact, once for each contact. Contacts come in ascending order of their
    /// keys, unless sort() is called afterwards.
    void keep(const Key& key, const Vector3d& elastic_slip) { entries.emplace_back(key, elastic_slip); }
    void sort() { std::ranges::sort(entries, {}, &Entry::first); }

    void visit_state(StateVisitor& visit) { visit(entries); }

  private:
    using Entry = std::pair<Key, Vector3d>;
    std::vector<Entry> entries;
};

}  // namespace sherd
