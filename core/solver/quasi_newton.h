// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/solver/lagged_system.h"
#include "core/solver/minimiser.h"
#include "core/solver/update_memory.h"
#include "core/state_visitor.h"

namespace sherd {

/// Quasi-Newton method with the factor of an earlier Hessian, rotated with the motion, and the updates of the
/// last iterations (L-BFGS). It factorizes again when the iterations in excess of those with a new factor
/// have cost more than a factorization.
class QuasiNewton : public Minimiser {
  public:
    /// tolerance: m; the method has converged when the distance left to the minimum, by the rate at which
    /// corrections fall, is below a tenth of it.
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
        UpdateMemory updates{8};  ///< updates since the last factorization of this search
        double longest_move = 0;  ///< m, see share_of_edge
        double round_off = 0;     ///< J, round-off of the potential
        double last = 0;          ///< m, largest coordinate of the last correction; 0: of another factor
        double rate = 0;          ///< rate at which corrections have fallen
        int iterations = 0;       ///< number with the present factor and patch
        int total = 0;            ///< number with the present factor
        double last_exact = 0;    ///< m, largest coordinate of the last correction of a new factor
        bool exact = false;       ///< whether the factor is that of the Hessian at x
        bool too_long = false;    ///< whether the last correction was too long, and not because of a contact
        bool is_old = false;      ///< whether the factor was made for another search
        bool always_factorize = false;  ///< whether each correction gets a new factor, as in Newton's method

        /// Ends new factors for each correction if corrections with a factor of x fall fast.
        void assess_factor(double correction);
    };

    void begin(const Potential& potential, const Positions& x, Search& search);
    /// Patches the factor where contacts have changed, or factorizes again where that is likely to be
    /// cheaper.
    void refit(const Potential& potential, const Positions& x, Search& search);
    /// Whether a factorization is likely to cost less than the iterations ahead.
    bool is_slow(const Potential& potential, const Search& search) const;
    void factorize(const Potential& potential, const Positions& x, Search& search);
    /// The next correction, m, [3, V], and the slope along it, J; the slope is not negative if even the
    /// Hessian at x gives no descent.
    Positions correction(const Potential& potential, const Positions& x, Search& search, double& slope);
    /// Distance left to the minimum, m, by the rate at which corrections fall.
    double left(const Positions& direction, Search& search);
    /// Moves x along the correction as far as the slope falls. Returns whether it moved.
    bool advance(const Potential& potential, const Positions& direction, double slope, Positions& x,
                 Search& search);
    void end(const Search& search);
    /// Iterations that take as long as a factorization.
    double iterations_per_factorization(const Potential& potential) const;

    double tolerance;
    LaggedSystem system;
    int fewest = 0;    ///< fewest iterations of a search with the present factor; 0: no search yet
    double spent = 0;  ///< iterations in excess of those, since the factorization
    int fresh_searches = 0,
        next_fresh_searches = 1;  ///< searches to begin with a new factor, and half of the next number
};

}  // namespace sherd
