package sunbeam.app.measure.benchmark;

import java.util.Optional;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * What a contender took, and how far off it was.
 *
 * @param contender who
 * @param tableSeconds making what its shader reads anew: Fourier tables, and the baking of colours where it tabulates them
 * @param uploadSeconds upload and compilation of the shader
 * @param frameSeconds median over the frames
 * @param coveredPixels pixels of the disc
 * @param clock which clock said so
 * @param errors relative errors of X, Y, Z of power against the reference; nothing where they were not measured
 */
record FrameTime(
        Contender contender,
        double tableSeconds,
        double uploadSeconds,
        double frameSeconds,
        int coveredPixels,
        String clock,
        Optional<ErrorStatistics> errors) {

    double microsecondsPerPixel() {
        return 1e6 * frameSeconds / coveredPixels;
    }

    /** From the patch's heights to the first picture. */
    double firstFrameSeconds() {
        return tableSeconds + uploadSeconds + frameSeconds;
    }
}
