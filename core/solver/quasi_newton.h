// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/solver/lagged_system.h"
#include "core/solver/minimiser.h"
#include "core/solver/update_memory.h"
#include "core/state_visitor.h"

namespace sherd {

/// Quasi-Newton method with the factor of an earlier Hessian, rotated with the motion, and the updates of the
/// last iterations (L-BFGS). It factorizes again when searches have taken so many more iterations than with a
/// new factor that these have cost more than a factorization.
class QuasiNewton : public Minimiser {
  public:
    /// tolerance: m; the method has converged when the distance left to the minimum, estimated from the rate
    /// at which corrections fall, is below a tenth of the tolerance.
    explicit QuasiNewton(double tolerance = 1e-9, Threads threads = Threads())
        : tolerance(tolerance), system(std::move(threads)) {}
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x) override;
    MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) override;
    void set_tolerance(double value) override { tolerance = value; }
    void visit_state(StateVisitor& visit) override;

  private:
    /// The state of one minimisation.
    struct Search {
        Positions gradient;       ///< N, at x
        UpdateMemory updates{8};  ///< updates since the last factorization or patch
        double longest_move = 0;  ///< m, see share_of_edge
        double round_off = 0;     ///< J, round-off of the potential
        double last = 0;          ///< m, largest coordinate of the last correction; 0: unknown
        double rate = 0;          ///< ratio of the last correction to the one before; 0: unknown
        int iterations = 0;       ///< number of iterations with the present factor and patch
        int total = 0;            ///< number of iterations with the present factor
        double last_exact = 0;    ///< m, largest coordinate of the last correction with an exact factor
        bool exact = false;       ///< whether the factor is that of the Hessian at x
        bool too_long = false;    ///< whether the last correction was too long, and not because of a contact
        bool is_old = false;      ///< whether the factor was made in an earlier search
        bool always_factorize = false;  ///< whether each correction gets a new factor, as in Newton's method

        /// Clears always_factorize if `correction`, m, the largest coordinate of a correction with an exact
        /// factor, is far smaller than the one before.
        void assess_factor(double correction);
    };

    void begin(const Potential& potential, const Positions& x, Search& search);
    /// Patches the factor where contacts have changed, or factorizes again if that is likely to be cheaper.
    void refit(const Potential& potential, const Positions& x, Search& search);
    /// Whether a factorization is likely to cost less than the iterations ahead.
    bool is_slow(const Potential& potential, const Search& search) const;
    void factorize(const Potential& potential, const Positions& x, Search& search);
    /// Returns the next correction, m, [3, N], and sets `slope`, J, the derivative of the potential along it;
    /// the slope is not negative if even the Hessian at x gives no descent.
    Positions correction(const Potential& potential, const Positions& x, Search& search, double& slope);
    /// Returns the distance left to the minimum after the correction `direction`, m, estimated from the rate
    /// at which corrections fall, and updates this rate.
    double left(const Positions& direction, Search& search);
    /// Moves x along the correction `direction` as far as the potential falls. Returns whether x has moved.
    bool advance(const Potential& potential, const Positions& direction, double slope, Positions& x,
                 Search& search);
    void end(const Search& search);
    /// Number of iterations that take as long as computing and factorizing a Hessian.
    double iterations_per_factorization(const Potential& potential) const;

    double tolerance;
    LaggedSystem system;
    int fewest = 0;  ///< fewest iterations of a search with the present factor; 0: no search yet
    /// Number of iterations of all searches since the factorization, less `fewest` for each search.
    double spent = 0;
    /// Number of coming searches that begin with a new factor, and half of the number to be set next.
    int fresh_searches = 0, next_fresh_searches = 1;
};

}  // namespace sherd
