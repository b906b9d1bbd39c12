package sunbeam.app.measure.benchmark;

import java.util.LinkedHashMap;
import java.util.Map;

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

    /** For programs. */
    Map<String, Object> fields(double thesisSeconds) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("label", contender.label());
        fields.put("plan", contender.description());
        fields.put("tableSeconds", tableSeconds);
        fields.put("uploadSeconds", uploadSeconds);
        fields.put("frameSeconds", frameSeconds);
        fields.put("microsecondsPerPixel", microsecondsPerPixel());
        fields.put("timesFasterThanThesis", thesisSeconds / frameSeconds);
        return fields;
    }

    double microsecondsPerPixel() {
        return 1e6 * frameSeconds / coveredPixels;
    }
}
