// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/bending.h"
#include "core/membrane/membrane.h"

namespace sherd {

/// Whether a shell stays in its rest shape when it is disturbed. Under non-isometric motions a curved cubic
/// hinge can have less energy than at rest. The membrane outweighs this as long as the sheet is thin compared
/// with its edges (stretching stiffness well above bending stiffness, paper, section 8); otherwise the rest
/// shape is unstable. Instabilities that take longer than a tenth of a second to grow are tolerated. The 2007
/// model is judged by the cubic hinge in equilibrium: its own rest shape is no equilibrium, and where it
/// comes to rest membrane forces provide the correction that cubic_hinge() contains. What is a sum of squares
/// at rest is stable; so are cubic hinges when each is with its share of the membrane; of all else the
/// stiffness matrix at rest is factored.
bool stable_at_rest(const Shell& shell, BendingModel model = BendingModel::cubic,
                    MembraneModel membrane = MembraneModel::constant_strain);

}  // namespace sherd
