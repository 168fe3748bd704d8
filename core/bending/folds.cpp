// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/folds.h"

#include <algorithm>

namespace sherd {

std::array<Index, 4> Folds::vertices(Index fold) const {
    if (fold < folds_of_edges()) {
        const auto [from, to, apex] = mirrors.vertices(fold);
        return {from, to, apex, -1};
    }
    return shell.hinges[shell.edge_hinge[fold - folds_of_edges()]].vertices;
}

void Folds::collect(Index fold, std::vector<Index>& collected) const {
    for (const Index vertex : vertices(fold))
        if (vertex >= 0 && std::ranges::find(collected, vertex) == collected.end())
            collected.push_back(vertex);
}

double Folds::rest_angle(Index fold) const {
    if (fold < folds_of_edges()) return hinge_angle(mirrors.rest(fold));
    const Index hinge = shell.edge_hinge[fold - folds_of_edges()];
    return hinge < 0 ? 0 : shell.hinges[hinge].rest.angle;
}

VectorXd Folds::rest_angles() const {
    VectorXd all(size());
    for (Index fold = 0; fold < static_cast<Index>(all.size()); ++fold) all[fold] = rest_angle(fold);
    return all;
}

VectorXd Folds::angles(const Positions& x) const {
    VectorXd all = VectorXd::Zero(size());
    for (std::size_t m = 0; m < mirrors.size(); ++m)
        all[static_cast<Eigen::Index>(m)] = hinge_angle(mirrors.with_image(m, x));
    for (std::size_t h = 0; h < shell.hinges.size(); ++h)
        all[folds_of_edges() + shell.hinge_edge[h]] = hinge_angle(columns(x, shell.hinges[h].vertices));
    return all;
}

std::vector<Folds::Slope> Folds::slopes(const Positions& x) const {
    std::vector<Slope> all(size());
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        all[m] = {vertices(static_cast<Index>(m)), DihedralAngle(mirrors.with_image(m, x)).gradient()};
        all[m].gradient.col(2) += mirrors.reflection(m) * all[m].gradient.col(3);
    }
    for (std::size_t h = 0; h < shell.hinges.size(); ++h) {
        const std::array<Index, 4>& of_hinge = shell.hinges[h].vertices;
        all[folds_of_edges() + shell.hinge_edge[h]] = {of_hinge,
                                                       DihedralAngle(columns(x, of_hinge)).gradient()};
    }
    return all;
}

void Folds::follow(const ShellChange& change, VectorXd& angles) const {
    const Eigen::Index known = angles.size();
    angles.conservativeResize(size());
    angles.tail(angles.size() - known).setZero();
    for (const auto& [edge, parents] : change.edges)
        if (shell.edge_hinge[edge] >= 0)
            angles[folds_of_edges() + edge] = rest_angle(folds_of_edges() + edge);
}

void Folds::add_gradient(const Positions& x, const VectorXd& of_angles, Positions& gradient) const {
    const std::vector<Slope> all = slopes(x);
    const auto add = [&](Index fold) {
        const Slope& slope = all[fold];
        for (int v = 0; v < 4; ++v)
            if (slope.vertices[v] >= 0)
                gradient.col(slope.vertices[v]) += of_angles[fold] * slope.gradient.col(v);
    };
    for (Index m = 0; m < folds_of_edges(); ++m) add(m);
    for (const Index edge : shell.hinge_edge) add(folds_of_edges() + edge);
}

void Folds::add_hessian(const Positions& x, const VectorXd& of_angles, BlockMatrix& hessian) const {
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        HingeHessian full = HingeHessian::Zero();
        DihedralAngle(mirrors.with_image(m, x)).add_hessian(of_angles[static_cast<Eigen::Index>(m)], full);
        add_element(hessian, mirrors.vertices(m), mirrors.folded(m, full));
    }
    for (std::size_t h = 0; h < shell.hinges.size(); ++h) {
        const std::array<Index, 4>& of_hinge = shell.hinges[h].vertices;
        HingeHessian full = HingeHessian::Zero();
        DihedralAngle(columns(x, of_hinge))
            .add_hessian(of_angles[folds_of_edges() + shell.hinge_edge[h]], full);
        add_element(hessian, of_hinge, full);
    }
}

std::vector<MirrorGradient> Folds::mirror_gradients(const Positions& x, const VectorXd& of_angles) const {
    std::vector<MirrorGradient> gradients;
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        HingePositions slope = DihedralAngle(mirrors.with_image(m, x)).gradient();
        slope.col(2) += mirrors.reflection(m) * slope.col(3);
        gradients.push_back(
            {vertices(static_cast<Index>(m)), of_angles[static_cast<Eigen::Index>(m)] * slope});
    }
    return gradients;
}

}  // namespace sherd
