// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/pair_blocks.h"

#include <algorithm>

#include "core/contact/detection/box_tree.h"

namespace sherd {
namespace {

/// How many pairs a block has at least, but for the last one.
constexpr std::size_t block_size = 512;

/// The vertex by whose place a pair is sorted: of a sheet, since elements of colliders may be large.
Index place_of(const ContactPair& pair) {
    return *std::ranges::max_element(pair.vertices);
}

template <class T>
void keep_each_once(std::vector<T>& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The entries in the order of a tree of their places.
std::vector<PairBlocks::Entry> sorted_in_space(const std::vector<PairBlocks::Entry>& entries,
                                               const Positions& x) {
    std::vector<Index> places;
    for (const PairBlocks::Entry& entry : entries) places.push_back(place_of(entry.pair));
    keep_each_once(places);
    std::vector<Box> boxes;
    for (const Index v : places) boxes.push_back({x.col(v), x.col(v)});
    const BoxTree tree(boxes);
    std::vector<Index> rank(x.cols());
    for (std::size_t i = 0; i < places.size(); ++i) rank[places[tree.order()[i]]] = static_cast<Index>(i);
    std::vector<std::size_t> start(places.size() + 1, 0);
    for (const PairBlocks::Entry& entry : entries) ++start[rank[place_of(entry.pair)] + 1];
    for (std::size_t i = 0; i < places.size(); ++i) start[i + 1] += start[i];
    std::vector<PairBlocks::Entry> sorted(entries.size());
    for (const PairBlocks::Entry& entry : entries) sorted[start[rank[place_of(entry.pair)]]++] = entry;
    return sorted;
}

}  // namespace

void PairBlocks::Block::list_vertices() {
    vertices.clear();
    for (const Entry& entry : entries)
        vertices.insert(vertices.end(), entry.pair.vertices.begin(), entry.pair.vertices.end());
    keep_each_once(vertices);
}

void PairBlocks::Block::remove(const std::vector<char>& changed) {
    const auto has_changed = [&](const Entry& entry) {
        return std::ranges::any_of(entry.pair.vertices, [&](Index v) { return changed[v]; });
    };
    const bool shrinks = std::erase_if(entries, has_changed) > 0;
    for (Entry& entry : entries) entry.pair.stiffness = 0;
    if (!shrinks) return;
    const std::vector<Index> before = vertices;
    list_vertices();
    for (std::size_t i = 0, old = 0; i < vertices.size(); ++i) {
        while (before[old] != vertices[i]) ++old;
        reference.col(i) = reference.col(old);
    }
    reference.conservativeResize(3, vertices.size());
}

void PairBlocks::Block::measure(const Positions& x) {
    for (Entry& entry : entries)
        entry.room = distance(entry.pair, columns(x, entry.pair.vertices)) - entry.pair.activation_distance;
    std::ranges::sort(entries, {}, &Entry::room);
    reference = x(Eigen::all, vertices);
    idle = 0;
}

double PairBlocks::Block::spread(const Positions& x, const Positions* from) const {
    Box moved;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Array3d way = x.col(vertices[i]);
        if (from) way -= from->col(static_cast<Eigen::Index>(i)).array();
        moved.include({way, way});
    }
    return (moved.upper - moved.lower).matrix().norm();
}

void PairBlocks::add(const std::vector<Entry>& entries, const Positions& x) {
    const std::vector<Entry> sorted = sorted_in_space(entries, x);
    for (auto first = sorted.begin(); first != sorted.end();) {
        const auto last = first + std::min<std::ptrdiff_t>(block_size, sorted.end() - first);
        Block& block = blocks.emplace_back();
        block.entries.assign(first, last);
        std::ranges::sort(block.entries, {}, &Entry::room);
        block.list_vertices();
        block.reference = x(Eigen::all, block.vertices);
        first = last;
    }
}

void PairBlocks::remove(const std::vector<char>& changed) {
    for (Block& block : blocks) block.remove(changed);
    std::erase_if(blocks, [](const Block& block) { return block.entries.empty(); });
}

void PairBlocks::find_active(const ContactSurface& surface, const Positions& x, double round_off,
                             std::vector<ContactPair>& active) {
    active.clear();
    for (Block& block : blocks) {
        const double reach = block.spread(x, &block.reference) + round_off;
        for (Entry& entry : block.entries) {
            if (entry.room > reach) break;
            if (!within(entry.pair.activation_distance, entry.pair, columns(x, entry.pair.vertices))) {
                ++block.idle;
                continue;
            }
            if (entry.pair.stiffness == 0) surface.stiffen(entry.pair);
            active.push_back(entry.pair);
        }
        if (block.idle > block.entries.size()) block.measure(x);
    }
    std::ranges::sort(active, before);
}

}  // namespace sherd
