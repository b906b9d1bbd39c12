// Linear interpolation in a row of a texture. Two fetches; the texture unit's bilinear filter would take four.

// place: position in texels, 0 at the center of the first.
vec4 betweenTexels(sampler2D table, float place, int row) {
    int last = textureSize(table, 0).x - 1;
    int below = clamp(int(floor(place)), 0, max(last - 1, 0));
    vec4 low = texelFetch(table, ivec2(below, row), 0);
    vec4 high = texelFetch(table, ivec2(min(below + 1, last), row), 0);
    return low + (place - float(below)) * (high - low);
}
