// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Quantity that the colours of a picture show.
enum class RenderColour { fragment, strain, speed, stress, curvature, axis, tips, material, none };

/// Whether a colouring shows a scalar, by a colour map.
bool is_scalar(RenderColour colour);

/// Returns the names of colourings as text, for example "strain, speed, stress or curvature".
std::string colour_names(std::span<const RenderColour> colours);

/// Returns the colouring of this name. Throws Error (input), with the names of `colours`, if `name` is none
/// of them.
RenderColour parse_render_colour(const std::string& name, std::span<const RenderColour> colours);

inline constexpr std::array render_colours{
    RenderColour::fragment, RenderColour::strain,    RenderColour::speed,
    RenderColour::stress,   RenderColour::curvature, RenderColour::axis,
    RenderColour::tips,     RenderColour::material,  RenderColour::none};
/// Colourings of an HTML page, whose meshes may be thinned and then have no velocities.
inline constexpr std::array view_colours{RenderColour::strain, RenderColour::stress, RenderColour::curvature,
                                         RenderColour::material};
inline constexpr std::array scalar_colours{RenderColour::strain, RenderColour::speed, RenderColour::stress,
                                           RenderColour::curvature, RenderColour::tips};

/// A scalar that is drawn by a colour map, and its unit; empty for other colourings.
struct RenderScalar {
    std::string name, unit;
    std::vector<double> values;  ///< [V] value at each vertex
};

/// Returns the scalar of a colouring at the vertices. Strain: mean of |strain| over the interior hinges at a
/// vertex, 1/m. Speed: m/s. Stress: largest principal stress of both surfaces, Pa. Curvature: largest
/// magnitude of a principal change of curvature, 1/m. Stress and curvature at a vertex are means over the
/// faces around it. Throws Error (input) if the frame does not have the field.
RenderScalar render_scalar(const Snapshot& frame, RenderColour colour);

/// Returns the colour of a fragment, 0xRRGGBB (sRGB). The first seven fragments have the colours of Okabe and
/// Ito (2008), which colour-blind people can tell apart; later fragments have lighter and darker versions of
/// these colours.
std::uint32_t fragment_colour(Index fragment);

/// Returns the colour at x, 0xRRGGBB (sRGB), of the perceptually uniform map viridis (N. Smith, S. van der
/// Walt, 2015). x is clamped to 0 to 1.
std::uint32_t map_colour(double x);

/// Returns the value below which the share `share` (0 to 1) of the values lie; 0 if there are no values.
double quantile(std::vector<double> values, double share);

}  // namespace sherd
