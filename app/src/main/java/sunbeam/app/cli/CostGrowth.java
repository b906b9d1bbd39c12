package sunbeam.app.cli;

import static sunbeam.precompute.plan.MethodSettings.INTERPOLATION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import sunbeam.app.cli.Meter.Measurement;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.spectrum.PeriodInterpolation;
import sunbeam.precompute.text.Text;

/**
 * Times of the thesis's methods over what its section 3.5 says they depend on: wavelengths, Taylor terms and bins of a neighborhood; and over
 * samples and periods of the patch. Each series has one quantity multiplied, by a factor relative to the thesis's choice.
 */
record CostGrowth(DiffractionSetup setup, Environment environment) {
    private static final Choices THESIS = Choices.none().with(PRESET, Preset.THESIS);
    private static final double STEP = 5e-9;
    private static final int TAYLOR_TERMS = 37;
    private static final double[] FACTORS = {0.25, 0.5, 1, 2};
    private static final int[] RADII = {1, 2, 3};
    private static final int[] SIDES = {1, 2, 4};

    /** One measurement of a series: a method's name and its quantity, times a factor, on a setup. */
    record Variant(String series, double factor, DiffractionSetup setup, Method method) {
        String name() {
            return Text.format("%s x %.3g", series, factor);
        }
    }

    List<Variant> variants() {
        List<Variant> all = new ArrayList<>();
        for (double factor : FACTORS) {
            all.add(full("wavelengths", factor, THESIS.with(WAVELENGTH_STEP, STEP / factor)));
            all.add(full("terms", factor, THESIS.with(TERMS, (int) Math.rint(TAYLOR_TERMS * factor))));
        }
        for (int radius : RADII) {
            all.add(full("bins", Math.pow((2 * radius + 1) / 3.0, 2), THESIS.with(RADIUS, radius)));
        }
        for (int side : SIDES) {
            DiffractionSetup finer = with(1, side);
            all.add(new Variant("full: samples", side * side, finer, FullMethod.of(THESIS)));
            DiffractionSetup repeated = with(side, 1);
            all.add(new Variant("full: periods", side * side, repeated, FullMethod.of(THESIS)));
            all.add(new Variant("nmm: periods", side * side, repeated, NmmMethod.TYPE.create(THESIS)));
            Choices linear = THESIS.with(INTERPOLATION, PeriodInterpolation.LINEAR);
            all.add(new Variant("pq, linear: periods", side * side, repeated, PqMethod.TYPE.create(linear)));
        }
        return all;
    }

    private Variant full(String quantity, double factor, Choices choices) {
        return new Variant("full: " + quantity, factor, setup, FullMethod.of(choices));
    }

    /** Returns the setup of {@code periods x periods} patches, each sample of which is {@code finer x finer} equal ones. */
    private DiffractionSetup with(int periods, int finer) {
        Patch patch = setup.patch();
        HeightMap map = patch.heights();
        int columns = map.columns() * periods * finer;
        int rows = map.rows() * periods * finer;
        double[] heights = new double[Math.multiplyExact(columns, rows)];
        Arrays.setAll(heights, i -> map.at(i % columns / finer % map.columns(), i / columns / finer % map.rows()));
        HeightMap other = new HeightMap(columns, rows, map.pitchX() / finer, map.pitchY() / finer, heights);
        Patch same = new Patch(
                patch.name(),
                other,
                other,
                patch.source(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                patch.repetition());
        return new DiffractionSetup(same, environment, setup.warning()).withLight(setup.cie());
    }

    /** Draws time over factor, a line for each series; rows are those of the variants. */
    static Plot plot(List<Variant> variants, List<Measurement> rows, int width) {
        Axis factor = Axis.logarithmic("factor of the quantity");
        Axis time = Axis.logarithmic("time per pixel / us");
        Plot plot = new Plot(new Plot.Frame(
                "Time over what it depends on", factor, time, width, (int) (BenchmarkPage.RATIO * width)));
        Map<String, Measurement> byName =
                rows.stream().collect(Collectors.toMap(Measurement::method, row -> row, (first, same) -> first));
        variants.stream().map(Variant::series).distinct().forEach(series -> {
            List<Variant> drawn = variants.stream()
                    .filter(variant -> variant.series().equals(series))
                    .filter(variant -> byName.containsKey(variant.name()))
                    .toList();
            plot.line(
                    series,
                    drawn.stream().mapToDouble(Variant::factor).toArray(),
                    drawn.stream()
                            .mapToDouble(
                                    variant -> 1e6 * byName.get(variant.name()).secondsPerPixel())
                            .toArray());
        });
        return plot;
    }

    /** Measures a variant without errors. */
    static Measurement measure(Meter meter, Variant variant) {
        return meter.measure(variant.setup(), variant.name(), variant.method(), Optional.empty());
    }
}
