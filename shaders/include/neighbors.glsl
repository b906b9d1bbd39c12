// Differences of (u, v, w) between neighboring pixels of geometry.frag's images, under any light.

bool isSkin(ivec2 pixel, ivec2 size) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)) && texelFetch(views, pixel, 0).w != NO_SKIN;
}

mat3 frameAt(ivec2 pixel) {
    vec4 normal = texelFetch(normals, pixel, 0);
    vec3 tangent = texelFetch(tangents, pixel, 0).xyz;
    return mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz);
}

// Change of the tangent frame and of the direction to the viewer, in the frame, from one pixel to another; all zero if one shows no skin.
struct PixelChange {
    mat3 frame;
    vec3 view;
    float isKnown;
};

// Change from a pixel, whose frame and direction to the viewer are given, to the one at step.
PixelChange changeTo(ivec2 pixel, ivec2 step, mat3 frame, vec3 wr) {
    bool known = isSkin(pixel + step, textureSize(views, 0));
    ivec2 other = known ? pixel + step : pixel;
    float share = known ? 1.0 : 0.0;
    return PixelChange(share * (frameAt(other) - frame), share * (texelFetch(views, other, 0).xyz - wr), share);
}

// Change of (u, v, w) per pixel under a light, in world space: the mean of the differences on both sides, or the smaller one if the larger
// has more than three times its length, as across an edge of the skin. before: the change to the pixel on the other side.
vec3 uvwChange(PixelChange after, PixelChange before, vec3 towards) {
    vec3 next = -(towards * after.frame + after.view);
    vec3 last = towards * before.frame + before.view;
    float nextLength = dot(next, next);
    float lastLength = dot(last, last);
    bool hasBoth = after.isKnown * before.isKnown > 0.0;
    bool takesLast = hasBoth && nextLength > 9.0 * lastLength;
    bool takesNext = hasBoth && lastLength > 9.0 * nextLength;
    vec3 both = (hasBoth ? 0.5 : 1.0) * (next + last);
    return takesLast ? last : takesNext ? next : both;
}
