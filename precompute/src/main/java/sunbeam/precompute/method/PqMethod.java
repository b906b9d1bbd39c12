package sunbeam.precompute.method;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.ShaderArrays;
import sunbeam.precompute.plan.ShaderArrays.KernelPolynomials;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.ComplexVector;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.PeriodInterpolation;
import sunbeam.precompute.spectrum.PeriodInterpolation.PeriodSpectrum;
import sunbeam.precompute.text.Text;

/**
 * Method {@code pq}: the patch is repeated Q times, with sharp edges instead of a window, at a fixed place, so that there is only the
 * coherent average. If no number is chosen, replicas fill the window's coherence length along each axis.
 */
public record PqMethod(
        TableChoices table,
        PeriodInterpolation interpolation,
        GaussianArea area,
        Optional<Integer> replicas,
        FresnelFactor fresnel)
        implements Method {
    // Wavelength steps in meters; the coarsest is the thesis's.
    private static final double COARSEST_STEP = 5e-9;
    private static final double FINEST_STEP = 0.05e-9;
    private static final int TERMS_PER_TEXEL = 2;
    private static final String TERMS = "periodTerms";
    private static final String COEFFICIENTS = "periodCoefficients";

    public static final MethodType TYPE = new MethodType(
            "pq",
            "the patch repeated Q times, with sharp edges.",
            Setting.union(
                    TableChoices.SETTINGS,
                    List.of(
                            MethodSettings.COHERENCE_LENGTH,
                            MethodSettings.INTERPOLATION,
                            MethodSettings.REPLICAS,
                            MethodSettings.FRESNEL)),
            Choices.none().with(MethodSettings.AVERAGE, Average.COHERENT),
            choices -> new PqMethod(
                    new TableChoices(choices),
                    interpolation(choices),
                    GaussianArea.STANDARD.with(GaussianArea.windowOf(choices)),
                    choices.find(MethodSettings.REPLICAS),
                    FresnelFactor.of(choices)));

    public static PeriodInterpolation interpolation(Choices choices) {
        return choices.get(
                MethodSettings.INTERPOLATION,
                Preset.isThesis(choices) ? PeriodInterpolation.RING : PeriodInterpolation.SINC);
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    private Replicas replicas(HeightMap map) {
        return replicas.map(count -> new Replicas(count, count))
                .orElseGet(() -> Replicas.filling(area.window(), map.width(), map.height()));
    }

    @Override
    public ReferenceMethod referenceMethod(HeightMap map) {
        return new ReferenceMethod(replicas(map));
    }

    @Override
    public Optional<Sentence> approximation() {
        return switch (interpolation) {
            case SINC -> Optional.empty();
            case LINEAR -> Optional.of(Sentence.of("light between the bins of one period's DFT is lost"));
            case RING -> Optional.of(Sentence.of("bins more than one away, and phases between bins, are left out"));
        };
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        Replicas repeated = replicas(surface.map());
        double step = table.isThesis() ? COARSEST_STEP : wavelengthStep(surface.map(), repeated, range);
        WavelengthNodes wavelengths =
                WavelengthNodes.uniform(surface.cie(), table.wavelengthStep().orElse(step));
        int samplesPerBin = interpolation.oversampling();
        Period planned = new Period(
                this,
                surface,
                surface.planner().expansion(table, range),
                range,
                range.bandX(samplesPerBin * surface.map().width(), interpolation.margin()),
                range.bandY(samplesPerBin * surface.map().height(), interpolation.margin()),
                repeated,
                wavelengths);
        surface.planner().excess(planned.memory()).ifPresent(excess -> {
            throw new SettingException(
                            Methods.METHOD,
                            Text.format(
                                    "takes %d x %d samples of the period's spectrum in %d terms, which %s; crop the patch, or give a coarser ",
                                    planned.bandX().count(),
                                    planned.bandY().count(),
                                    planned.expansion().terms(),
                                    excess.words()),
                            MethodSettings.TOLERANCE,
                            " or fewer ",
                            MethodSettings.TERMS)
                    .because(excess);
        });
        return planned.plan();
    }

    /** Meters; resolves the fringes: the power of an area a x b, as a function of 1 / lambda, is band-limited to |u| a + |v| b cycles. */
    private static double wavelengthStep(HeightMap map, Replicas replicas, VisibleRange range) {
        double cycles = VisibleRange.largest(range.minimumU(), range.maximumU()) * replicas.alongX() * map.width()
                + VisibleRange.largest(range.minimumV(), range.maximumV()) * replicas.alongY() * map.height();
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        return Math.min(COARSEST_STEP, Math.max(FINEST_STEP, shortest * shortest / Math.max(1e-9, cycles)));
    }

    private record Period(
            PqMethod method,
            Surface surface,
            Expansion expansion,
            VisibleRange range,
            Band bandX,
            Band bandY,
            Replicas replicas,
            WavelengthNodes wavelengths) {
        MethodPlan plan() {
            return new MethodPlan(
                    Text.format(
                            "thesis's method of replicas (pq): the patch %d x %d times side by side with sharp edges, %d"
                                    + " wavelengths a pixel",
                            replicas.alongX(), replicas.alongY(), wavelengths.count()),
                    this::reasons,
                    Optional.empty(),
                    Optional.empty(),
                    memory(),
                    EnumSet.allOf(MethodUse.class),
                    () -> "pq|" + surface.key() + "|" + expansion.key() + "|" + range + "|" + method.interpolation + "|"
                            + replicas + "|" + wavelengths.count() + "|" + method.fresnel,
                    (use, sources) -> tables());
        }

        private List<String> reasons() {
            return List.of(
                    Text.format(
                            "sizes: %d %s terms, %s interpolation",
                            expansion.terms(), ValueKind.name(expansion.kind()), ValueKind.name(method.interpolation)),
                    "replicas: chosen, or the number closest to the coherence length",
                    Text.format(
                            "spectrum: of one period, %d samples a bin, %d taps along each axis; see docs/theory.md for its error",
                            method.interpolation.oversampling(), method.interpolation.taps()),
                    "wavelengths: chosen, or one per cycle of the power over 1 / lambda");
        }

        private ArrayLayout termsLayout() {
            int layers = (expansion.terms() + TERMS_PER_TEXEL - 1) / TERMS_PER_TEXEL;
            return ArrayLayout.layered(TERMS, bandX.count(), bandY.count(), layers, 2 * TERMS_PER_TEXEL);
        }

        MemoryNeed memory() {
            ArrayLayout terms = termsLayout();
            int samples = CoefficientTable.sampleCount(expansion, 1);
            List<ArrayLayout> layouts = List.of(
                    ShaderArrays.coefficientsLayout(COEFFICIENTS, samples, expansion.terms()),
                    ShaderArrays.wavelengthsLayout(wavelengths),
                    terms);
            // One complex transform in double precision, before and after its second axis, and one layer of texels.
            long lines =
                    (long) method.interpolation.oversampling() * surface.map().rows() + terms.height();
            return new MemoryNeed(2L * Double.BYTES * lines * terms.width() + terms.bytes() / terms.layers(), layouts);
        }

        private ShaderTables tables() {
            HeightMap map = surface.map();
            PeriodSpectrum spectrum = new PeriodSpectrum(surface.map(), expansion, bandX, bandY, method.interpolation);
            CoefficientTable coefficients = CoefficientTable.sampled(expansion);
            ArrayLayout terms = termsLayout();
            ShaderTables.Builder tables = new ShaderTables.Builder("pq");
            Average.COHERENT.defineIn(tables);
            ShaderArrays.define(tables, true, expansion.terms());
            if (method.interpolation == PeriodInterpolation.RING) {
                tables.define("PERIOD_RING", 1);
            } else {
                KernelPolynomials.of(method.interpolation.taps(), method.interpolation::kernel)
                        .defineIn(tables);
            }
            return method.fresnel.applyTo(tables.define("PERIOD_LAYERS", terms.layers())
                    .array(ShaderArrays.coefficients(COEFFICIENTS, coefficients))
                    .array(ShaderArrays.wavelengths(wavelengths))
                    .array(TableArray.computed(terms, layer -> layer(spectrum, layer)))
                    .reals("heightHalfRange", expansion.scale().halfRange())
                    .reals("periodPhaseMap", ShaderArrays.phaseMap(coefficients))
                    .reals(
                            "periodScale",
                            method.interpolation.oversampling() * map.width(),
                            method.interpolation.oversampling() * map.height())
                    .reals("periodFirst", bandX.first(), bandY.first())
                    .reals("periodLength", map.width(), map.height())
                    .reals("periodReplicas", replicas.alongX(), replicas.alongY())
                    .integers("wavelengthCount", wavelengths.count())
                    .build(replicas.equalAreaWindow(map.width(), map.height())));
        }

        private float[] layer(PeriodSpectrum spectrum, int layer) {
            float[] texels = new float[4 * bandX.count() * bandY.count()];
            for (int n = 0; n < TERMS_PER_TEXEL && TERMS_PER_TEXEL * layer + n < expansion.terms(); n++) {
                ComplexVector term = spectrum.term(TERMS_PER_TEXEL * layer + n);
                for (int i = 0; i < term.length(); i++) {
                    texels[4 * i + 2 * n] = (float) term.real()[i];
                    texels[4 * i + 2 * n + 1] = (float) term.imaginary()[i];
                }
            }
            return texels;
        }
    }
}
