// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/contact/detection/contact_surface.h"
#include "core/contact/detection/motion_cells.h"
#include "core/state_visitor.h"
#include "core/threads.h"

namespace sherd {

/// Candidate pairs, each with its clearance, the distance less the activation distance, at the positions
/// where it was last measured. Pairs near each other form a block. As long as no two vertices of a block have
/// moved relative to each other by more than a pair's clearance, that pair cannot be active and nothing is
/// computed for it: most pairs of a sheet that stays in one piece are never tested. A bound from cells of
/// vertices (MotionCells), which are far fewer than the vertices, first excludes most blocks as a whole. No
/// result depends on when the clearances of a block were measured.
class PairBlocks {
  public:
    struct Entry {
        ContactPair pair;
        double clearance;  ///< m, distance less activation distance
    };

    /// Adds pairs with their clearance at x. From call to call only the positions of vertices that were given
    /// to remove() as changed may differ.
    void add(const std::vector<Entry>& entries, const Positions& x);
    /// Removes the pairs with a vertex whose flag in `changed` is set. The stiffness of the remaining pairs
    /// is computed again when it is needed.
    void remove(const std::vector<char>& changed);

    /// Returns the active pairs at x, ascending, vertex-triangle pairs first. round_off: m, bound on the
    /// round-off of distances.
    std::vector<ContactPair> find_active(const ContactSurface& surface, const Positions& x, double round_off,
                                         const Threads& threads);
    /// Returns the pairs, ascending, for which keep(pair, least) is true, where `least` (m) is a lower bound
    /// of the pair's distance at x. Tests at least all pairs whose distance at x is less than `nearness`
    /// times their activation distance, plus `reserve` (m), plus the approach of their vertices in the motion
    /// (an empty `motion` is none). Several threads call keep() at a time, in any order. The stiffness of
    /// some pairs is not yet set.
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
        std::vector<Entry> entries;     ///< in ascending order of clearance
        std::vector<Index> vertices;    ///< vertices of all entries, ascending
        Positions reference;            ///< [3, vertices] m, where clearances were measured
        double largest_activation = 0;  ///< m, upper bound of the entries' activation distances
        std::size_t idle = 0;           ///< number of tests since the measurement that found a pair inactive
        bool stale = false;             ///< whether the stiffness of pairs must be computed again
        bool measured = false;     ///< whether clearances were measured elsewhere than at PairBlocks::start
        std::vector<Index> cells;  ///< cells of the block's vertices, ascending

        /// A block of the given entries, measured at the positions x. in: cells of all vertices. seen: a
        /// buffer with a zero for each vertex, all zero again on return.
        Block(std::span<const Entry> given, const Positions& x, const MotionCells& in,
              std::vector<char>& seen);
        Block() = default;
        void remove(const std::vector<char>& changed, const MotionCells& in, std::vector<char>& seen);
        /// Finds `vertices` and `cells` of the entries.
        void list_vertices(const MotionCells& in, std::vector<char>& seen);
        /// Measures the clearances at x.
        void measure(const Positions& x);
        /// Appends the block's pairs that are active at x. moved_cells: see cell_spread().
        void find_active(const ContactSurface& surface, const Positions& x,
                         const std::vector<Box>& moved_cells, double round_off,
                         std::vector<ContactPair>& active);
        double least_clearance() const { return entries.front().clearance; }
        /// Upper bound, m, on the relative motion of any two of the block's vertices, which have moved from
        /// the positions `from` (one column for each of `vertices`) to x (all vertices of the surface). If
        /// `from` is null, x holds displacements.
        double spread(const Positions& x, const Positions* from) const;
        /// A cheaper bound, m, which is no smaller than spread(). boxes: of the displacements in each cell
        /// (MotionCells::boxes()); empty if no vertex moves.
        double cell_spread(const std::vector<Box>& boxes) const;
        void visit_state(StateVisitor& visit) {
            auto& [entries, vertices, reference, largest_activation, idle, stale, measured, cells] = *this;
            visit(entries, vertices, reference, largest_activation, idle, stale, measured, cells);
        }
    };

    /// Returns the pairs, ascending, that calls of find(block, pairs) with the number of each block append to
    /// `pairs`.
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
    Positions start;  ///< [3, V] m, positions x of the last add()
};

}  // namespace sherd
