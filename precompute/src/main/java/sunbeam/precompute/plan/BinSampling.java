package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.text.Text;

/**
 * Sum over a neighborhood of bins at fixed wavelengths (shaders/method/full_bins.glsl): planned with exact weights for any light, or of
 * equal steps, as in the thesis, which keep no tolerance.
 */
public record BinSampling(Neighborhood neighborhood, WavelengthNodes wavelengths, boolean planned) implements Sampling {
    private static final double THESIS_WAVELENGTH_STEP = 5e-9;
    // Most bins of a neighborhood whose shader sums terms in the outer loop and bins in the inner one.
    private static final int FEW_BINS = 81;
    private static final String TERMS = "tableTerms";
    private static final String COEFFICIENTS = "expansionCoefficients";

    /** Returns the sum that the user chose; by default with the thesis's wavelength step and all bins that count. */
    static BinSampling of(TableChoices table, CoherenceWindow window, HeightMap map, CieTable cie) {
        double sigmaBins = window.sigmaFrequency() * Math.max(map.width(), map.height());
        int radius = new ErrorBudget(table.tolerance()).neighborhoodRadius(sigmaBins);
        return new BinSampling(
                table.neighborhood().orElse(new Neighborhood(radius, Neighborhood.Anchor.NEAREST)),
                WavelengthNodes.uniform(cie, table.wavelengthStep().orElse(THESIS_WAVELENGTH_STEP)),
                false);
    }

    @Override
    public String summary(VisibleRange range) {
        return neighborhood.summary() + " at " + wavelengths.count() + " wavelengths";
    }

    @Override
    public long loopSteps(SpectrumPlan plan) {
        return wavelengths.count() * neighborhood.loopSteps();
    }

    @Override
    public List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use) {
        List<ArrayLayout> layouts = binLayouts(plan);
        layouts.add(ShaderArrays.wavelengthsLayout(wavelengths));
        return layouts;
    }

    @Override
    public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
        return binTables("full_bins", plan, table, neighborhood)
                .array(ShaderArrays.wavelengths(wavelengths))
                .integers("wavelengthCount", wavelengths.count())
                .build(plan.window());
    }

    /** Part of cache keys: for a given light, the number of wavelengths and the first two determine all. */
    @Override
    public String toString() {
        return "BinSampling[" + neighborhood + ", " + wavelengths.count() + " wavelengths from "
                + wavelengths.wavelengths()[0] + ", " + wavelengths.wavelengths()[Math.min(1, wavelengths.count() - 1)]
                + "]";
    }

    static List<ArrayLayout> binLayouts(SpectrumPlan plan) {
        List<ArrayLayout> layouts = new ArrayList<>();
        Expansion expansion = plan.expansion();
        layouts.add(terms(plan.bandX(), plan.bandY(), expansion.terms()));
        if (expansion.kind() != Expansion.Kind.TAYLOR) {
            int samples = CoefficientTable.sampleCount(expansion, 1);
            layouts.add(ShaderArrays.singleLayout(COEFFICIENTS, samples, expansion.terms()));
        }
        return layouts;
    }

    private static ArrayLayout terms(Band bandX, Band bandY, int terms) {
        return ArrayLayout.layered(TERMS, bandX.count(), bandY.count(), terms, 2);
    }

    /** Returns arrays and constants of shaders/method/neighborhood.glsl. */
    static ShaderTables.Builder binTables(
            String shader, SpectrumPlan plan, FourierTable table, Neighborhood neighborhood) {
        Expansion expansion = table.expansion();
        boolean sampled = expansion.kind() != Expansion.Kind.TAYLOR;
        ShaderTables.Builder tables = new ShaderTables.Builder(shader);
        plan.area().average().defineIn(tables);
        ShaderArrays.define(tables, sampled, table.terms());
        tables.array(TableArray.computed(
                        terms(table.bandX(), table.bandY(), table.terms()),
                        n -> interleaved(table.amplitudes(n, n + 1, plan.area().origin()))))
                .integers("tableFirst", table.bandX().first(), table.bandY().first())
                .reals("heightHalfRange", expansion.scale().halfRange());
        if (sampled) {
            CoefficientTable coefficients = CoefficientTable.sampled(expansion);
            tables.array(ShaderArrays.singleCoefficients(COEFFICIENTS, coefficients))
                    .reals("expansionPhaseMap", ShaderArrays.phaseMap(coefficients));
        }
        // The outer loop then runs over the terms; its steps count, since compilers need not unroll it.
        long steps = expansion.terms() * plan.sampling().loopSteps(plan);
        boolean few = neighborhood.bins() <= FEW_BINS && steps <= PlanChecks.MOST_LOOP_STEPS;
        boolean floor = neighborhood.anchor() == Neighborhood.Anchor.FLOOR;
        tables.define("ANCHOR_FLOOR", 0)
                .define("ANCHOR_NEAREST", 1)
                .define("ANCHOR", floor ? "ANCHOR_FLOOR" : "ANCHOR_NEAREST")
                .define("RADIUS", Text.format("ivec2(%d, %d)", neighborhood.radiusX(), neighborhood.radiusY()))
                .define("FEW_BINS", few ? 1 : 0)
                .integers("tableRadius", neighborhood.radiusX(), neighborhood.radiusY());
        double sigma = plan.window().sigmaFrequency();
        double width = table.map().width();
        double height = table.map().height();
        return tables.reals("tablePeriod", width, height)
                .reals("tablePeriodRest", width - (float) width, height - (float) height)
                .reals("windowSigmaBins", sigma * width, sigma * height);
    }

    private static float[] interleaved(double[][] parts) {
        float[] result = new float[2 * parts[0].length];
        for (int i = 0; i < parts[0].length; i++) {
            result[2 * i] = (float) parts[0][i];
            result[2 * i + 1] = (float) parts[1][i];
        }
        return result;
    }
}
