package sunbeam.app.gpu;

import java.util.Optional;
import jrtr.RenderContext;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.table.FourierTable;

/** Method {@code full}, in the form that its plan's sampling asks for. */
public final class FullMethod {
    private FullMethod() {}

    /** Uploads what the use needs. */
    public static DiffractionMethod create(
            RenderContext context, Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        if (!(plan.sampling() instanceof Sampling.Grid grid)) {
            return new BinsMethod(context, plan, table, cie);
        }
        Optional<Neighbourhood> exact =
                use == MethodUse.SPECTRAL ? neighbourhood(plan, table) : Optional.empty();
        return exact.isPresent()
                ? new BinsMethod(context, plan.with(new Sampling.Rays(exact.get(), grid.nodeStep(), 1)), table, cie)
                : new GridMethod(context, plan, grid, table, use, cie);
    }

    /** Bins to sum at a single wavelength, where they are not too many: exact, and time is no matter there. */
    private static Optional<Neighbourhood> neighbourhood(Plan plan, FourierTable table) {
        double period = Math.max(table.patch().width(), table.patch().height());
        int radius = new ErrorBudget(plan.tolerance())
                .neighbourhoodRadius(plan.window().sigmaFrequency() * period);
        return radius > Neighbourhood.LARGEST_SUM
                ? Optional.empty()
                : Optional.of(new Neighbourhood(Math.max(1, radius), Neighbourhood.Anchor.NEAREST));
    }
}
