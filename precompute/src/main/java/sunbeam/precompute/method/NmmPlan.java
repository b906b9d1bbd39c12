package sunbeam.precompute.method;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.OrderWeights;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanException;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.SpectrumArrays;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.units.Lengths;

/**
 * Method {@code nmm}: one wavelength per diffraction order.
 *
 * @param surface the surface
 * @param plan made for it, for DFT bins at fixed wavelengths
 * @param weighting what an order counts
 */
public record NmmPlan(Surface surface, Plan plan, Weighting weighting) implements MethodPlan {
    /** Wavelength steps for directions so near to the specular one that an order covers them all, metres. */
    public static final double WAVELENGTH_STEP = 5e-9;

    // Widest order that one wavelength stands for, in 1 / metre of 1 / lambda: at 500 nm a deviation of 12 nm, a third
    // of
    // the narrowest colour matching function's. At 380 nm a deviation of 7 nm, which steps of 5 nm still resolve.
    private static final double WIDEST_ORDER = 7e4;
    // Largest |(u, v)|: grazing light, grazing view.
    private static final double LARGEST_UV = 2;
    // Of an order farther from the ray less than this is seen.
    private static final double FAINTEST = 1e-3;
    // exp(-1 / (4 sigma^2)) of interference between neighbouring bins that are sigma deviations apart: 2e-3.
    private static final double OVERLAP_SIGMA_BINS = 0.2;

    /** What an order counts. */
    public enum Weighting {
        /** Its width in wavelength (shaders/method/nmm.glsl). */
        WIDTH,
        /** One step of wavelength, however wide it is, as in the thesis (nmm_thesis.glsl). */
        STEP
    }

    /**
     * Checks that there are orders to look at.
     *
     * @throws PlanException when the patch has none beside the specular one
     */
    public NmmPlan {
        HeightMap map = surface.map();
        if (LARGEST_UV * Math.max(map.width(), map.height()) < CieTable.MINIMUM_WAVELENGTH) {
            throw new PlanException("--method nmm: a patch of %s x %s has no DFT bin beside the specular one in the"
                            .formatted(Lengths.format(map.width()), Lengths.format(map.height()))
                    + " visible band; use --method full");
        }
    }

    @Override
    public String summary() {
        return "nmm: one wavelength per order" + (weighting == Weighting.STEP ? ", unweighted" : "")
                + "; near the specular direction " + new PlanReport(plan).summary();
    }

    @Override
    public List<String> reasons() {
        return new PlanReport(plan).reasons();
    }

    @Override
    public MemoryNeed memory() {
        return MemoryNeed.of(plan, surface.map().rows()).and(List.of(ownLayout()));
    }

    private ArrayLayout ownLayout() {
        return weighting == Weighting.WIDTH
                ? ArrayLayout.flat("orderWeights", OrderWeights.COLUMNS, OrderWeights.ROWS, 4)
                        .linear()
                : ColorArrays.cieWeightsLayout();
    }

    @Override
    public String key(MethodUse use) {
        return String.join("|", "nmm", weighting.toString(), surface.key(), plan.key());
    }

    @Override
    public ShaderTables tables(MethodUse use, FourierTables fourier) {
        boolean weighted = weighting == Weighting.WIDTH;
        ShaderTables bins = plan.sampling().tables(plan, fourier.of(plan), use, surface.cie());
        double width = surface.map().width();
        double height = surface.map().height();
        double sigma = plan.window().sigmaFrequency();
        // A ray that crosses columns obliquely passes a column's bins at up to this many times their distance to it.
        double reach = Math.sqrt(-Math.log(FAINTEST)) * sigma * Math.hypot(width, height);
        ShaderTables.Builder tables = new ShaderTables.Builder(weighted ? "nmm" : "nmm_thesis")
                .all(bins)
                .define("ORDERS_OVERLAP", sigma * Math.max(width, height) > OVERLAP_SIGMA_BINS ? "1" : "0")
                .define("ACROSS", (int) Math.max(0, Math.ceil(reach - 0.5)));
        if (weighted) {
            addWidths(tables, sigma);
            return tables.build(bins.windowSigma(), bins.specularReach());
        }
        tables.array(ColorArrays.cieWeights(surface.cie()))
                .reals("orderStep", WAVELENGTH_STEP)
                .reals("cieWhite", ColorArrays.cieWhite(surface.cie()));
        // The thesis's form has a white disc in its place, up to the first wavelength that meets a bin.
        double disc = CieTable.MINIMUM_WAVELENGTH / Math.min(width, height);
        return tables.build(bins.windowSigma(), Math.max(bins.specularReach(), disc));
    }

    private void addWidths(ShaderTables.Builder tables, double sigma) {
        OrderWeights weights =
                OrderWeights.tabulate(surface.cie(), Math.min(sigma / LARGEST_UV, 0.5 * WIDEST_ORDER), WIDEST_ORDER);
        int texelCount = weights.columns() * weights.rows();
        float[] texels = new float[4 * texelCount];
        for (int i = 0; i < texelCount; i++) {
            System.arraycopy(weights.values(), 3 * i, texels, 4 * i, 3);
        }
        tables.array(TableArray.of(ownLayout(), texels))
                .reals("windowSigmaFrequency", sigma)
                .reals("orderWidest", WIDEST_ORDER)
                .reals(
                        "orderPlaceMap",
                        SpectrumArrays.textureMap(weights.minimumPlace(), weights.maximumPlace(), weights.columns()))
                .reals(
                        "orderWidthMap",
                        SpectrumArrays.textureMap(weights.minimumWidth(), weights.maximumWidth(), weights.rows()));
    }
}
