package sunbeam.app.measure.performance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.stream.IntStream;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.measure.benchmark.MapSamples;
import sunbeam.app.measure.benchmark.MapSamples.Sample;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.colourtable.TableDesign;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.TableArray;

/**
 * The look-up of Dhillon et al. 2014 as rows of the report: the error of its basis at places where its tables would have texels, so
 * that the grid adds nothing to it, and the time of its 2 N + 1 bilinear look-ups. Of all N the one that does best is
 * taken.
 */
final class TaylorLookUp {
    private static final List<Integer> LARGEST_N =
            IntStream.rangeClosed(1, 12).mapToObj(i -> 5 * i).toList();
    private static final int MOST_N = LARGEST_N.get(LARGEST_N.size() - 1);
    private static final int CHANNELS = 4;
    private static final long MOST_BYTES = 256L << 20;

    private final DiffractionSetup setup;
    private final GaussianArea area;

    /** @param area whose window counts; the look-up has colours of one coherence area */
    TaylorLookUp(DiffractionSetup setup, GaussianArea area) {
        this.setup = setup;
        this.area = new GaussianArea(area.window(), WindowOrigin.CENTRE, Average.COHERENT);
    }

    private record Best(int n, ErrorStatistics errors) {}

    /**
     * Its rows: in float32, as a graphics card has it, and in double precision.
     *
     * @param exact whose views it is measured at
     * @param tolerance of the table whose grid it takes
     */
    List<Measured> measure(Meter meter, MapSamples exact, double tolerance) {
        List<Sample> samples = exact.samples(FullMethod.within(tolerance).with(area));
        TaylorSeries series = new TaylorSeries(setup.surface().levels(), area.window(), MOST_N);
        ReferenceColor color = new ReferenceColor(
                new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin()),
                area.window(),
                setup.cie(),
                Quadrature.INTEGRATED);
        List<List<double[][]>> coefficients = samples.parallelStream()
                .map(sample -> sample.query().pair())
                .map(pair -> series.coefficients(pair.u(), pair.v(), color.nodes(pair), LARGEST_N))
                .toList();
        List<Measured> rows = new ArrayList<>();
        Best inFloat = best(samples, coefficients, TaylorSeries::inFloat);
        rows.add(row(inFloat, "float32", grid(meter, inFloat.n(), tolerance)));
        // Graphics cards have no textures of doubles: nothing to time.
        Best inDouble = best(samples, coefficients, TaylorSeries::inDouble);
        rows.add(row(inDouble, "double", new Grid(0, Double.NaN, "")));
        return rows;
    }

    /** Evaluates tables at a w. */
    private interface Sum {
        double[] at(double[][] coefficients, double w);
    }

    private static Best best(List<Sample> samples, List<List<double[][]>> coefficients, Sum sum) {
        BinaryOperator<Best> better =
                (one, other) -> other.errors().median() < one.errors().median() ? other : one;
        return IntStream.range(0, LARGEST_N.size())
                .mapToObj(k -> {
                    double[] errors = IntStream.range(0, samples.size())
                            .mapToDouble(i -> {
                                DirectionPair pair = samples.get(i).query().pair();
                                double[] xyz = sum.at(coefficients.get(i).get(k), pair.w());
                                return RelativeError.ofColor(xyz, samples.get(i).xyz());
                            })
                            .toArray();
                    return new Best(LARGEST_N.get(k), ErrorStatistics.of(errors));
                })
                .reduce(better)
                .orElseThrow();
    }

    private static Measured row(Best best, String numbers, Grid grid) {
        return new Measured(
                String.format(Locale.ROOT, "look-up of Dhillon et al. 2014, N = %d, %s", best.n(), numbers),
                Optional.of(best.errors()),
                Double.NaN,
                Optional.empty(),
                Double.NaN,
                grid.microseconds(),
                grid.bytes(),
                String.format(Locale.ROOT, "%d tables; error of the basis alone%s", 2 * best.n() + 1, grid.remark()));
    }

    /** What its tables take over the grid of a table of colours, and a look-up among them. */
    private record Grid(long bytes, double microseconds, String remark) {}

    private Grid grid(Meter meter, int n, double tolerance) {
        int tables = 2 * n + 1;
        double step = TableDesign.within(
                        tolerance, area, setup.patch().heights().relief())
                .step();
        int wanted = (int) Math.ceil(4 / step);
        int room = (int) Math.sqrt((double) MOST_BYTES / (tables * CHANNELS * Float.BYTES));
        int side = Math.min(wanted, room);
        String smaller = side < wanted
                ? String.format(Locale.ROOT, "; timed on tables of %d x %d texels, with fewer cache misses", side, side)
                : "";
        return new Grid(
                (long) wanted * wanted * tables * CHANNELS * Float.BYTES,
                meter.microseconds(tables(side, tables)),
                "; over all (u, v), any light" + smaller);
    }

    /** Numbers of the right size and count: what they are makes no difference to the time. */
    private static ShaderTables tables(int side, int tables) {
        ArrayLayout layout = ArrayLayout.layered("taylorTables", side, side, tables, CHANNELS)
                .linear();
        return new ShaderTables.Builder("taylor_look_up")
                .define("TAYLOR_TABLES", tables)
                .array(TableArray.computed(layout, layer -> {
                    float[] numbers = new float[layout.floatsPerLayer()];
                    Arrays.fill(numbers, 1f / (1 + layer));
                    return numbers;
                }))
                .build(1, 0);
    }
}
