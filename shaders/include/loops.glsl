// Loop limit check. Mesa's software renderer silently ends all loops of a shader after 65,535 iterations together, and a partial sum looks
// like a result. After that limit a loop of two more iterations ends early, too, which shows it.

// Always 2; a constant would be unrolled.
uniform int loopProbe;

// Marks a result with a partial sum; sunbeam.app.gpu.UploadedTables refuses it.
const float LOOPS_CUT = -1e30;

#ifdef FEW_LOOP_STEPS
// The method's loops are always shorter.
bool loopsWereCut() {
    return false;
}
#else
bool loopsWereCut() {
    int steps = 0;
    for (int i = 0; i < loopProbe; ++i) {
        ++steps;
    }
    return steps < loopProbe;
}
#endif
