// Mesa's software renderer ends all loops of a shader once they have made 65,535 steps together, without a word, and what
// was summed so far looks like a result. Two more steps tell.

// Always 2; a constant would be unrolled.
uniform int loopProbe;

// What a result is that no loop made whole; sunbeam.app.gpu.CutLoops knows it by its sign and size.
const float LOOPS_CUT = -1e30;

#ifdef FEW_LOOP_STEPS
// The method's loops are never as long.
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
