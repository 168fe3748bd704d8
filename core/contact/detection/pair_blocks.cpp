// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/pair_blocks.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/contact/detection/box_tree.h"

namespace sherd {
namespace {

/// Largest number of pairs in a block.
constexpr std::size_t block_size = 512;

/// The vertex by whose place a pair is sorted: a vertex of a sheet, since elements of colliders may be large.
/// (Vertices of sheets have larger numbers.)
Index place_of(const ContactPair& pair) {
    return *std::ranges::max_element(pair.vertices);
}

/// Returns the entries in the order that a BoxTree gives to the vertices place_of(pair), so that pairs near
/// each other follow one another.
std::vector<PairBlocks::Entry> sorted_in_space(const std::vector<PairBlocks::Entry>& entries,
                                               const Positions& x) {
    std::vector<Index> places;
    for (const PairBlocks::Entry& entry : entries) places.push_back(place_of(entry.pair));
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
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

PairBlocks::Block::Block(std::span<const Entry> given, const Positions& x, const MotionCells& in,
                         std::vector<char>& seen)
    : entries(given.begin(), given.end()) {
    std::ranges::sort(entries, {}, &Entry::clearance);
    for (const Entry& entry : entries)
        largest_activation = std::max(largest_activation, entry.pair.activation_distance);
    list_vertices(in, seen);
    reference = x(Eigen::all, vertices);
}

void PairBlocks::Block::list_vertices(const MotionCells& in, std::vector<char>& seen) {
    vertices.clear();
    for (const Entry& entry : entries)
        for (const Index v : entry.pair.vertices)
            if (!std::exchange(seen[v], 1)) vertices.push_back(v);
    for (const Index v : vertices) seen[v] = 0;
    std::ranges::sort(vertices);
    cells.clear();
    for (const Index v : vertices) cells.push_back(in.of(v));
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

void PairBlocks::Block::remove(const std::vector<char>& changed, const MotionCells& in,
                               std::vector<char>& seen) {
    stale = true;
    const auto has_changed = [&](Index v) { return changed[v] != 0; };
    if (std::ranges::none_of(vertices, has_changed)) return;
    std::erase_if(entries,
                  [&](const Entry& entry) { return std::ranges::any_of(entry.pair.vertices, has_changed); });
    const std::vector<Index> before = vertices;
    list_vertices(in, seen);
    for (std::size_t i = 0, old = 0; i < vertices.size(); ++i) {
        while (before[old] != vertices[i]) ++old;
        reference.col(i) = reference.col(old);
    }
    reference.conservativeResize(3, vertices.size());
}

void PairBlocks::Block::measure(const Positions& x) {
    for (Entry& entry : entries)
        entry.clearance =
            distance(entry.pair, columns(x, entry.pair.vertices)) - entry.pair.activation_distance;
    std::ranges::sort(entries, {}, &Entry::clearance);
    reference = x(Eigen::all, vertices);
    measured = true;
    idle = 0;
}

double PairBlocks::Block::spread(const Positions& x, const Positions* from) const {
    Box moved;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Array3d way = x.col(vertices[i]);
        if (from) way -= from->col(static_cast<Eigen::Index>(i)).array();
        moved.include({way, way});
    }
    return sherd::spread(moved);
}

double PairBlocks::Block::cell_spread(const std::vector<Box>& boxes) const {
    if (boxes.empty()) return 0;
    if (measured) return std::numeric_limits<double>::infinity();
    Box moved;
    for (const Index cell : cells) moved.include(boxes[cell]);
    return sherd::spread(moved);
}

void PairBlocks::add(const std::vector<Entry>& entries, const Positions& x) {
    start = x;
    if (blocks.empty() && entries.empty()) return;  // only blocks need the cells, which take long to make
    const std::vector<Entry> sorted = sorted_in_space(entries, x);
    cells.cover(x);
    std::vector<char> seen(x.cols(), 0);
    for (std::size_t first = 0; first < sorted.size(); first += block_size)
        blocks.emplace_back(std::span(sorted).subspan(first, std::min(block_size, sorted.size() - first)), x,
                            cells, seen);
}

void PairBlocks::remove(const std::vector<char>& changed) {
    std::vector<char> seen(changed.size(), 0);
    for (Block& block : blocks) block.remove(changed, cells, seen);
    std::erase_if(blocks, [](const Block& block) { return block.entries.empty(); });
}

void PairBlocks::Block::find_active(const ContactSurface& surface, const Positions& x,
                                    const std::vector<Box>& moved_cells, double round_off,
                                    std::vector<ContactPair>& active) {
    if (std::exchange(stale, false))
        for (Entry& entry : entries) entry.pair.stiffness = 0;
    if (least_clearance() > cell_spread(moved_cells) + round_off) return;
    const double reach = spread(x, &reference) + round_off;
    for (Entry& entry : entries) {
        if (entry.clearance > reach) break;
        if (within(entry.pair.activation_distance, entry.pair, columns(x, entry.pair.vertices))) {
            if (entry.pair.stiffness == 0) surface.stiffen(entry.pair);
            active.push_back(entry.pair);
        } else {
            ++idle;
        }
    }
    if (idle > entries.size()) measure(x);
}

std::vector<ContactPair> PairBlocks::find_active(const ContactSurface& surface, const Positions& x,
                                                 double round_off, const Threads& threads) {
    if (blocks.empty()) return {};
    const std::vector<Box> moved_cells = cells.boxes(x - start);
    return from_blocks(threads, [&](Index b, std::vector<ContactPair>& active) {
        blocks[b].find_active(surface, x, moved_cells, round_off, active);
    });
}

}  // namespace sherd
