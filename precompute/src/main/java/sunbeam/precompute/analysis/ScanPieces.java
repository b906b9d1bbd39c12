package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.patch.HeightMap;

/**
 * Pieces of a scan, each of which tells the period of a wave by itself: those between rows at which the scanner slipped, and
 * halves, which agree where the whole scan shows one grating.
 */
final class ScanPieces {
    // Between the peak of a piece and that of the whole, which a slip splits in two.
    private static final double FARTHEST_BINS = 2.5;

    private final ScanHalves halves;
    private final HeightMap map;
    private final SpectrumPeak whole;

    /** @param whole the wave's peak of the whole scan's spectrum */
    ScanPieces(ScanHalves halves, SpectrumPeak whole) {
        this.halves = halves;
        this.map = halves.whole();
        this.whole = whole;
    }

    /**
     * What the pieces between slips say that are large enough to, that of the most rows first.
     *
     * @param slips from top to bottom
     */
    List<PeriodEstimate> between(List<PeriodEstimate.Slip> slips) {
        List<HeightMap> pieces = new ArrayList<>();
        int first = 0;
        for (PeriodEstimate.Slip slip : slips) {
            pieces.add(ScanHalves.part(map, 0, map.columns(), first, slip.row()));
            first = slip.row();
        }
        pieces.add(ScanHalves.part(map, 0, map.columns(), first, map.rows()));
        return pieces.stream()
                .sorted(Comparator.comparingInt(HeightMap::rows).reversed())
                .flatMap(piece -> near(piece, ScanHalves.peaks(piece)).stream())
                .toList();
    }

    /**
     * What the whole scan says, widened where its halves, by rows and by columns, contradict it; with a drift where two halves
     * contradict each other.
     */
    PeriodEstimate comparedWithHalves(PeriodEstimate told) {
        List<List<SpectrumPeak>> peaks = halves.peaks();
        List<Optional<PeriodEstimate>> estimates = IntStream.range(0, peaks.size())
                .parallel()
                .mapToObj(number -> peaks.get(number).isEmpty()
                        ? Optional.<PeriodEstimate>empty()
                        : near(halves.half(number), peaks.get(number)))
                .toList();
        return compared(compared(told, estimates.get(0), estimates.get(1)), estimates.get(2), estimates.get(3));
    }

    /** What the whole scan says, widened where its halves contradict it; which of them is right is not known where many rows jump. */
    PeriodEstimate reachingHalves(PeriodEstimate told) {
        PeriodEstimate compared = comparedWithHalves(told);
        return told.within(compared.low(), compared.high());
    }

    private static PeriodEstimate compared(
            PeriodEstimate told, Optional<PeriodEstimate> first, Optional<PeriodEstimate> last) {
        List<PeriodEstimate> halves = new ArrayList<>();
        first.ifPresent(halves::add);
        last.ifPresent(halves::add);
        PeriodEstimate reaching = told.reaching(halves);
        return halves.size() == 2 && halves.get(0).contradicts(halves.get(1))
                ? reaching.drifting(halves.get(0).period(), halves.get(1).period())
                : reaching;
    }

    private Optional<PeriodEstimate> near(HeightMap piece, List<SpectrumPeak> peaks) {
        return peaks.stream()
                .filter(peak -> bins(peak, piece) <= FARTHEST_BINS)
                .min(Comparator.comparingDouble(peak -> bins(peak, piece)))
                .flatMap(peak -> PeriodEstimator.ofOnePiece(piece, peak));
    }

    /** A frequency and its opposite are one wave's. */
    private double bins(SpectrumPeak peak, HeightMap piece) {
        return Math.min(bins(peak, piece, 1), bins(peak, piece, -1));
    }

    private double bins(SpectrumPeak peak, HeightMap piece, int sign) {
        return Math.hypot(
                (sign * peak.frequencyX() - whole.frequencyX()) * piece.width(),
                (sign * peak.frequencyY() - whole.frequencyY()) * piece.height());
    }
}
