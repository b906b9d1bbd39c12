package sunbeam.precompute.analysis;

import java.util.List;
import sunbeam.precompute.units.Decimals;

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
        if (edges == HeightSpectrum.Edges.TAPERED && figure == 0) {
            return "the power spectrum has no maximum at all where four periods or more fit into the scan";
        }
        return edges == HeightSpectrum.Edges.TAPERED
                ? String.format(
                        java.util.Locale.ROOT,
                        "the clearest peak of the power spectrum stands %.3g times above its surroundings, %.3g are"
                                + " needed, of periods that fit four times or more into the scan",
                        figure,
                        threshold)
                : String.format(
                        java.util.Locale.ROOT,
                        "the strongest frequency holds %s %% of the heights' variance, %s %% are needed",
                        Decimals.rounded(100 * figure, 2),
                        Decimals.rounded(100 * threshold, 2));
    }
}
