package sunbeam.app.cli.export;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import sunbeam.app.cli.DirectionSampler;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.gpu.BrdfMapRenderer.DiscDirections;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;
import sunbeam.precompute.work.Progress;

/**
 * Metadata that every output states; the grid is as a reader sees it, and a divisor means that energy is conserved.
 *
 * @param slopeDeviation standard deviation of slopes that the table averages over; 0 for none
 */
record TableMetadata(
        DiffractionSetup setup,
        Choices choices,
        ColorGrid grid,
        double slopeDeviation,
        GridErrors errors,
        Optional<EnergyDivisor> divisor) {
    private static final double FIRST_THETA = 30;
    /** Pixels along a side of the map whose exposure is chosen. */
    private static final int MAP_SIDE = 200;
    // Full width at half maximum of a Gaussian, in standard deviations.
    private static final double WIDTHS_PER_DEVIATION = 2 * Math.sqrt(2 * Math.log(2));

    /** Returns the full width at half maximum, in degrees, of an order at 550 nm near the normal. */
    double resolutionDegrees() {
        double sigma = grid.level().area().window().sigmaOfOrder(ColorTable.MIDDLE_WAVELENGTH);
        return Math.toDegrees(WIDTHS_PER_DEVIATION * sigma);
    }

    /** Returns the requested coherence length, meters; the table's own may be shorter. */
    double requestedCoherenceLength() {
        return choices.get(COHERENCE_LENGTH);
    }

    double coherenceLength() {
        return grid.level().area().window().coherenceLength();
    }

    /** Returns words on the width of the table's orders, and why they are wider than asked. */
    String blur() {
        if (slopeDeviation > 0) {
            return Text.format(
                    "light of a coherence length of %s, blurred by slopes of %.2g\u00b0",
                    Lengths.rounded(requestedCoherenceLength(), 3), Math.toDegrees(Math.atan(slopeDeviation)));
        }
        String asked = Lengths.rounded(requestedCoherenceLength(), 3);
        String own = Lengths.rounded(coherenceLength(), 3);
        return Text.format(
                "light of a coherence length of %s%s: an order is %.2g\u00b0 wide",
                own,
                own.equals(asked) ? "" : " (" + asked + " asked: sharper orders need a larger --size)",
                resolutionDegrees());
    }

    String summary() {
        GridShape shape = grid.shape();
        String orders = slopeDeviation > 0
                ? blur()
                : Text.format(
                        "coherence length %s (asked %s), orders %.2g degrees wide",
                        Lengths.rounded(coherenceLength(), 3),
                        Lengths.rounded(requestedCoherenceLength(), 3),
                        resolutionDegrees());
        return Text.format(
                "%s: %s, %d x %d x %d texels of u, v, w, angles to %.4g degrees",
                setup.patch().name(),
                orders,
                shape.u().count(),
                shape.v().count(),
                shape.depth().count(),
                Math.toDegrees(shape.largestAngle()));
    }

    String error() {
        String sums = "error of " + errors.quantity() + ": " + comparedWith("sums over wavelengths", errors.sums());
        return errors.reference().count() > 0
                ? sums + "; " + comparedWith("the reference", errors.reference())
                : sums + "; beside the reference at none (--samples gives their number)";
    }

    private static String comparedWith(String what, ErrorStatistics errors) {
        return "beside " + what + " at " + errors.pairs() + " " + errors;
    }

    /** Returns the angle of light with which an exported page begins, degrees. */
    double theta() {
        return Math.min(FIRST_THETA, Math.toDegrees(grid.shape().largestAngle()));
    }

    /** Returns the automatic exposure that {@code brdf-map} would choose for light at {@link #theta}. */
    double exposure() {
        DiscDirections directions = new DiscDirections(MAP_SIDE, Direction.ofDegrees(theta(), 0));
        float[] xyz = new float[ColorGrid.CHANNELS * MAP_SIDE * MAP_SIDE];
        for (int pixel = 0; pixel < MAP_SIDE * MAP_SIDE; pixel++) {
            DirectionPair pair = directions.at(pixel);
            if (pair.cosThetaR() > 0) {
                double gain = Gain.relativeRadiance(pair);
                double[] power = grid.xyz(pair.u(), pair.v(), pair.w());
                for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                    xyz[ColorGrid.CHANNELS * pixel + c] = (float) (gain * power[c]);
                }
            }
        }
        return LinearPicture.exposure(new LinearPicture(MAP_SIDE, MAP_SIDE, xyz));
    }

    Map<String, Object> fields(String quantity, String interpolation) {
        Map<String, Object> fields = fields();
        fields.put("quantity", quantity);
        fields.put("interpolation", interpolation);
        return fields;
    }

    Map<String, Object> fields() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("command", "export");
        fields.put("program", "sunbeam " + Environment.version());
        fields.put("patch", setup.patch().name());
        fields.put("patch_sha256", setup.patch().heights().digest());
        fields.put("average", "ensemble: mean over all positions of the coherence window");
        fields.put("window", "Gaussian, standard deviation a quarter of the coherence length");
        fields.put("coherence_length_m", slopeDeviation > 0 ? requestedCoherenceLength() : coherenceLength());
        if (slopeDeviation > 0) {
            fields.put("slope_deviation", slopeDeviation);
        }
        fields.put("coherence_length_asked_m", requestedCoherenceLength());
        fields.put("power_scale", grid.level().scale());
        fields.put("power_scale_is", "C by power under coherence_length_m: a mean over wider orders is lower");
        fields.put("order_width_deg", resolutionDegrees());
        fields.put("illuminant", choices.get(MethodSettings.ILLUMINANT));
        fields.put("wavelengths", choices.get(MethodSettings.WAVELENGTHS).toString());
        fields.put("observer", choices.get(MethodSettings.OBSERVER).label());
        Optional<EnergyBalance> energy =
                EnergyBalance.largest(setup.patch().scan(), RefractiveIndex.KERATIN, new Direction(0, 0, 1));
        fields.put(
                "light_sent_out_from_above_by_mirrors",
                energy.map(EnergyBalance::ratio).orElse(null));
        fields.put("light_sent_out_at_m", energy.map(EnergyBalance::wavelength).orElse(null));
        fields.put("energy", divisor.isPresent() ? "conserve: rho is divided by divisor(y, x of light)" : "scalar");
        fields.put(
                "unit",
                "1: a flat mirror in specular direction has X, Y, Z of the light with Y = 1 under the asked window");
        GridShape shape = grid.shape();
        fields.put("axes", List.of(axis("w", shape.depth(), -1), axis("v", shape.v(), 1), axis("u", shape.u(), 1)));
        fields.put(
                "directions",
                "(u, v, w) = -(wi + wr), unit vectors to light and viewer; x tangent, y bitangent, z normal");
        fields.put("largest_angle_deg", Math.toDegrees(grid.shape().largestAngle()));
        fields.put(
                "radiance",
                "rho = F(c)/F(1) K^2 / ((cos_i + cos_r)^2 cos_r) G C, c = |wi + wr| / 2, K = 2 c^2, F Schlick of 0.04, G = min(1, 2 (cos_i + cos_r) min(cos_i, cos_r) / K)");
        fields.put("error", errors.fields());
        return fields;
    }

    /** Replaces the light in the metadata of a table of bands. */
    static void putNoLight(Map<String, Object> fields) {
        fields.put("illuminant", "none: power is the same in all light");
        fields.put("observer", "none");
    }

    private static NamedAxis axis(String name, GridShape.Axis axis, int sign) {
        return new NamedAxis(name, sign * axis.first(), sign * axis.step(), axis.count());
    }

    private record NamedAxis(String name, double first, double step, int count) {}

    /**
     * Errors of a color grid at random pairs of directions, half uniform on the hemisphere and half aimed at orders: the largest difference of
     * three channels, X, Y, Z or bands, relative to the largest channel. There are more against sums over wavelengths, which are fast, than
     * against the exact reference.
     */
    record GridErrors(String quantity, ErrorStatistics reference, ErrorStatistics sums) {
        private static final long SEED = 3;
        private static final int SUM_PAIRS = 1000;
        private static final int REFERENCE_PAIRS = 4;
        /** Share of the table's time that sums over wavelengths may take, and that the exact reference may. */
        private static final double SHARE = 0.05;
        /** Complex products of the exact reference that a processor makes in a second. */
        private static final double PRODUCTS_PER_SECOND = 1e9;
        /** Pairs drawn at a time, of which the first are compared at any cost. */
        private static final int BATCH = 50;
        // Limit of drawn pairs, uniform or aimed: some surfaces are dark nearly everywhere.
        private static final int MOST_TRIES = 20 * SUM_PAIRS;

        /**
         * Measures the errors of a grid as a reader of the file sees it.
         *
         * @param weights weights over wavelength of the compared numbers: those of the light, or of three bands
         * @param samples number of pairs for the reference; if empty, up to 4
         * @param seconds time that the table took. Without {@code samples} each comparison takes at most {@link #SHARE} of it, but the
         *     first {@link #BATCH} pairs of each kind are compared with sums at any cost
         */
        static GridErrors of(
                DiffractionSetup setup,
                GridBaker gridBaker,
                ColorGrid read,
                CieTable weights,
                Optional<Integer> samples,
                double seconds) {
            boolean isLight = weights.equals(setup.cie());
            GaussianArea area = read.level().area();
            ColorGrid grid = isLight ? read : gridBaker.bake(weights, read.level(), read.shape());
            ExactLight exact = setup.withLight(weights).exact(new ReferenceMethod(area));
            ColorBaker baker = gridBaker.baker(weights, read.level());
            DirectionSampler sampler = new DirectionSampler(setup.patch().heights(), area.window(), SEED);
            double share = samples.isPresent() ? Double.POSITIVE_INFINITY : SHARE * seconds;
            Map<DirectionPair, Comparison> uniform = compare(grid, baker, sampler::uniform, share / 2);
            Map<DirectionPair, Comparison> aimed = compare(grid, baker, sampler::aimed, share / 2);
            List<Comparison> many = new ArrayList<>(uniform.values());
            many.addAll(aimed.values());
            double products = share * PRODUCTS_PER_SECOND * Runtime.getRuntime().availableProcessors();
            List<DirectionPair> few = choose(
                    List.copyOf(aimed.keySet()),
                    List.copyOf(uniform.keySet()),
                    exact::products,
                    samples.orElse(REFERENCE_PAIRS),
                    products);
            List<Comparison> compared = setup.progress()
                    .map("Exact colors", few, pair -> comparison(grid, pair, exact.xyz(pair, Quadrature.INTEGRATED)));
            String quantity = isLight ? "X, Y, Z" : "three of " + weights.description();
            return new GridErrors(quantity, Comparison.relative(compared), Comparison.relative(many));
        }

        /** Chooses up to {@code count} pairs in turn from two lists, whose products together do not exceed a limit. */
        static List<DirectionPair> choose(
                List<DirectionPair> aimed,
                List<DirectionPair> uniform,
                ToDoubleFunction<DirectionPair> products,
                int count,
                double mostProducts) {
            List<DirectionPair> inTurn = new ArrayList<>();
            for (int i = 0; i < Math.max(aimed.size(), uniform.size()); i++) {
                inTurn.addAll(aimed.subList(Math.min(i, aimed.size()), Math.min(i + 1, aimed.size())));
                inTurn.addAll(uniform.subList(Math.min(i, uniform.size()), Math.min(i + 1, uniform.size())));
            }
            List<DirectionPair> chosen = new ArrayList<>();
            double sum = 0;
            for (DirectionPair pair : inTurn.subList(0, Math.min(inTurn.size(), count))) {
                sum += products.applyAsDouble(pair);
                if (sum <= mostProducts) {
                    chosen.add(pair);
                }
            }
            return chosen;
        }

        /** Draws pairs until enough are bright or the time is over, and compares the grid with direct sums there. */
        private static Map<DirectionPair, Comparison> compare(
                ColorGrid grid, ColorBaker baker, Supplier<DirectionQuery> queries, double seconds) {
            long start = System.nanoTime();
            Map<DirectionPair, Comparison> bright = new LinkedHashMap<>();
            double lowest = Math.cos(grid.shape().largestAngle());
            for (int tried = 0; tried < MOST_TRIES && bright.size() < SUM_PAIRS / 2; tried += BATCH) {
                if (tried > 0 && 1e-9 * (System.nanoTime() - start) > seconds) {
                    break;
                }
                List<DirectionPair> pairs = Stream.generate(queries)
                        .limit(BATCH)
                        .map(DirectionQuery::pair)
                        .filter(pair -> pair.cosThetaI() >= lowest && pair.cosThetaR() >= lowest)
                        .toList();
                float[] places = new float[3 * pairs.size()];
                for (int i = 0; i < pairs.size(); i++) {
                    places[3 * i] = (float) pairs.get(i).u();
                    places[3 * i + 1] = (float) pairs.get(i).v();
                    places[3 * i + 2] = (float) pairs.get(i).w();
                }
                float[] xyz = baker.direct().bake(places, Progress.NONE);
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
            fields.put("beside_reference", JsonOption.fields(reference));
            fields.put("beside_sums_over_wavelengths", JsonOption.fields(sums));
            return fields;
        }
    }
}
