// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/schemes/time_scheme.h"

namespace sherd {

/// The backward differentiation formula of second order, with steps of any length (Hairer, Norsett, Wanner,
/// Solving Ordinary Differential Equations I, section III.5). Its first step is implicit Euler's. It damps
/// vibrations with periods of a few steps, and slower vibrations hardly.
class Bdf2 : public TimeScheme {
  public:
    StepContext begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                      double length) override;
    void topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) override;
    void finish(const StepContext& step, const Positions& x, Shell& shell) override;
    void visit_state(StateVisitor& visit) override {
        auto& [at_begin, previous, weights] = *this;
        visit(at_begin, previous, weights);
    }

  private:
    struct BodyState {
        Vector3d centre, velocity, angular_momentum;
        Matrix3d rotation;
    };
    /// State at the beginning of a step, in SI units.
    struct Beginning {
        double length = 0;  ///< s, length of the step; 0: no step yet
        Positions position, velocity;
        std::vector<BodyState> bodies;

        void visit_state(StateVisitor& visit) {
            auto& [length, position, velocity, bodies] = *this;
            visit(length, position, velocity, bodies);
        }
    };
    /// An origin of StepContext is now + before_last * (now - previous), with the values at the beginning of
    /// the open step and of the previous one. lag: the lag of StepContext over the step's length.
    struct Weights {
        double before_last = 0, lag = 1;
    };

    void put_origins(const Shell& shell, StepContext& step) const;
    BodyOrigin origin_of(const RigidBody& body, std::size_t number, double length) const;

    Beginning at_begin, previous;  ///< beginning of the open step, and of the last finished one
    Weights weights;               ///< weights of the open step
};

}  // namespace sherd
