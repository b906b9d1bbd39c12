package sunbeam.app.cli.benchmark;

import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.precompute.errors.ErrorStatistics;

/**
 * What a method costs on a surface, and how far off it is.
 *
 * @param method its name, with what distinguishes it from others of the run
 * @param makingSeconds from the heights to all that the shader reads on the graphics card
 * @param errors of X, Y, Z, relative; of nothing where they are not measured
 */
record Measured(
        String patch,
        String method,
        String plan,
        double makingSeconds,
        long bytes,
        Meter.Timing timing,
        ErrorStatistics errors) {

    double frameSeconds() {
        return timing.seconds();
    }

    double microsecondsPerPixel() {
        return 1e6 * timing.seconds() / timing.pixels();
    }

    double timesFaster(Measured other) {
        return other.microsecondsPerPixel() / microsecondsPerPixel();
    }

    /** By name, for programs; SI units but for those that are named. */
    Map<String, Object> fields() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", patch);
        fields.put("method", method);
        fields.put("pixels", timing.pixels());
        fields.put("makingSeconds", makingSeconds);
        fields.put("frameSeconds", frameSeconds());
        fields.put("microsecondsPerPixel", microsecondsPerPixel());
        fields.put("bytes", bytes);
        fields.put("views", errors.count());
        fields.put("medianErrorOfXyz", errors.median());
        fields.put("percentile95ErrorOfXyz", errors.percentile95());
        fields.put("maximumErrorOfXyz", errors.maximum());
        fields.put("plan", plan);
        return fields;
    }
}
