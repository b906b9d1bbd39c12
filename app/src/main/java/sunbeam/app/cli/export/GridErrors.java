package sunbeam.app.cli.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import sunbeam.app.cli.options.ReportFields;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;

/**
 * Errors of a color grid at random pairs of directions, half uniform on the hemisphere and half aimed at orders: the largest difference of
 * three channels, X, Y, Z or bands, relative to the largest channel. There are more against sums over wavelengths, which are fast, than
 * against the exact reference.
 */
record GridErrors(String quantity, ErrorStatistics reference, ErrorStatistics sums) {
    private static final long SEED = 3;
    private static final int SUM_PAIRS = 1000;
    private static final int REFERENCE_PAIRS = 4;
    /** Limit of the exact reference's complex products: 20 s of processor time at 1e9 a second, less than a scan's table takes. */
    private static final double MOST_PRODUCTS = 2e10;
    // Limit of drawn pairs, uniform or aimed: some surfaces are dark nearly everywhere.
    private static final int MOST_TRIES = 20 * SUM_PAIRS;

    /**
     * Measures the errors of a grid as a reader of the file sees it.
     *
     * @param weights weights over wavelength of the compared numbers: those of the light, or of three bands
     * @param samples number of pairs for the reference; if empty, up to 4 within {@link #MOST_PRODUCTS}, at least 1
     */
    static GridErrors of(
            DiffractionSetup setup, GridBaker gridBaker, ColorGrid read, CieTable weights, Optional<Integer> samples) {
        boolean isLight = weights.equals(setup.cie());
        GaussianArea area = read.level().area();
        ColorGrid grid = isLight ? read : gridBaker.bake(weights, read.level(), read.shape());
        ExactLight exact = setup.withLight(weights).exact(new ReferenceMethod(area));
        ColorBaker baker = gridBaker.baker(weights, read.level());
        DirectionSampler sampler = new DirectionSampler(setup.patch().heights(), area.window(), SEED);
        Map<DirectionPair, Comparison> uniform = compare(grid, baker, sampler::uniform);
        Map<DirectionPair, Comparison> aimed = compare(grid, baker, sampler::aimed);
        List<Comparison> many = new ArrayList<>(uniform.values());
        many.addAll(aimed.values());
        List<DirectionPair> few =
                choose(List.copyOf(aimed.keySet()), List.copyOf(uniform.keySet()), exact::products, samples);
        List<Comparison> compared = setup.progress()
                .map("Exact colors", few, pair -> comparison(grid, pair, exact.xyz(pair, Quadrature.INTEGRATED)));
        String quantity = isLight ? "X, Y, Z" : "three of " + weights.description();
        return new GridErrors(quantity, Comparison.relative(compared), Comparison.relative(many));
    }

    /** Chooses pairs in turn from two lists: {@code count} of them, or up to 4 within {@link #MOST_PRODUCTS}, but at least 1. */
    static List<DirectionPair> choose(
            List<DirectionPair> aimed,
            List<DirectionPair> uniform,
            ToDoubleFunction<DirectionPair> products,
            Optional<Integer> count) {
        List<DirectionPair> inTurn = new ArrayList<>();
        for (int i = 0; i < Math.max(aimed.size(), uniform.size()); i++) {
            inTurn.addAll(aimed.subList(Math.min(i, aimed.size()), Math.min(i + 1, aimed.size())));
            inTurn.addAll(uniform.subList(Math.min(i, uniform.size()), Math.min(i + 1, uniform.size())));
        }
        List<DirectionPair> chosen = new ArrayList<>();
        double sum = 0;
        int most = Math.min(inTurn.size(), count.orElse(REFERENCE_PAIRS));
        for (DirectionPair pair : inTurn.subList(0, most)) {
            sum += products.applyAsDouble(pair);
            if (count.isPresent() || chosen.isEmpty() || sum <= MOST_PRODUCTS) {
                chosen.add(pair);
            }
        }
        return chosen;
    }

    /** Draws pairs until enough are bright, and compares the grid with direct sums there. */
    private static Map<DirectionPair, Comparison> compare(ColorGrid grid, ColorBaker baker, Supplier<Query> queries) {
        Map<DirectionPair, Comparison> bright = new LinkedHashMap<>();
        double lowest = Math.cos(grid.shape().largestAngle());
        for (int tried = 0; tried < MOST_TRIES && bright.size() < SUM_PAIRS / 2; tried += SUM_PAIRS / 2) {
            List<DirectionPair> pairs = Stream.generate(queries)
                    .limit(SUM_PAIRS / 2)
                    .map(Query::pair)
                    .filter(pair -> pair.cosThetaI() >= lowest && pair.cosThetaR() >= lowest)
                    .toList();
            float[] places = new float[3 * pairs.size()];
            for (int i = 0; i < pairs.size(); i++) {
                places[3 * i] = (float) pairs.get(i).u();
                places[3 * i + 1] = (float) pairs.get(i).v();
                places[3 * i + 2] = (float) pairs.get(i).w();
            }
            float[] xyz = baker.direct().bake(places, ColorBaker.Token.NONE);
            for (int i = 0; i < pairs.size() && bright.size() < SUM_PAIRS / 2; i++) {
                Comparison one = comparison(grid, pairs.get(i), Comparison.xyz(xyz, i));
                if (one.bright()) {
                    bright.put(pairs.get(i), one);
                }
            }
        }
        return bright;
    }

    /** @param exact exact X, Y, Z of the grid's level, before its scale is applied */
    private static Comparison comparison(ColorGrid grid, DirectionPair pair, double[] exact) {
        double scale = grid.level().scale();
        double[] scaled = {scale * exact[0], scale * exact[1], scale * exact[2]};
        return new Comparison(grid.xyz(pair.u(), pair.v(), pair.w()), scaled, scale);
    }

    Map<String, Object> fields() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("of", quantity + ": largest difference by the largest of them, where power exceeds 1e-9");
        fields.put("directions", "random pairs, half of them uniform on the hemisphere, half aimed at orders");
        fields.put("beside_reference", ReportFields.of(reference));
        fields.put("beside_sums_over_wavelengths", ReportFields.of(sums));
        return fields;
    }
}
