package sunbeam.precompute.analysis;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.patch.HeightMap;

/**
 * A scan's lower and upper, left and right half, and what repeats in each, which is looked for when it is first asked for: all waves
 * of a lattice are compared with the same halves. Safe for use by several threads.
 */
public final class ScanHalves {
    private final HeightMap map;
    private HeightSpectrum seen;
    private List<List<SpectrumPeak>> peaks;
    private FineWaves fine;

    /** @param map without missing samples */
    public ScanHalves(HeightMap map) {
        this(map, null);
    }

    /**
     * As {@link #ScanHalves(HeightMap)}, of a scan whose spectrum is there already.
     *
     * @param seen the whole scan's tapered spectrum
     */
    public ScanHalves(HeightMap map, HeightSpectrum seen) {
        this.map = map;
        this.seen = seen;
    }

    /** The whole scan. */
    public HeightMap whole() {
        return map;
    }

    /** Lower, upper, left, right; of those only that have peaks. */
    HeightMap half(int number) {
        int middleRow = map.rows() / 2;
        int middleColumn = map.columns() / 2;
        return switch (number) {
            case 0 -> part(map, 0, map.columns(), middleRow, map.rows());
            case 1 -> part(map, 0, map.columns(), 0, middleRow);
            case 2 -> part(map, 0, middleColumn, 0, map.rows());
            default -> part(map, middleColumn, map.columns(), 0, map.rows());
        };
    }

    /** Of the spectrum of each half. */
    synchronized List<List<SpectrumPeak>> peaks() {
        if (peaks == null) {
            peaks = IntStream.range(0, 4)
                    .parallel()
                    .mapToObj(number -> isLargeEnough(number) ? peaks(half(number)) : List.<SpectrumPeak>of())
                    .toList();
        }
        return peaks;
    }

    /** Of the whole scan. */
    synchronized FineWaves fineWaves() {
        if (fine == null) {
            seen = seen == null ? HeightSpectrum.of(map, HeightSpectrum.Edges.TAPERED) : seen;
            fine = FineWaves.of(map, seen);
        }
        return fine;
    }

    private boolean isLargeEnough(int number) {
        int columns = number < 2 ? map.columns() : map.columns() / 2;
        int rows = number < 2 ? map.rows() / 2 : map.rows();
        return columns >= 2 && rows >= 2;
    }

    static List<SpectrumPeak> peaks(HeightMap piece) {
        return new PeriodFinder(piece, false).all().peaks();
    }

    static HeightMap part(HeightMap map, int firstColumn, int endColumn, int firstRow, int endRow) {
        int columns = endColumn - firstColumn;
        double[] heights = new double[columns * (endRow - firstRow)];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = map.at(firstColumn + i % columns, firstRow + i / columns);
        }
        return new HeightMap(columns, endRow - firstRow, map.pitchX(), map.pitchY(), heights);
    }
}
