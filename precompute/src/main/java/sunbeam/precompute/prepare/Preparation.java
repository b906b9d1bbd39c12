package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Lengths;

/** Preparation of a scan, in this order: crop, level, despike, fill missing samples, treat edges. */
public record Preparation(Optional<Crop> crop, Leveling leveling, boolean despike, Edges edges) {
    /**
     * Prepared scan.
     *
     * @param scan heights after cropping, leveling, despiking and filling
     * @param surface the scan with treated edges, from which light is diffracted
     * @param missing number of filled samples
     * @param steps descriptions of the steps with their numbers
     */
    public record Prepared(HeightMap scan, HeightMap surface, int missing, List<String> steps) {
        public Prepared {
            steps = List.copyOf(steps);
        }
    }

    /**
     * Prepares measured heights.
     *
     * @throws IllegalArgumentException when all samples are missing, or when {@link Crop#apply} throws it
     */
    public Prepared apply(HeightMap measured) {
        List<String> steps = new ArrayList<>();
        HeightMap field = crop.isPresent() ? crop.get().apply(measured) : measured;
        if (crop.isPresent()) {
            steps.add("cropped from " + rounded(measured.width()) + " x " + rounded(measured.height()));
        }
        field = leveling.apply(field);
        steps.add("levelling " + ValueKind.name(leveling));
        if (despike) {
            Spikes spikes = Spikes.remove(field);
            field = spikes.cleaned();
            steps.add(
                    spikes.count() == 0
                            ? "no spikes"
                            : spikes.count() + " spike samples removed, the highest by " + rounded(spikes.largest()));
        }
        MissingHeights.Filled filled = MissingHeights.fill(field);
        if (filled.count() > 0) {
            // Filled samples would bend a fitted plane, so only the mean is subtracted again.
            field = leveling == Leveling.NONE ? filled.field() : Leveling.MEAN.apply(filled.field());
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

    private static String rounded(double meters) {
        return Lengths.rounded(meters, 3);
    }
}
