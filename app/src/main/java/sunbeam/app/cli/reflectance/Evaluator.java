package sunbeam.app.cli.reflectance;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.measure.errors.Certificate;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.MethodSettings.FresnelFactor;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;
import sunbeam.precompute.shader.ShaderTables;

/** Evaluates rows of directions: with a wavelength to coherent and ensemble power, rho and BRDF; without, to X, Y, Z and gain. */
record Evaluator(DirectionList list, ProgressDisplay display) {
    private static final int RHO = 2;
    private static final int BRDF = 3;
    private static final int GAIN = 3;

    List<double[]> evaluate(ShaderTables tables) {
        List<Query> queries = IntStream.range(0, list.size())
                .mapToObj(row -> new Query(list.pair(row), list.spectral() ? list.wavelength(row) : 0))
                .toList();
        try (RenderContext context = RenderContext.offscreen();
                UploadedTables method = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, list.spectral());
                ProgressDisplay.Progress progress = display.start("Directions", list.size())) {
            return renderer.evaluate(queries, progress::step).stream()
                    .map(values -> new double[] {values[0], values[1], values[2], values[3]})
                    .toList();
        }
    }

    List<double[]> evaluate(ExactLight light) {
        return map("Reference", row -> list.spectral() ? spectral(light, row) : color(light, row));
    }

    private List<double[]> map(String label, Function<Integer, double[]> values) {
        return display.map(label, IntStream.range(0, list.size()).boxed().toList(), values);
    }

    /** Compares results of the shaders with the reference at random rows: X, Y, Z, or the power under the method's average. */
    Certificate certify(ExactLight light, List<double[]> results, int count, double tolerance) {
        int from = list.spectral() && light.ensemble() ? 1 : 0;
        int to = list.spectral() ? from + 1 : 3;
        return Certificate.ofRows(
                display,
                list.size(),
                count,
                row -> {
                    double[] exact = list.spectral()
                            ? new double[] {light.power(list.pair(row), list.wavelength(row))}
                            : light.xyz(list.pair(row), ExactLight.Quadrature.INTEGRATED);
                    return new Comparison(Arrays.copyOfRange(results.get(row), from, to), exact, 1);
                },
                list.spectral() ? "power" : "XYZ",
                tolerance);
    }

    /**
     * Converts results from the standard material to another; power does not depend on it. Rho becomes relative to a flat mirror of it at
     * normal incidence (for a tabulated index, to its mean weighted by luminance).
     */
    List<double[]> indexed(RefractiveIndex index, CieTable cie, FresnelFactor fresnel, List<double[]> results) {
        if (index.isStandard()) {
            return results;
        }
        double mirror = ReflectionPart.mirror(index, cie);
        return IntStream.range(0, list.size())
                .mapToObj(row -> indexed(index, row, fresnel, results.get(row).clone(), mirror))
                .toList();
    }

    private double[] indexed(RefractiveIndex index, int row, FresnelFactor fresnel, double[] values, double mirror) {
        DirectionPair pair = list.pair(row);
        double wavelength = list.spectral() ? list.wavelength(row) : CieTable.MINIMUM_WAVELENGTH;
        double once = index.reflectance(wavelength, pair.cosThetaD())
                / Gain.reflectance(pair.cosThetaD())
                * (Gain.R0 / mirror);
        double over = fresnel == FresnelFactor.SQUARED ? once * once : once;
        values[list.spectral() ? RHO : GAIN] *= over;
        if (list.spectral()) {
            values[BRDF] *= over * mirror / Gain.R0;
        }
        return values;
    }

    /** Divides rho and BRDF of rows with a wavelength; the colors of other rows are under divided light. */
    List<double[]> divided(Optional<EnergyDivisor> divisor, List<double[]> results) {
        if (divisor.isEmpty() || !list.spectral()) {
            return results;
        }
        return map("Energy", row -> {
            double[] values = results.get(row).clone();
            double sent = divisor.get().at(list.pair(row).wi(), list.wavelength(row));
            values[RHO] /= sent;
            values[BRDF] /= sent;
            return values;
        });
    }

    private double[] spectral(ExactLight light, int row) {
        DirectionPair pair = list.pair(row);
        double wavelength = list.wavelength(row);
        Power power = light.powers(pair, wavelength);
        double seen = light.ensemble() ? power.ensemble() : power.coherent();
        return new double[] {
            power.coherent(),
            power.ensemble(),
            Gain.relativeRadiance(pair) * seen,
            Gain.brdf(pair, light.window(), wavelength) * seen
        };
    }

    private double[] color(ExactLight light, int row) {
        double[] xyz = light.xyz(list.pair(row), ExactLight.Quadrature.EXACT);
        return new double[] {xyz[0], xyz[1], xyz[2], Gain.relativeRadiance(list.pair(row))};
    }
}
