// Shadowing and masking of V-shaped cavities (Torrance and Sparrow 1967; Cook and Torrance 1982 eq. 8):
// min(1, 2 (n.h)(n.wr) / (wr.h), 2 (n.h)(n.wi) / (wr.h)). With |wi + wr| = 2 cosThetaD the half vector needs no
// normalisation of its own.
float cavityMask(vec3 wi, vec3 wr, float cosThetaD) {
    float cosHalf = (wi.z + wr.z) / (2.0 * cosThetaD);
    return min(1.0, 2.0 * cosHalf * min(wi.z, wr.z) / cosThetaD);
}
