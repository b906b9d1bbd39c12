package sunbeam.app.measure.errors;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/**
 * How pixels of an animation change from a frame to the next, beside how the means of many points in each change. Pixels that
 * each show a point jump from order to order as a surface turns: they crawl, and change more than their means do.
 *
 * @param frames how far these pixels are from the means, in both frames
 * @param change mean CIEDE2000 of a pixel in a frame and in the next
 * @param exactChange the same of the means
 */
public record CrawlCertificate(SceneCertificate frames, double change, double exactChange) {
    /** By how much an animation may change more than the means do: a tenth is not seen beside what moves anyway. */
    public static final double EXCESS = 0.1;

    // Of CIEDE2000: what stands still may.
    private static final double STILL = 0.05;

    /**
     * A pixel.
     *
     * @param before in a frame
     * @param after in the next
     */
    record Change(Comparison before, Comparison after) {
        private double drawn(double exposure) {
            return new Comparison(after.computed(), before.computed(), 1).colorDifference(exposure);
        }

        private double exact(double exposure) {
            return new Comparison(after.exact(), before.exact(), 1).colorDifference(exposure);
        }
    }

    /** Of some pixels. */
    static CrawlCertificate of(List<Change> changes, double exposure) {
        return new CrawlCertificate(
                SceneCertificate.of(
                        changes.stream()
                                .flatMap(change -> Stream.of(change.before(), change.after()))
                                .toList(),
                        exposure),
                mean(changes, change -> change.drawn(exposure)),
                mean(changes, change -> change.exact(exposure)));
    }

    private static double mean(List<Change> changes, ToDoubleFunction<Change> difference) {
        return changes.stream().mapToDouble(difference).average().orElse(0);
    }

    /** Whether the animation crawls. */
    public boolean crawls() {
        // Written so that a NaN does.
        return !(change <= (1 + EXCESS) * exactChange + STILL);
    }

    /** Whether it crawls, or its frames are further from the means than they may be. */
    public boolean missed() {
        return frames.missed() || (frames.pixels() > 0 && crawls());
    }

    /** One line with all figures. */
    public String summary() {
        return frames.relative().count() == 0
                ? frames.summary()
                : String.format(
                        Locale.ROOT,
                        "%s; from a frame to the next CIEDE2000 changes by %.3g in the mean, by %.3g in the means of points%s",
                        frames.summary(),
                        change,
                        exactChange,
                        exactChange > STILL
                                ? String.format(Locale.ROOT, " (%.2f times)", change / exactChange)
                                : ", which is too little for eyes");
    }

    /** What was missed. */
    public String complaint() {
        return crawls()
                ? String.format(
                        Locale.ROOT,
                        "the animation crawls: from a frame to the next CIEDE2000 changes by %.3g in the mean, but by %.3g in the"
                                + " means of points",
                        change,
                        exactChange)
                : frames.complaint();
    }
}
