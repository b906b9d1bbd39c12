package sunbeam.precompute.method;

import java.util.EnumSet;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderArrays;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Method {@code nmm}: one wavelength per order, weighted by the order's width unless the thesis's preset is chosen. */
public record NmmMethod(TableChoices table, GaussianArea area, FresnelFactor fresnel) implements Method {
    // Meters, for directions so close to the specular one that an order covers the visible band.
    private static final double WAVELENGTH_STEP = 5e-9;
    // In 1 / meter of 1 / lambda: at 500 nm a deviation of 12 nm, a third of the narrowest color matching function's.
    private static final double WIDEST_ORDER = 7e4;
    private static final double LARGEST_UV = 2;
    // Relative to an order on the ray of all (u, v) / lambda; fainter orders beside it are ignored.
    private static final double FAINTEST = 1e-3;
    // Deviation of the window's spectrum, in bins; above, neighbors interfere by more than exp(-1 / (4 sigma^2)).
    private static final double OVERLAP_SIGMA_BINS = 0.2;
    // The step is 0.7 nm at 500 nm; color matching functions bend over tens of nanometers.
    private static final int CENTERS = 768;
    private static final int WIDTHS = 24;
    // In widths: exp(-4.5^2) = 2e-9.
    private static final double REACH = 4.5;
    // The trapezoid rule for exp(-(x / width)^2) has the relative error 2 exp(-(pi width / step)^2).
    private static final int NODES_PER_WIDTH = 4;

    public static final MethodType TYPE = new MethodType(
            "nmm",
            "one wavelength per diffraction order, weighted by the order's width.",
            FullMethod.SETTINGS,
            choices -> new NmmMethod(new TableChoices(choices), GaussianArea.of(choices), FresnelFactor.of(choices)));

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public Optional<Sentence> approximation() {
        return Optional.of(Sentence.of("one wavelength represents a whole order; give ", Methods.METHOD, " full"));
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        surface.requireSmoothLight();
        HeightMap map = surface.map();
        if (LARGEST_UV * Math.max(map.width(), map.height()) < CieTable.MINIMUM_WAVELENGTH) {
            throw new SettingException(
                    Methods.METHOD,
                    Text.format(
                            "has no order: a patch of %s x %s has no DFT bin beside the specular one in the visible band; use ",
                            Lengths.format(map.width()), Lengths.format(map.height())),
                    Methods.METHOD,
                    " full");
        }
        TableChoices stepped = table.wavelengthStep().isPresent() ? table : table.withWavelengthStep(WAVELENGTH_STEP);
        SpectrumPlan plan = surface.planner().plan(stepped, area, range);
        // Else orders count as one wavelength step each (nmm_thesis.glsl).
        boolean weighted = plan.tolerance().isPresent();
        return new MethodPlan(
                "thesis's method of single orders (nmm): each order's middle wavelength represents the whole order"
                        + (weighted ? "" : ", all orders with equal weight")
                        + "; near the mirror direction " + plan.summary(),
                plan::reasons,
                Optional.empty(),
                Optional.empty(),
                MemoryNeed.of(plan, surface.map().rows()).and(ownLayout(weighted)),
                EnumSet.allOf(MethodUse.class),
                () -> "nmm|" + weighted + "|" + surface.key() + "|" + plan.key() + "|" + fresnel,
                (use, sources) -> tables(surface, plan, plan.tables(sources.fourier(plan), use, surface.cie())));
    }

    private static ArrayLayout ownLayout(boolean weighted) {
        return weighted
                ? ArrayLayout.flat("orderWeights", CENTERS, WIDTHS, 4).linear()
                : ShaderArrays.cieWeightsLayout();
    }

