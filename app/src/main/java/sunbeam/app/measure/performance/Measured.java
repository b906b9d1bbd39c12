package sunbeam.app.measure.performance;

import java.util.Optional;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * What a method costs on a surface, and how far off it is.
 *
 * @param name the method, with what distinguishes it
 * @param errors of X, Y, Z; nothing where they were not measured
 * @param makingSeconds from the heights to all that the shader reads, on the graphics card
 * @param bake where that time goes, for tables of colours
 * @param frameSeconds of one map
 * @param microseconds per pixel of it
 * @param bytes on the graphics card
 * @param remark what else there is to know; empty for nothing
 */
record Measured(
        String name,
        Optional<ErrorStatistics> errors,
        double makingSeconds,
        Optional<BakeTimes> bake,
        double frameSeconds,
        double microseconds,
        long bytes,
        String remark) {}
