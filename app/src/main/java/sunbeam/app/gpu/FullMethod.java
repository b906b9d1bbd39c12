package sunbeam.app.gpu;

import jrtr.RenderContext;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.table.FourierTable;

/** Method {@code full}, in the form that its plan's sampling asks for. */
public final class FullMethod {
    private FullMethod() {}

    /** Uploads what the use needs. */
    public static DiffractionMethod create(
            RenderContext context, Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        return plan.sampling() instanceof Sampling.Grid grid
                ? new GridMethod(context, plan, grid, table, use, cie)
                : new BinsMethod(context, plan, table, cie);
    }
}
