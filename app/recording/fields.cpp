// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/fields.h"

#include <fmt/format.h>

#include "meshops/error.h"

namespace sherd {

void require_field(const Eigen::Matrix3Xd& values, const std::string& name) {
    if (values.cols() == 0)
        throw Error(
            fmt::format("the recording does not have the {0} of its faces; run the scene again with "
                        "output.fields = [\"{0}\"], or --set 'output.fields=[\"{0}\"]'",
                        name));
}

}  // namespace sherd
