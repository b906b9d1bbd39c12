package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;

/** A scan whose scanner slipped at some rows: each piece between them tells the period by itself. */
final class SlippedScan {
    /** Of a scanner. Where more rows jump, the surface has lines that know little of each other, and its strips tell. */
    static final int MOST_SLIPS = 3;

    // Between the peak of a piece and that of the whole, which a slip splits in two.
    private static final double FARTHEST_BINS = 2.5;

    private final HeightMap map;
    private final List<PeriodEstimate.Slip> slips;

    SlippedScan(HeightMap map, List<PeriodEstimate.Slip> slips) {
        this.map = map;
        this.slips = slips;
    }

    /**
     * What the piece of the most rows says, widened by what others say that contradict it; empty where no piece is large
     * enough.
     */
    Optional<PeriodEstimate> estimate(SpectrumPeak peak) {
        List<PeriodEstimate> told = pieces().stream()
                .sorted(Comparator.comparingInt(HeightMap::rows).reversed())
                .flatMap(piece -> estimate(piece, peak).stream())
                .toList();
        if (told.isEmpty()) {
            return Optional.empty();
        }
        PeriodEstimate first = told.get(0);
        double low = first.low();
        double high = first.high();
        for (PeriodEstimate other : told) {
            boolean apart = other.low() > first.high() || other.high() < first.low();
            low = apart ? Math.min(low, other.low()) : low;
            high = apart ? Math.max(high, other.high()) : high;
        }
        return Optional.of(first.of(slips, low, high));
    }

    private List<HeightMap> pieces() {
        List<HeightMap> pieces = new ArrayList<>();
        int first = 0;
        for (PeriodEstimate.Slip slip : slips) {
            addPiece(first, slip.row(), pieces);
            first = slip.row();
        }
        addPiece(first, map.rows(), pieces);
        return pieces;
    }

    private void addPiece(int from, int to, List<HeightMap> pieces) {
        double[] heights = new double[(to - from) * map.columns()];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = map.at(i % map.columns(), from + i / map.columns());
        }
        pieces.add(new HeightMap(map.columns(), to - from, map.pitchX(), map.pitchY(), heights));
    }

    private Optional<PeriodEstimate> estimate(HeightMap piece, SpectrumPeak whole) {
        return new PeriodFinder(piece, false)
                .all().peaks().stream()
                        .filter(peak -> bins(peak, whole, piece) <= FARTHEST_BINS)
                        .min(Comparator.comparingDouble(peak -> bins(peak, whole, piece)))
                        .flatMap(peak -> PeriodEstimator.ofOnePiece(piece, peak));
    }

    private static double bins(SpectrumPeak a, SpectrumPeak b, HeightMap piece) {
        return Math.hypot(
                (a.frequencyX() - b.frequencyX()) * piece.width(), (a.frequencyY() - b.frequencyY()) * piece.height());
    }
}