    private ShaderTables tables(Surface surface, SpectrumPlan plan, ShaderTables bins) {
        boolean weighted = plan.tolerance().isPresent();
        double width = surface.map().width();
        double height = surface.map().height();
        double sigma = plan.window().sigmaFrequency();
        // Largest distance, in bins along a column, of an order that counts from the most oblique ray.
        double reach = Math.sqrt(-Math.log(FAINTEST)) * sigma * Math.hypot(width, height);
        ShaderTables.Builder tables = new ShaderTables.Builder(weighted ? "nmm" : "nmm_thesis")
                .all(bins)
                .define("ORDERS_OVERLAP", sigma * Math.max(width, height) > OVERLAP_SIGMA_BINS ? "1" : "0")
                .define("ACROSS", (int) Math.max(0, Math.ceil(reach - 0.5)));
        if (weighted) {
            addWidths(surface, tables, sigma);
            return fresnel.applyTo(tables.build(bins.windowSigma(), bins.specularReach()));
        }
        tables.array(ShaderArrays.cieWeights(surface.cie()))
                .reals("orderStep", WAVELENGTH_STEP)
                .reals("cieWhite", surface.cie().white());
        // The thesis's form has a white disc, up to the |(u, v)| at which the shortest wavelength meets the first bin.
        double disc = CieTable.MINIMUM_WAVELENGTH / Math.min(width, height);
        return fresnel.applyTo(tables.build(bins.windowSigma(), Math.max(bins.specularReach(), disc)));
    }

    /**
     * Adds the color weights of orders, each of which is a Gaussian of 1 / lambda with a center s and a width:
     *
     * <pre>W(s, width) = int S xbar exp(-((1 / lambda - s) / width)^2) dlambda / int S ybar dlambda</pre>
     *
     * as W / width, in meters, which hardly depends on width where orders are narrow: sqrt(pi) lambda^2 S xbar(lambda).
     */
    private static void addWidths(Surface surface, ShaderTables.Builder tables, double sigma) {
        double narrowest = Math.min(sigma / LARGEST_UV, 0.5 * WIDEST_ORDER);
        // At the first and last center the widest order just misses the band: the texture's border is black.
        double first = 1 / CieTable.MAXIMUM_WAVELENGTH - REACH * WIDEST_ORDER;
        double last = 1 / CieTable.MINIMUM_WAVELENGTH + REACH * WIDEST_ORDER;
        float[] texels = new float[4 * CENTERS * WIDTHS];
        IntStream.range(0, WIDTHS).parallel().forEach(row -> {
            double width = narrowest + (WIDEST_ORDER - narrowest) * row / (WIDTHS - 1);
            for (int column = 0; column < CENTERS; column++) {
                double[] weight = weight(surface.cie(), first + (last - first) * column / (CENTERS - 1), width);
                for (int c = 0; c < 3; c++) {
                    texels[4 * (row * CENTERS + column) + c] = (float) (weight[c] / width);
                }
            }
        });
        tables.array(TableArray.of(ownLayout(true), texels))
                .reals("windowSigmaFrequency", sigma)
                .reals("orderWidest", WIDEST_ORDER)
                .reals("orderPlaceMap", ShaderArrays.textureMap(first, last, CENTERS))
                .reals("orderWidthMap", ShaderArrays.textureMap(narrowest, WIDEST_ORDER, WIDTHS));
    }

    /** Returns W of one order for X, Y, Z, integrated over 1 / lambda: dlambda = lambda^2 d(1 / lambda). */
    static double[] weight(CieTable cie, double center, double width) {
        double step = width / NODES_PER_WIDTH;
        int reach = (int) Math.ceil(REACH * NODES_PER_WIDTH);
        double[] sum = new double[3];
        for (int i = -reach; i <= reach; i++) {
            double waveNumber = center + i * step;
            if (waveNumber > 0) {
                double wavelength = 1 / waveNumber;
                double gauss = CoherenceWindow.power(i * step / width) * wavelength * wavelength * step;
                for (int c = 0; c < 3; c++) {
                    sum[c] += gauss * cie.at(wavelength, c) / cie.integralOfY();
                }
            }
        }
        return sum;
    }
}
