// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/solver/lagged_system.h"
#include "core/solver/minimiser.h"
#include "core/solver/update_memory.h"
#include "core/state_visitor.h"

namespace sherd {

/// Quasi-Newton method: the factor of an earlier Hessian, turned with the motion, and what the last
/// iterations tell of the changes since. It factors anew when the iterations that it takes more than with a
/// new factor have cost more than one.
class QuasiNewton : public Minimiser {
  public:
    /// tolerance: m; the method has converged when the largest coordinate of the last correction, and what is
    /// left by the rate at which corrections fall, are below it.
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
        UpdateMemory updates{8};  ///< since the last factorization of this search
        double short_way = 0;     ///< m, see share_of_edge
        double round_off = 0;     ///< J, of the potential
        double last = 0;          ///< m, largest coordinate of the last correction; 0: of another factor
        double rate = 0;          ///< at which corrections have fallen
        int iterations = 0;       ///< with the present factor and patch
        int total = 0;            ///< with the present factor
        double last_exact = 0;    ///< m, largest coordinate of the last correction of a new factor
        bool exact = false;       ///< whether the factor is of x
        bool too_long = false;    ///< whether the last correction was, and not because of a contact
        bool is_old = false;      ///< whether the factor was made for another search
        bool each_anew = false;   ///< whether each correction gets a new factor, as in Newton's method

        /// What a correction with a factor of x says of how long factors last.
        void judge_factor(double correction);
    };

    void begin(const Potential& potential, const Positions& x, Search& search);
    /// Patches the factor where contacts have changed, or factors anew where that is likely to be cheaper.
    void refit(const Potential& potential, const Positions& x, Search& search);
    /// Whether a factorization is likely to cost less than the iterations ahead.
    bool is_slow(const Potential& potential, const Search& search) const;
    void factorize(const Potential& potential, const Positions& x, Search& search);
    /// The next correction, m, [3, V], and the slope along it, J; a slope that is not negative if even the
    /// Hessian at x gives none.
    Positions correction(const Potential& potential, const Positions& x, Search& search, double& slope);
    /// What is left of the way to the minimum, m, by the rate at which corrections fall.
    double left(const Positions& direction, Search& search);
    /// Moves x along the correction as far as the slope falls. Returns whether it moved.
    bool advance(const Potential& potential, const Positions& direction, double slope, Positions& x,
                 Search& search);
    void end(const Search& search);
    /// Iterations that take as long as a factorization.
    double iterations_per_factorization(const Potential& potential) const;

    double tolerance;
    LaggedSystem system;
    int fewest = 0;               ///< iterations of a search with the present factor; 0: there was none
    double spent = 0;             ///< iterations beyond those, since the factorization
    int anew = 0, anew_next = 1;  ///< searches that begin with a new factor, and half as many the next time
};

}  // namespace sherd
