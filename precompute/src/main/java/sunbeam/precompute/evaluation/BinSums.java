package sunbeam.precompute.evaluation;

import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.expansion.ChebyshevExpansion;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;

/**
 * Responses of a patch by the sums over DFT bins of design section 3, on the processor: what method {@code full}
 * computes on the GPU, with bins of float32 but sums in double precision. The bins around a direction are summed once
 * for any number of window positions, because a position only turns the bins' phases.
 *
 * <p>Relative error of the power about 1e-6 / sqrt(power): the expansion's remainder, bins beyond the neighborhood and
 * the rounding of the bins are each below 1e-7 of the mirror's amplitude. Immutable and safe for use by several threads.
 */
public final class BinSums {
    private static final double EXPANSION_TOLERANCE = 1e-7;
    // Half width of the neighborhood in standard deviations: what lies outside is exp(-6^2 / 2) = 1.5e-8.
    private static final double REACH = 6;

    private final ResponseGrid grid;
    private final Expansion expansion;
    private final FourierTable table;
    private final BinAxis alongX;
    private final BinAxis alongY;

    private BinSums(ResponseGrid grid, Expansion expansion, FourierTable table, BinAxis alongX, BinAxis alongY) {
        this.grid = grid;
        this.expansion = expansion;
        this.table = table;
        this.alongX = alongX;
        this.alongY = alongY;
    }

    /** Transforms the patch for the directions of a grid. */
    public static BinSums of(PatchIdentity patch, HeightLevels heights, CoherenceWindow window, ResponseGrid grid) {
        return of(patch, heights, window, grid, share -> {});
    }

    /**
     * Transforms the patch for the directions of a grid.
     *
     * @param transformed told the share, 0..1, of the transforms that are done
     */
    public static BinSums of(
            PatchIdentity patch,
            HeightLevels heights,
            CoherenceWindow window,
            ResponseGrid grid,
            DoubleConsumer transformed) {
        HeightScale scale = HeightScale.midRange(heights);
        double maximumPhase = scale.phase(grid.wavelengths()[0], grid.maximumW());
        Expansion expansion = ChebyshevExpansion.within(scale, maximumPhase, EXPANSION_TOLERANCE);
        BinAxis alongX = BinAxis.along(patch.width(), window, REACH);
        BinAxis alongY = BinAxis.along(patch.height(), window, REACH);
        double azimuth = grid.plane().azimuth();
        FourierTable table = new TableBuilder(
                        patch, heights, terms -> transformed.accept((double) terms / expansion.terms()))
                .build(expansion, alongX.band(grid, Math.cos(azimuth)), alongY.band(grid, Math.sin(azimuth)));
        return new BinSums(grid, expansion, table, alongX, alongY);
    }

    /** The mean over all positions of the window. */
    public ResponseMatrix ensemble(IntConsumer progress) {
        double[][] power = new double[grid.wavelengths().length][grid.angles().length];
        forEachDirection(progress, (row, column, bins) -> power[row][column] = bins.ensemblePower());
        return new ResponseMatrix(grid, power);
    }

    /** One response for each position of the window. */
    public List<ResponseMatrix> coherent(List<WindowPlace> places, IntConsumer progress) {
        int columns = table.patch().columns();
        int rows = table.patch().rows();
        // Rows run downwards, y upwards.
        double[][][] phasesX = places.stream()
                .map(place -> table.bandX().phases(columns, -place.column()))
                .toArray(double[][][]::new);
        double[][][] phasesY = places.stream()
                .map(place -> table.bandY().phases(rows, place.row()))
                .toArray(double[][][]::new);
        double[][][] power = new double[places.size()][grid.wavelengths().length][grid.angles().length];
        forEachDirection(progress, (row, column, bins) -> {
            for (int place = 0; place < power.length; place++) {
                power[place][row][column] = bins.coherentPower(phasesX[place], phasesY[place]);
            }
        });
        return IntStream.range(0, power.length)
                .mapToObj(place -> new ResponseMatrix(grid, power[place]))
                .toList();
    }

    @FunctionalInterface
    private interface Consumer {
        void accept(int row, int column, NearBins bins);
    }

    /** Visits all directions, rows in parallel; progress is told of every finished row. */
    private void forEachDirection(IntConsumer progress, Consumer consumer) {
        IntStream.range(0, grid.wavelengths().length).parallel().forEach(row -> {
            NearBins bins = new NearBins(table, alongX, alongY);
            for (int column = 0; column < grid.angles().length; column++) {
                load(bins, grid.wavelengths()[row], grid.angles()[column]);
                consumer.accept(row, column, bins);
            }
            progress.accept(1);
        });
    }

    private void load(NearBins bins, double wavelength, double angle) {
        GratingPlane plane = grid.plane();
        double frequency = plane.u(angle) / wavelength;
        double zeta = expansion.scale().phase(wavelength, -plane.w(angle));
        bins.moveTo(frequency * Math.cos(plane.azimuth()), frequency * Math.sin(plane.azimuth()));
        double[] coefficients = expansion.coefficients(zeta);
        for (int n = 0; n < coefficients.length; n++) {
            Complex turn = expansion.kind().turn(n);
            bins.add(n, turn.getReal() * coefficients[n], turn.getImaginary() * coefficients[n]);
        }
    }
}
