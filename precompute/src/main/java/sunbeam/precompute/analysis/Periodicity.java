package sunbeam.precompute.analysis;

import java.util.List;

/**
 * What repeats in a surface.
 *
 * @param edges as what the patch was analysed
 * @param peaks its regularities, the strongest (in height) first; empty when there is none
 * @param figure how clearly the clearest candidate stands out: power over the local background for a piece of a surface;
 *     share of the heights' variance, 0..1, for one period of a surface that repeats
 * @param threshold what the figure must reach
 */
public record Periodicity(HeightSpectrum.Edges edges, List<SpectrumPeak> peaks, double figure, double threshold) {
    public Periodicity {
        peaks = List.copyOf(peaks);
    }

    public boolean found() {
        return !peaks.isEmpty();
    }

    /** The figure in words, for people. */
    public String describeFigure() {
        return edges == HeightSpectrum.Edges.TAPERED
                ? String.format(
                        java.util.Locale.ROOT,
                        "the clearest peak of the power spectrum stands %.3g times above its surroundings, %.3g are"
                                + " needed, of periods that fit four times or more into the scan",
                        figure,
                        threshold)
                : String.format(
                        java.util.Locale.ROOT,
                        "the strongest frequency holds %.2g %% of the heights' variance, %.2g %% are needed",
                        100 * figure,
                        100 * threshold);
    }
}
