// Shadowing and masking of V-shaped cavities (Torrance and Sparrow 1967; Cook and Torrance 1982 eq. 8):
// min(1, 2 (n.h)(n.wr) / (wr.h), 2 (n.h)(n.wi) / (wr.h)). With the half vector along wi + wr and S = |wi + wr|^2, 2 (wr.h) is
// sqrt(S), and either product 4 (wi.z + wr.z) (n.w) / S. Times S, which needs no division: the cosines' sum and the smaller of them.
float maskedSquare(float square, float cosineSum, float smallerCosine) {
    return min(square, 4.0 * cosineSum * smallerCosine);
}
