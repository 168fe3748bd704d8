// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Embree 4 or 3. Their calls for rays differ; no other file depends on the version.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sherd {

/// Finds the nearest hits of eight coherent rays. valid: for each ray, -1 if the ray is to be traced, 0 if
/// not.
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

/// Makes `tfar` of each occluded ray negative. valid: as for find_nearest().
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
