// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/contact/detection/contact_surface.h"
#include "core/contact/detection/motion_cells.h"
#include "core/state_visitor.h"
#include "core/threads.h"

namespace sherd {

/// Candidate pairs, each with its room, the distance less the activation distance, when it was last measured.
/// Neighbouring pairs form a block. As long as no two vertices of a block have moved by more than a pair's
/// room relative to each other, nothing is computed for that pair: most pairs of a sheet that stays in one
/// piece are never tested. Cells of vertices, which are far fewer, tell first whether a block has a pair to
/// test. No result depends on when a block was measured.
class PairBlocks {
  public:
    struct Entry {
        ContactPair pair;
        double clearance;  ///< m, distance less activation distance
    };

    /// Adds pairs with their room at x. From call to call x may differ only at vertices that have changed.
    void add(const std::vector<Entry>& entries, const Positions& x);
    /// Removes the pairs with a vertex that has changed. The stiffness of the others is computed again.
    void remove(const std::vector<char>& changed);

    /// The active pairs at x, ascending, vertex-triangle pairs first. round_off: m, bound on the round-off of
    /// distances.
    std::vector<ContactPair> find_active(const ContactSurface& surface, const Positions& x, double round_off,
                                         const Threads& threads);
    /// Returns the pairs, ascending, for which keep(pair, least) is true. All pairs are tested that are
    /// nearer at x than `nearness` times their activation distance, plus `reserve` (m), plus the approach of
    /// their vertices in the motion, if any; and some others; in any order, by several threads at a time.
    /// least: m, lower bound of the pair's distance at x. Not all pairs have their stiffness.
    template <class Keep>
    std::vector<ContactPair> near(const Positions& x, const Positions& motion, double nearness,
                                  double reserve, const Threads& threads, const Keep& keep) const {
        if (blocks.empty()) return {};
        const std::vector<Box> moved_cells = cells.boxes(x - start);
        const std::vector<Box> moving_cells = motion.cols() > 0 ? cells.boxes(motion) : std::vector<Box>();
        return from_blocks(threads, [&](Index b, std::vector<ContactPair>& kept) {
            const Block& block = blocks[b];
            const double around = reserve + (nearness - 1) * block.largest_activation;
            if (block.least_clearance() >
                block.cell_spread(moved_cells) + block.cell_spread(moving_cells) + around)
                return;
            const double moved = block.spread(x, &block.reference);
            const double reach = moved + (motion.cols() > 0 ? block.spread(motion, nullptr) : 0) + around;
            for (const Entry& entry : block.entries) {
                if (entry.clearance > reach) break;
                if (keep(entry.pair, entry.clearance + entry.pair.activation_distance - moved))
                    kept.push_back(entry.pair);
            }
        });
    }

    void visit_state(StateVisitor& visit) {
        auto& [blocks, cells, start] = *this;
        visit(blocks, cells, start);
    }

  private:
    struct Block {
        std::vector<Entry> entries;     ///< sorted by room, least first
        std::vector<Index> vertices;    ///< vertices of all entries, ascending
        Positions reference;            ///< [3, vertices] m, where the room was measured
        double largest_activation = 0;  ///< m, upper bound of the activation distances
        std::size_t idle = 0;           ///< number of tests since then that found a pair inactive
        bool stale = false;             ///< whether the stiffness of pairs may have changed
        bool measured = false;          ///< whether the room was measured elsewhere than at the start
        std::vector<Index> cells;       ///< cells of the vertices, ascending

        /// A block with the vertices at x. seen: zeros, one for each vertex.
        Block(std::span<const Entry> given, const Positions& x, const MotionCells& in,
              std::vector<char>& seen);
        Block() = default;
        void remove(const std::vector<char>& changed, const MotionCells& in, std::vector<char>& seen);
        void list_vertices(const MotionCells& in, std::vector<char>& seen);
        void measure(const Positions& x);
        /// Appends the block's active pairs.
        void find_active(const ContactSurface& surface, const Positions& x,
                         const std::vector<Box>& moved_cells, double round_off,
                         std::vector<ContactPair>& active);
        double least_clearance() const { return entries.front().clearance; }
        /// Bound, m, on the relative motion of any two of the vertices. x: their positions, which moved there
        /// from `from`; or, if that is null, their motions.
        double spread(const Positions& x, const Positions* from) const;
        /// A cheaper bound, no smaller than spread(), from the boxes of all cells' motions; no boxes: nothing
        /// moves.
        double cell_spread(const std::vector<Box>& boxes) const;
        void visit_state(StateVisitor& visit) {
            auto& [entries, vertices, reference, largest_activation, idle, stale, measured, cells] = *this;
            visit(entries, vertices, reference, largest_activation, idle, stale, measured, cells);
        }
    };

    /// The pairs that find(block, pairs) appends, ascending.
    template <class Find>
    std::vector<ContactPair> from_blocks(const Threads& threads, const Find& find) const {
        constexpr Index at_once = 16;
        const auto count = static_cast<Index>(blocks.size());
        std::vector<std::vector<ContactPair>> of_parts((count + at_once - 1) / at_once);
        threads.share_ranges(count, at_once, [&](Index begin, Index end) {
            for (Index b = begin; b < end; ++b) find(b, of_parts[begin / at_once]);
        });
        std::vector<ContactPair> all;
        for (const auto& some : of_parts) all.insert(all.end(), some.begin(), some.end());
        sort(all);
        return all;
    }

    std::vector<Block> blocks;
    MotionCells cells;
    Positions start;  ///< m, positions at which blocks were made
};

}  // namespace sherd
