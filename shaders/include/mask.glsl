// Shadowing and masking of V-shaped cavities (Torrance and Sparrow 1967; Cook and Torrance 1982 eq. 8): min(1, 2 (n.h)(n.wr) / (wr.h), 2
// (n.h)(n.wi) / (wr.h)). With h along wi + wr and S = |wi + wr|^2, 2 (wr.h) is sqrt(S). So the second term is 4 (wi.z + wr.z) wr.z / S, and
// the third has wi.z instead of the last wr.z. The function returns the mask times S, which needs no division. square: S; cosineSum: wi.z +
// wr.z; smallerCosine: the smaller of wi.z and wr.z.
float maskedSquare(float square, float cosineSum, float smallerCosine) {
    return min(square, 4.0 * cosineSum * smallerCosine);
}
