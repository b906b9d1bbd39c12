package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Edges.Seam;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Lengths;

/** Preparation of a scan, in this order: crop, level, despike, fill missing samples, treat edges. */
public record Preparation(Optional<Crop> crop, Leveling leveling, boolean despike, Edges edges) {
    /** Prepared scan: before and after its edges are treated (light uses the latter), number of filled samples, words for the steps. */
    public record Prepared(HeightMap scan, HeightMap surface, int missing, List<String> steps) {
        public Prepared {
            steps = List.copyOf(steps);
        }
    }

    /** Prepares heights; throws IllegalArgumentException if all samples are missing, or as {@link Crop#apply}. */
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
            steps.add("edges blended over " + rounded(field.width() - surface.width()) + " x "
                    + rounded(field.height() - surface.height()) + " (a step of "
                    + rounded(Seam.of(field).jump()) + " rms)");
        }
        return new Prepared(field, surface, filled.count(), steps);
    }

    private static String rounded(double meters) {
        return Lengths.rounded(meters, 3);
    }

    /**
     * Fills missing samples (NaN or infinite) from their surroundings: ring by ring from the edge of each hole inwards, every sample becomes
     * the average of its known neighbors, eight at most. Linear in the number of samples.
     */
    record MissingHeights(HeightMap map, double[] heights) {
        public record Filled(HeightMap field, int count) {}

        public static Filled fill(HeightMap map) {
            int known =
                    (int) Arrays.stream(map.heights()).filter(Double::isFinite).count();
            int missing = map.heights().length - known;
            if (missing == 0) {
                return new Filled(map, 0);
            }
            if (known == 0) {
                throw new IllegalArgumentException("all " + missing + " samples are missing");
            }
            MissingHeights filling = new MissingHeights(map, map.heights().clone());
            filling.fillRings();
            return new Filled(map.with(filling.heights), missing);
        }

        private void fillRings() {
            int[] ring = IntStream.range(0, heights.length)
                    .filter(i -> !Double.isFinite(heights[i]) && neighbors(i, true).length > 0)
                    .toArray();
            while (ring.length > 0) {
                double[] averages =
                        Arrays.stream(ring).mapToDouble(this::averageOfKnown).toArray();
                for (int i = 0; i < ring.length; i++) {
                    heights[ring[i]] = averages[i];
                }
                ring = Arrays.stream(ring)
                        .flatMap(i -> Arrays.stream(neighbors(i, false)))
                        .distinct()
                        .toArray();
            }
        }

        private double averageOfKnown(int index) {
            int[] known = neighbors(index, true);
            double first = heights[known[0]];
            // A large offset costs no digits.
            return first
                    + Arrays.stream(known).mapToDouble(i -> heights[i] - first).sum() / known.length;
        }

        private int[] neighbors(int index, boolean known) {
            int row = index / map.columns();
            int column = index % map.columns();
            int[] found = new int[8];
            int length = 0;
            for (int r = Math.max(0, row - 1); r <= Math.min(map.rows() - 1, row + 1); r++) {
                for (int c = Math.max(0, column - 1); c <= Math.min(map.columns() - 1, column + 1); c++) {
                    int neighbor = r * map.columns() + c;
                    if (neighbor != index && Double.isFinite(heights[neighbor]) == known) {
                        found[length++] = neighbor;
                    }
                }
            }
            return Arrays.copyOf(found, length);
        }
    }
}
