package sunbeam.app.commands.export;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.measure.errors.Comparison;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.text.Text;

/**
 * A grating in closed form as BRDF Explorer reads it: a function in GLSL, and parameters.
 *
 * @param patch that is such a grating
 * @param window of its light
 */
record GratingShader(ClosedForm form, Patch patch, CoherenceWindow window, CieTable light) {
    private static final int KNOTS = 81;
    private static final double KNOT_STEP = 5e-9;
    private static final int COMPARED = 1000;
    private static final long SEED = 4;
    private static final double SAME_METRES = 1e-13;

    /** @throws UsageException for patches without a closed form, and for light with lines */
    static GratingShader of(Patch patch, CoherenceWindow window, CieTable light) {
        ClosedForm form = Arrays.stream(ClosedForm.values())
                .filter(each -> each.name().toLowerCase(Locale.ROOT).equals(patch.name()))
                .filter(each -> isAsGenerated(patch))
                .findFirst()
                .orElseThrow(() -> new UsageException("--format brdf holds a formula, which of the surfaces only the"
                        + " built-in sinusoid, blaze and lamellar have as they are; " + patch.name()
                        + " needs another format, bsdf for example"));
        if (!light.isSmooth()) {
            throw new UsageException("--format brdf is for light as smooth as daylight, and this one ("
                    + light.description() + ") has lines; choose another, or another format");
        }
        return new GratingShader(form, patch, window, light);
    }

    /** Whether options have left the surface alone, but for where its heights are counted from. */
    private static boolean isAsGenerated(Patch patch) {
        HeightMap own = BuiltInPatches.generate(patch.name());
        HeightMap heights = patch.heights();
        return own.columns() == heights.columns()
                && own.rows() == heights.rows()
                && own.pitchX() == heights.pitchX()
                && own.pitchY() == heights.pitchY()
                && IntStream.range(0, own.columns() * own.rows())
                        .allMatch(i ->
                                Math.abs(own.heights()[i] - own.minimum() - heights.heights()[i] + heights.minimum())
                                        < SAME_METRES);
    }

    /** Mean over all positions of the window, for a wavelength in metres. */
    double power(DirectionPair pair, double wavelength) {
        double period = patch.heights().width();
        double sigma = window.sigmaFrequency();
        double phase = 2 * Math.PI * Math.abs(pair.w()) * form.heightMetres() / wavelength;
        double center = pair.u() / wavelength;
        double aside = pair.v() / wavelength / sigma;
        int first = (int) Math.floor(period * (center - 7 * sigma));
        int last = (int) Math.ceil(period * (center + 7 * sigma));
        return IntStream.rangeClosed(first, last)
                .mapToDouble(order -> {
                    double along = (center - order / period) / sigma;
                    return form.efficiency(order, phase) * Math.exp(-along * along - aside * aside);
                })
                .sum();
    }

    /** Of power at random pairs of directions, half of them aimed at orders. */
    ErrorStatistics errors(ExactLight exact) {
        DirectionSampler sampler = new DirectionSampler(patch.heights(), window, SEED);
        return Comparison.relative(Stream.concat(
                        Stream.generate(sampler::uniform).limit(COMPARED / 2),
                        Stream.generate(sampler::aimed).limit(COMPARED / 2))
                .toList()
                .parallelStream()
                .map(query -> Comparison.ofPower(
                        power(query.pair(), query.wavelength()), exact.power(query.pair(), query.wavelength())))
                .toList());
    }

    static String error(ErrorStatistics errors) {
        return "error of power: beside the reference at " + errors.count() + " pairs of directions " + errors;
    }

    String text(ErrorStatistics errors) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("PATCH", ShaderText.plain(patch.name()));
        values.put("LIGHT", ShaderText.plain(light.description()));
        values.put("ERROR", "At these values, " + error(errors));
        values.put("VERSION", Version.number());
        values.put("PERIOD", number(patch.heights().width() * 1e6));
        values.put("HEIGHT", number(form.heightMetres() * 1e9));
        values.put("RIDGE", form == ClosedForm.LAMELLAR ? "float ridge 0.05 0.95 0.5\n" : "");
        values.put("COHERENCE", number(window.coherenceLength() * 1e6));
        values.put("KNOTS", String.valueOf(KNOTS));
        values.put("TABLE", table());
        values.put("EFFICIENCY", form.shader());
        return ShaderText.filled(ShaderText.read("grating.brdf"), values);
    }

    private String table() {
        return IntStream.range(0, KNOTS).mapToObj(this::knot).collect(Collectors.joining(",\n"));
    }

    /** Linear Rec. 709 per nanometer. */
    private String knot(int knot) {
        double wavelength = CieTable.MINIMUM_WAVELENGTH + knot * KNOT_STEP;
        double scale = 1e-9 / light.integralOfY();
        double[] xyz = IntStream.range(0, 3)
                .mapToDouble(c -> scale * light.at(wavelength, c))
                .toArray();
        List<String> channels = IntStream.range(0, 3)
                .mapToObj(c -> Text.format("%.6e", Srgb.linear(c, xyz[0], xyz[1], xyz[2])))
                .toList();
        return "    vec3(" + String.join(", ", channels) + ")";
    }

    private static String number(double value) {
        return Text.format("%.6g", value);
    }
}
