// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/bending.h"
#include "core/membrane/membrane.h"

namespace sherd {

/// Whether a shell stays in its rest shape when it is disturbed. Under non-isometric motions a curved cubic
/// hinge can have less energy than at rest. The membrane outweighs this as long as the sheet is thin compared
/// with its edges (stretching stiffness well above bending stiffness, paper, section 8); if it does not, the
/// rest shape is unstable. Instabilities that take longer than a tenth of a second to grow are tolerated. For
/// the 2007 model the result is for the corrected cubic hinge: the rest shape is no equilibrium of the 2007
/// model, and where its shell comes to rest, membrane forces provide the correction that cubic_hinge()
/// contains. Energies that are sums of squares at rest are stable; cubic hinges are stable if each hinge with
/// its share of the membrane is. In all other cases the stiffness matrix at rest is factorized.
bool stable_at_rest(const Shell& shell, BendingModel model = BendingModel::cubic,
                    MembraneModel membrane = MembraneModel::constant_strain);

}  // namespace sherd
