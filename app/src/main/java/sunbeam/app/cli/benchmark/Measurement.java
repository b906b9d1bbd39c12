package sunbeam.app.cli.benchmark;

import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.precompute.errors.ErrorStatistics;

/**
 * Cost and error of a method on a surface.
 *
 * @param method name that distinguishes the method from the others of the run
 * @param makingSeconds seconds from the heights to the tables on the graphics card
 * @param errors relative errors of X, Y, Z; without samples if not measured
 */
record Measurement(
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

    double timesFaster(Measurement other) {
        return other.microsecondsPerPixel() / microsecondsPerPixel();
    }

    Map<String, Object> fields() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", patch);
        fields.put("method", method);
        fields.put("pixels", timing.pixels());
        fields.put("making_s", makingSeconds);
        fields.put("frame_s", frameSeconds());
        fields.put("pixel_s", 1e-6 * microsecondsPerPixel());
        fields.put("bytes", bytes);
        fields.put("views", errors.count());
        fields.put("median_error_of_xyz", errors.median());
        fields.put("percentile_95_error_of_xyz", errors.percentile95());
        fields.put("maximum_error_of_xyz", errors.maximum());
        fields.put("plan", plan);
        return fields;
    }
}
