// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Embree 4 or 3, whose calls for rays differ: no other file depends on the version.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sherd {

/// Finds the nearest hits of eight coherent rays; `valid`: -1 for each ray that counts, 0 for the others.
inline void find_nearest(const int* valid, RTCScene scene, RTCRayHit8& rays) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect8(valid, scene, &rays, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid, scene, &context, &rays);
#endif
}

/// Makes `tfar` of each occluded ray negative.
inline void find_occluded(const int* valid, RTCScene scene, RTCRay8& rays) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded8(valid, scene, &rays);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid, scene, &context, &rays);
#endif
}

}  // namespace sherd
