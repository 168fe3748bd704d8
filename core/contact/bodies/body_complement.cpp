// SPDX-License-Identifier: GPL-3.0-or-later
// The Schur complement of body_contact.h, and the vertices that it couples.
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/contact/bodies/body_contact.h"

namespace sherd {

std::vector<std::size_t> BodyContact::groups(const VectorXd& q, bool ahead) const {
    std::vector<std::size_t> group(steps.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto join = [&](std::size_t one, std::size_t other) {
        const auto [kept, gone] = std::minmax(group[one], group[other]);
        std::replace(group.begin(), group.end(), std::size_t{gone}, std::size_t{kept});
    };
    const std::vector<BodyPose> at_q = poses(q);
    for (const PointContact& contact : points) {
        if (!is_free(contact.other)) continue;
        const double size = started[contact.other].shape->bounds().diagonal().norm();
        if (overlap_of(contact, at_q, ahead ? ahead_of_contact * size : 0).depth > 0)
            join(contact.body, contact.other);
    }
    for (const SlidingContact& contact : sliding)
        if (is_free(contact.other)) join(contact.body, contact.other);
    for (const auto& pair : surfaces) {
        if (!is_free(pair->other)) continue;
        const double reach = 0.5 * (started[pair->body].shape->bounds().diagonal().norm() +
                                    started[pair->other].shape->bounds().diagonal().norm());
        const PairPlaces at = places_of(*pair, at_q);
        const bool close =
            ahead && (at.here.translation() - at.there.translation()).norm() < (1 + ahead_of_contact) * reach;
        if (close || !pair->sliding().empty() || pair->touch(at)) join(pair->body, pair->other);
    }
    return group;
}

void BodyContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    const Potential& here = solve(x);
    const Eigen::MatrixXd inverse = here.hessian.inverse();
    const std::vector<std::size_t> group = groups(best, false);
    for (std::size_t one = 0; one < steps.size(); ++one) {
        for (std::size_t other = 0; other < steps.size(); ++other) {
            if (group[one] != group[other]) continue;
            const Matrix6d block = inverse.block<6, 6>(6 * one, 6 * other);
            for (const auto& [a, terms] : here.bodies[one].vertex_terms) {
                const Matrix36d eliminated = terms.mixed * block;
                for (const auto& [b, others] : here.bodies[other].vertex_terms) {
                    if (b > a) break;
                    const Matrix3d part = -eliminated * others.mixed.transpose();
                    if (a != b)
                        hessian.add(a, b, part);
                    else
                        hessian.add(a, a, 0.5 * (part + part.transpose()));
                }
            }
        }
        for (const auto& [vertex, terms] : here.bodies[one].vertex_terms)
            hessian.add(vertex, vertex, terms.hessian);
        for (const auto& [vertices, part] : here.bodies[one].couplings)
            hessian.add(vertices[0], vertices[1], part);
    }
}

void BodyContact::add_contacts(const Positions& x, bool ahead,
                               std::vector<std::pair<Index, Index>>& pairs) const {
    const Potential& here = solve(x);
    // Bodies in contact transmit forces of the shell to each other.
    const std::vector<std::size_t> group = groups(best, ahead);
    std::map<std::size_t, std::set<Index>> vertices;
    for (std::size_t b = 0; b < steps.size(); ++b) {
        std::set<Index>& all = vertices[group[b]];
        for (const auto& [vertex, terms] : here.bodies[b].vertex_terms) all.insert(vertex);
        if (ahead) steps[b].add_near_vertices(x, part(best, b), all);
    }
    for (const auto& [first, all] : vertices)
        for (const Index a : all)
            for (const Index b : all) {
                if (b == a) break;
                pairs.emplace_back(a, b);
            }
}

}  // namespace sherd
