package sunbeam.precompute.method;

import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;

/** Where the Fourier tables of one surface come from: made now, or kept. */
@FunctionalInterface
public interface FourierTables {

    /** The table that a plan needs. */
    FourierTable of(Plan plan);
}
