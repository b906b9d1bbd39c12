package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.Kinds;
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
     * Prepares heights as they were measured.
     *
     * @throws IllegalArgumentException when all samples are missing, or as {@link Crop#apply}
     */
    public Prepared apply(HeightMap measured) {
        List<String> steps = new ArrayList<>();
        HeightMap field = crop.isPresent() ? crop.get().apply(measured) : measured;
        if (crop.isPresent()) {
            steps.add("cropped from " + rounded(measured.width()) + " x " + rounded(measured.height()));
        }
        field = levelling.apply(field);
        steps.add("levelling " + Kinds.name(levelling));
        if (despike) {
            Spikes spikes = Spikes.removed(field);
            field = spikes.field();
            steps.add(
                    spikes.count() == 0
                            ? "no spikes"
                            : spikes.count() + " spike samples removed, the highest by " + rounded(spikes.largest()));
        }
        MissingHeights.Filled filled = MissingHeights.fill(field);
        if (filled.count() > 0) {
            // A plane fitted to filled samples would be bent by them; the mean is that of all samples again.
            field = levelling == Levelling.NONE ? filled.field() : Levelling.MEAN.apply(filled.field());
            steps.add(filled.count() + " missing samples filled");
        }
        HeightMap surface = edges.apply(field);
        if (edges == Edges.BLEND) {
            steps.add("edges blended over " + rounded(Edges.MARGIN * field.width()) + " x "
                    + rounded(Edges.MARGIN * field.height()) + " (a step of "
                    + rounded(Seam.of(field).jump()) + " rms)");
        }
        return new Prepared(field, surface, filled.count(), steps);
    }

    /** Three digits: more would be noise. */
    private static String rounded(double metres) {
        return Lengths.rounded(metres, 3);
    }
}
