// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose steps are alternately implicit and explicit.
#include <gtest/gtest.h>

#include "fracture/step/simulation.h"
#include "meshops/error.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/mesh/tilted_square.h"

namespace sherd {
namespace {

/// A tilted square that falls onto a floor and bounces.
struct Fall {
    explicit Fall(double strength = 0) {
        sheet = test::tilted_square(0.5, {-0.5, -0.5, 0.006}, 0.2);
        sheet.material = {1000, 0.01, 1e9, 0.2};
        sheet.velocity = {0, 0, -2};
        if (strength > 0) sheet.strength = uniform_strength(strength);
        options.stepper.step = 2e-4;
        options.explicit_step = 2e-5;
        options.stepper.contact.obstacles = {test::floor(1e8)};
    }
    /// Calls look(report) after each step.
    template <class Look>
    void run(const Look& look) const {
        Simulation simulation({sheet}, options);
        while (simulation.time() < duration - 1e-9) look(simulation.step());
    }

    SheetInput sheet;
    SimulationOptions options;
    double duration = 0.02;  // s
};

struct Course {
    double explicit_time = 0, largest = 0, unexplained = 0, rises = 0, shortest = 1;
    int changes = 0, steps = 0, overwhelmed = 0;
    bool was_explicit = false;

    void add(const StepReport& report) {
        explicit_time += report.is_explicit ? report.step_size : 0;
        changes += report.is_explicit != was_explicit;
        was_explicit = report.is_explicit;
        largest = std::max(largest, report.kinetic + report.bending + report.membrane + report.contact);
        unexplained = std::max(unexplained, std::abs(report.unexplained));
        rises = std::max(rises, report.linear_momentum.z());
        shortest = std::min(shortest, report.step_size);
        overwhelmed += report.urgency == Urgency::explicit_failed;
        ++steps;
    }
};

Course course(const Fall& fall) {
    Course all;
    fall.run([&](const StepReport& report) { all.add(report); });
    return all;
}

// Implicit steps damp a bounce: steps must be explicit during an impact, and only during it.
TEST(AlternatingSteps, AreExplicitWhileSomethingStrikes) {
    Fall fall;
    const Course implicit = course(fall);
    fall.options.alternates = true;
    const Course both = course(fall);
    EXPECT_EQ(implicit.explicit_time, 0);
    EXPECT_GT(both.explicit_time, 5e-4);
    EXPECT_LT(both.explicit_time, 0.015);
    EXPECT_GE(both.changes, 2) << "they end again";
    EXPECT_GT(both.rises, 1.1 * implicit.rises) << "the bounce is kept";
    EXPECT_LT(both.unexplained, 1e-6 * both.largest);
    EXPECT_LE(both.shortest, 2e-5);
}

TEST(AlternatingSteps, CrackExplicitly) {
    Fall fall(0.05);
    fall.options.alternates = true;
    int failures = 0;
    fall.run([&](const StepReport& report) {
        failures += static_cast<int>(report.stages);
        EXPECT_TRUE(report.stages == 0 || report.is_explicit);
        EXPECT_LT(std::abs(report.unexplained), 1e-6 * 20);
    });
    EXPECT_GT(failures, 0);
}

/// A square that meets a box so fast that the springs of explicit contact cannot stop it.
Fall blow() {
    Fall fall;
    fall.sheet.velocity = {0, 0, -600};
    fall.options.stepper.step = 1e-5;
    fall.options.explicit_step = 1e-6;
    fall.options.stepper.contact.obstacles = {test::solid_box({0, 0, -0.5}, {0.5, 0.5, 0.5})};
    fall.duration = 4e-4;
    return fall;
}

// If implicit steps did not follow explicit steps that fail, a run with alternating schemes would end at an
// impact that implicit steps can solve.
TEST(AlternatingSteps, AreImplicitWhereExplicitOnesCannotGoOn) {
    Fall fall = blow();
    fall.options.stepper.scheme = Scheme::explicit_differences;
    fall.options.stepper.step = fall.options.explicit_step;
    EXPECT_THROW(course(fall), Error) << "else this is no such blow";
    fall = blow();
    fall.options.alternates = true;
    const Course both = course(fall);
    EXPECT_GE(both.overwhelmed, 1);
    EXPECT_GT(both.explicit_time, 0);
    EXPECT_LT(both.unexplained, 1e-6 * both.largest);
    EXPECT_GT(both.rises, 0) << "it is thrown back";
}

// Times of whole steps must be exact, so that frames are recorded when the scene asks for them.
TEST(AlternatingSteps, ComeBackToWholeSteps) {
    Fall fall;
    fall.options.alternates = true;
    double time = 0;
    fall.run([&](const StepReport& report) {
        time = report.time;
        if (!report.is_explicit) {
            EXPECT_NEAR(std::remainder(time, 2e-4), 0, 1e-12);
        }
    });
    EXPECT_EQ(time, 100 * 2e-4);
}

}  // namespace
}  // namespace sherd
