package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.units.Lengths;

/**
 * The steps, in their order: crop, level, spikes, missing samples, edges.
 *
 * @param crop the part that counts; all without it
 * @param levelling what is subtracted
 * @param despike whether spikes are taken away
 * @param edges what becomes of the border
 */
public record Preparation(Optional<Crop> crop, Levelling levelling, boolean despike, Edges edges) {
    // Of the heights' variance, in their plane: a hundredth of their roughness. A smaller tilt is chance or rounding.
    private static final double WORTH_SAYING = 1e-4;

    /**
     * A prepared scan.
     *
     * @param scan cropped, levelled, without spikes and without missing samples: what was measured
     * @param surface the same with its edges treated: what light sees
     * @param missing how many samples were missing and are filled
     * @param steps what was done, with its figures, a few words each
     */
    public record Prepared(HeightMap scan, HeightMap surface, int missing, List<String> steps) {
        public Prepared {
            steps = List.copyOf(steps);
        }
    }

    /**
     * The part of the scan that counts.
     *
     * @throws IllegalArgumentException as {@link Crop#apply}
     */
    public HeightMap cropped(HeightMap measured) {
        return crop.isPresent() ? crop.get().apply(measured) : measured;
    }

    /**
     * Prepares heights as they were measured.
     *
     * @throws IllegalArgumentException when all samples are missing, or as {@link #cropped}
     */
    public Prepared apply(HeightMap measured) {
        List<String> steps = new ArrayList<>();
        HeightMap field = cropped(measured);
        if (crop.isPresent()) {
            steps.add(String.format(
                    Locale.ROOT, "cropped from %s x %s", rounded(measured.width()), rounded(measured.height())));
        }
        Tilt tilt = Tilt.of(field);
        field = levelling.apply(field);
        steps.add("levelling " + levelling.label()
                + (levelling.takesTilt() && tilt.share() > WORTH_SAYING
                        ? String.format(Locale.ROOT, " (tilt of %s across the scan removed)", rounded(tilt.rise()))
                        : ""));
        if (despike) {
            Spikes spikes = Spikes.removed(field);
            field = spikes.field();
            steps.add(
                    spikes.count() == 0
                            ? "no spikes"
                            : String.format(
                                    Locale.ROOT,
                                    "%d spike samples removed, the highest by %s",
                                    spikes.count(),
                                    rounded(spikes.largest())));
        }
        MissingHeights.Filled filled = MissingHeights.fill(field);
        if (filled.count() > 0) {
            // A plane fitted to filled samples would be bent by them; the mean is that of all samples again.
            field = levelling == Levelling.NONE ? filled.field() : Levelling.MEAN.apply(filled.field());
            steps.add(String.format(Locale.ROOT, "%d missing samples filled", filled.count()));
        }
        HeightMap surface = edges.apply(field);
        if (edges == Edges.BLEND) {
            steps.add(String.format(
                    Locale.ROOT,
                    "edges blended over %s x %s (a step of %s rms)",
                    rounded(Edges.MARGIN * field.width()),
                    rounded(Edges.MARGIN * field.height()),
                    rounded(Seam.of(field).jump())));
        }
        return new Prepared(field, surface, filled.count(), steps);
    }

    /** Three digits: more would be noise. */
    private static String rounded(double metres) {
        return Lengths.rounded(metres, 3);
    }
}
