package sunbeam.app.measure.benchmark;

/**
 * What a contender took.
 *
 * @param contender who
 * @param tableSeconds Fourier tables, made anew
 * @param uploadSeconds resampling, shader compilation and upload
 * @param frameSeconds median over the frames
 * @param coveredPixels pixels of the disc
 * @param clock which clock said so
 */
record FrameTime(
        Contender contender,
        double tableSeconds,
        double uploadSeconds,
        double frameSeconds,
        int coveredPixels,
        String clock) {

    double microsecondsPerPixel() {
        return 1e6 * frameSeconds / coveredPixels;
    }
}
