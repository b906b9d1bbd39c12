// Differences of (u, v, w) between neighboring pixels of geometry.frag's images, under the first light.

bool isSkin(ivec2 pixel, ivec2 size) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)) && texelFetch(views, pixel, 0).w != NO_SKIN;
}

mat3 frameAt(ivec2 pixel) {
    vec4 normal = texelFetch(normals, pixel, 0);
    vec3 tangent = texelFetch(tangents, pixel, 0).xyz;
    return mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz);
}

vec3 uvwAt(ivec2 pixel) {
    return diffractionVector(lightDirection(frameAt(pixel), 0), texelFetch(views, pixel, 0).xyz);
}

// Change of (u, v, w) per pixel along step: the mean of the differences on both sides, or the smaller one if the larger has more than three
// times its length, as across an edge of the skin.
vec3 uvwChange(ivec2 pixel, ivec2 step, vec3 uvw) {
    ivec2 size = textureSize(views, 0);
    bool hasNext = isSkin(pixel + step, size);
    bool hasLast = isSkin(pixel - step, size);
    vec3 next = hasNext ? uvwAt(pixel + step) - uvw : vec3(0.0);
    vec3 last = hasLast ? uvw - uvwAt(pixel - step) : vec3(0.0);
    if (!hasNext || !hasLast) {
        return next + last;
    }
    float nextLength = dot(next, next);
    float lastLength = dot(last, last);
    if (nextLength > 9.0 * lastLength) {
        return last;
    }
    return lastLength > 9.0 * nextLength ? next : 0.5 * (next + last);
}
