package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.resample.InterpolationDesign;
import sunbeam.precompute.units.Lengths;

/** A plan in words. */
public final class PlanReport {
    // 81 wavelengths, 3 x 3 bins, 37 terms.
    private static final int THESIS_READS = 81 * 9 * 37;

    private final Plan plan;

    public PlanReport(Plan plan) {
        this.plan = plan;
    }

    /** One line: what is computed. */
    public String summary() {
        return terms() + ", " + sampling() + ", " + bins() + tolerance();
    }

    private String tolerance() {
        return Double.isNaN(plan.tolerance()) ? " (thesis)" : " (tolerance " + plan.tolerance() + ")";
    }

    private String terms() {
        Expansion expansion = plan.expansion();
        return expansion.terms() + " " + expansion.kind().label() + " terms";
    }

    private String bins() {
        return plan.bandX().count() + " x " + plan.bandY().count() + " DFT bins";
    }

    private String sampling() {
        Sampling sampling = plan.sampling();
        if (sampling instanceof Sampling.Bins bins) {
            return neighbourhood(bins.neighbourhood()) + " at "
                    + bins.wavelengths().count() + " wavelengths";
        }
        if (sampling instanceof Sampling.Rays rays) {
            return "%s at %d to %d wavelengths"
                    .formatted(neighbourhood(rays.neighbourhood()), rays.fewestNodes(), mostNodes(rays));
        }
        if (sampling instanceof Sampling.Grid grid) {
            return "grid with %d taps, %d to %d wavelengths"
                    .formatted(grid.interpolation().taps(), grid.fewestNodes(), mostNodes(grid));
        }
        Sampling.Orders orders = (Sampling.Orders) sampling;
        return "single orders with %d wavelengths each or more".formatted(orderNodes(orders));
    }

    private static int orderNodes(Sampling.Orders orders) {
        return 2 * (int) Math.ceil(orders.reach() / orders.nodeSpacing()) + 1;
    }

    private static String neighbourhood(Neighbourhood neighbourhood) {
        int side = 2 * neighbourhood.radius() + 1;
        String middle = neighbourhood.anchor() == Neighbourhood.Anchor.FLOOR ? "floored" : "nearest";
        return side + " x " + side + " bins around the " + middle + " one";
    }

    private int mostNodes(Sampling.Rays rays) {
        VisibleRange range = plan.range();
        double longest = Math.sqrt(2) * range.maximumComponent();
        double waveNumbers = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;
        return Math.max(rays.fewestNodes(), (int) Math.ceil(longest * waveNumbers / rays.nodeStep()) + 1);
    }

    /** Columns that the longest ray crosses. */
    private int mostNodes(Sampling.Grid grid) {
        double waveNumbers = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;
        return Math.max(grid.fewestNodes(), (int)
                Math.ceil(plan.range().maximumComponent() * waveNumbers / (grid.largestStride() * grid.nodeStep())));
    }

    /**
     * One line: memory on the graphics card and texture reads of the pixel that takes most, beside those of the thesis's
     * shader.
     *
     * @param patchRows of the height map
     */
    public String cost(int patchRows) {
        return format(
                "textures of at most %.3g MB; up to %d texture reads a pixel (the thesis's shader: %d)",
                MemoryNeed.of(plan, patchRows).textureBytes() * 1e-6, reads(), THESIS_READS);
    }

    private long reads() {
        long terms = plan.expansion().terms();
        Sampling sampling = plan.sampling();
        if (sampling instanceof Sampling.Bins bins) {
            return bins.wavelengths().count() * binReads(bins.neighbourhood());
        }
        if (sampling instanceof Sampling.Rays rays) {
            return mostNodes(rays) * binReads(rays.neighbourhood());
        }
        if (sampling instanceof Sampling.Grid grid) {
            // Two complex terms share a texel.
            return (terms + 1) / 2 * mostNodes(grid) * grid.interpolation().taps();
        }
        // A ray from the middle passes at most half of the orders each way.
        long passed = ((long) plan.bandX().count() + plan.bandY().count()) / 2;
        return passed * orderNodes((Sampling.Orders) sampling) * terms;
    }

    private long binReads(Neighbourhood neighbourhood) {
        long side = 2L * neighbourhood.radius() + 1;
        return side * side * plan.expansion().terms();
    }

    /** Several lines: each choice and its reason. */
    public List<String> reasons() {
        List<String> lines = new ArrayList<>();
        VisibleRange range = plan.range();
        lines.add(format(
                "directions: u %.3f..%.3f, v %.3f..%.3f, |w| %.3f..%.3f can occur; nothing else is computed",
                range.minimumU(),
                range.maximumU(),
                range.minimumV(),
                range.maximumV(),
                range.minimumW(),
                range.maximumW()));
        Expansion expansion = plan.expansion();
        lines.add(format(
                "expansion: phases k |w| h of %.2f to %.2f rad take %s; largest error at the largest phase %.1e%s",
                expansion.minimumPhase(),
                expansion.maximumPhase(),
                terms(),
                expansion.errorBound(expansion.maximumPhase()),
                expansion instanceof LowRankExpansion lowRank
                        ? format(", root mean square %.1e over heights and phases", lowRank.rootMeanSquareError())
                        : ""));
        lines.add(format(
                "window: coherence length %s, its spectrum has a deviation of %.4g cycles per metre, centred on the %s",
                Lengths.format(plan.window().coherenceLength()),
                plan.window().sigmaFrequency(),
                plan.origin() == WindowOrigin.CORNER ? "corner" : "patch's centre"));
        lines.addAll(samplingReasons());
        lines.add("bins: " + bins() + " reach every visible frequency at 380 nm and the window's width beyond");
        return lines;
    }

    private List<String> samplingReasons() {
        Sampling sampling = plan.sampling();
        if (sampling instanceof Sampling.Grid grid) {
            InterpolationDesign design = grid.interpolation();
            return List.of(
                    format(
                            "spectrum: windowed and resampled at %.2f samples per deviation, interpolated by %d"
                                    + " Kaiser-Bessel taps; relative error of an amplitude %.1e",
                            design.deviation(), design.taps(), design.error()),
                    format(
                            "wavelengths: where the ray (u, v) / lambda crosses columns %.4g cycles per metre apart, with"
                                    + " strides of up to %d, at most %d; where |u|, |v| < %.3f, %d equal steps of"
                                    + " 1 / lambda",
                            grid.nodeStep(),
                            grid.largestStride(),
                            mostNodes(grid),
                            grid.centreReach(),
                            grid.fewestNodes()));
        }
        if (sampling instanceof Sampling.Orders orders) {
            return List.of(
                    "spectrum: the patch is so small that the window resolves every order; the nearest bin is enough",
                    format(
                            "wavelengths: %d or more around each order's middle, %.2f deviations of its power and at most"
                                    + " %s apart; %d within the specular order",
                            orderNodes(orders),
                            orders.nodeSpacing(),
                            Lengths.format(orders.largestStep()),
                            orders.specularNodes()));
        }
        if (sampling instanceof Sampling.Rays rays) {
            return List.of(
                    "spectrum: the window's is so narrow that its flanks lie bare between orders, or a grid would not fit"
                            + " into memory; " + neighbourhood(rays.neighbourhood()) + " are summed",
                    format(
                            "wavelengths: in steps of %.4g cycles per metre along the ray (u, v) / lambda, %d or more",
                            rays.nodeStep(), rays.fewestNodes()));
        }
        return List.of("spectrum and wavelengths: " + sampling() + ", as asked for");
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
