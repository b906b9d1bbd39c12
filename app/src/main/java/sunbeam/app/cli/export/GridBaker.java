package sunbeam.app.cli.export;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.MemoryException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthBand.SpectralBands;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.GaussianPyramid;
import sunbeam.precompute.colortable.RadialBaker;
import sunbeam.precompute.colortable.SlopeBaker;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.work.Progress;

/** Bakes color grids for the ensemble-averaged levels of a color table; coarser levels have wider orders (docs/color-tables.md). */
final class GridBaker {
    /** Limit of an output's size: {@code most} bytes on disk, and a fraction of Java's heap in memory. */
    record Limit(TableWriter writer, Path output, long most) {
        // A table may take this fraction of Java's heap; a writer needs as much again for its copy.
        private static final int HEAP_SHARE = 3;

        void requireRoom(long bytes) {
            AtomicFile.requireRoom(output, bytes, "it may take", "give a --size that is less");
        }

        /** True if a table of this shape may fit on disk and in memory, by a lower bound of its size. */
        boolean mayHold(GridShape shape) {
            long bytes = writer.leastBytes(shape);
            if (bytes > most) {
                return false;
            }
            requireRoom(bytes);
            return fitsMemory(shape);
        }

        private boolean fitsMemory(GridShape shape) {
            long numbers = writer.numbers(shape);
            return numbers < Integer.MAX_VALUE
                    && numbers * Float.BYTES < Runtime.getRuntime().maxMemory() / HEAP_SHARE;
        }

        RuntimeException refusal(GridShape coarsest) {
            long bytes = writer.leastBytes(coarsest);
            String least = " holds no table of this surface: that of the widest orders takes at least "
                    + ByteSize.format(bytes) + "; ";
            return bytes > most || fitsMemory(coarsest)
                    ? new UsageException("--size " + ByteSize.format(most) + least + "give more")
                    : new MemoryException("Java's memory" + least + "allow more with SUNBEAM_JAVA_OPTIONS=-Xmx8g");
        }
    }

    private final DiffractionSetup setup;
    private final ColorTablePlan plan;
    private final PowerSpectrum spectrum;
    private final List<ColorTable.Level> levels;
    // Made for the first baker that needs it.
    private GaussianPyramid pyramid;

    /** @param plan plan with the ensemble average */
    GridBaker(DiffractionSetup setup, ColorTablePlan plan) {
        this.setup = setup;
        this.plan = plan;
        this.spectrum = PowerSpectrum.of(
                setup.fourier(plan.spectrum().orElseThrow()), new ErrorBudget(plan.tolerance()).powerBasis());
        List<ColorTable.Level> all = plan.table().levels();
        this.levels = all.subList(plan.table().pointLevelCount(), all.size());
    }

    /**
     * Returns the finest grid within a size limit; refuses to if not even the coarsest fits. It tries levels from coarse to fine; each grid
     * covers only the part of the (u, v) plane in which the coarser grid before it has light.
     */
    ColorGrid finest(double largestAngle, Limit limit) {
        ColorTable.Level widest = levels.get(levels.size() - 1);
        GridShape.Box all = GridShape.Box.of(GridShape.REACH * Math.sin(largestAngle));
        GridShape.Box box = bake(setup.cie(), widest, GridShape.of(plan, widest, all, largestAngle))
                .brightBox();
        ColorGrid best = null;
        for (int number = levels.size() - 1; number >= 0; number--) {
            ColorTable.Level level = levels.get(number);
            GridShape shape = limit.writer().fit(GridShape.of(plan, level, box, largestAngle));
            ColorGrid grid = limit.mayHold(shape) ? bake(setup.cie(), level, shape) : null;
            if (grid == null || bytes(grid, limit) > limit.most()) {
                if (best == null) {
                    throw limit.refusal(shape);
                }
                break;
            }
            best = grid;
            box = grid.brightBox();
        }
        return best;
    }

    /** Returns the size of the file, for which some formats compress the whole grid. */
    private long bytes(ColorGrid grid, Limit limit) {
        try (Progress progress = setup.progress().start("Size of the " + label(grid.level()), 1)) {
            long bytes = limit.writer().bytes(grid);
            progress.step(1);
            return bytes;
        }
    }

    private String label(ColorTable.Level level) {
        return "grid " + (levels.size() - levels.indexOf(level)) + " of " + levels.size() + " at most";
    }

    /** Returns how often the width of the grid's orders can be doubled: two levels each time. */
    int doublings(ColorGrid grid) {
        return (levels.size() - 1 - levels.indexOf(grid.level())) / 2;
    }

    /** Returns the grid of the same part of the plane, with orders and texels {@code 2^doublings} times as wide. */
    ColorGrid coarser(ColorGrid grid, int doublings) {
        ColorTable.Level wider = levels.get(levels.indexOf(grid.level()) + 2 * doublings);
        return bake(setup.cie(), wider, grid.shape().coarser(1 << doublings));
    }

    /** Returns grids with the same texels that hold spectral bands in place of X, Y, Z, {@link SpectralBands#TOGETHER} each. */
    List<ColorGrid> bands(ColorGrid grid, SpectralBands bands) {
        return IntStream.range(0, bands.tables())
                .mapToObj(number -> bake(bands.table(number), grid.level(), grid.shape()))
                .toList();
    }

    ColorGrid bake(CieTable functions, ColorTable.Level level, GridShape shape) {
        ColorGrid grid = ColorGrid.empty(level, shape);
        try (Progress progress = setup.progress().start("Colors, " + label(level), shape.evaluated())) {
            grid.bake(baker(functions, level), progress);
        }
        return grid;
    }

    /** Standard deviation of the slopes of fine relief that all grids average over; 0 for none. */
    double slopeDeviation() {
        return plan.table().slopeDeviation();
    }

    /** Returns the baker of a level; its direct sums over wavelengths serve to measure a grid's error. */
    ColorBaker baker(CieTable functions, ColorTable.Level level) {
        if (slopeDeviation() > 0) {
            pyramid = pyramid == null ? new GaussianPyramid(spectrum, plan.table()) : pyramid;
            return new SlopeBaker(spectrum, functions, pyramid, plan.table(), levels.indexOf(level));
        }
        boolean isFinest = level.area().equals(plan.table().area());
        return new RadialBaker(spectrum, functions, level.area(), level.design(), GridShape.REACH, isFinest);
    }
}
