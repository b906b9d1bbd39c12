package sunbeam.precompute.method;

import java.util.Optional;
import sunbeam.precompute.colortable.LinearTrial;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.plan.Plan;

/** A plan whose tables are made tile by tile, as far as a picture's pixels look, and for pixels of any size. */
public interface LevelledPlan extends MethodPlan {

    /** The tables' steps and windows. */
    TableLevels levels();

    /** The plan for a surface whose orders stand alone (see {@link LinearTrial}). */
    LevelledPlan ofLoneOrders();

    /**
     * By what a level's colors are evaluated, for all (u, v, w).
     *
     * @param level its number in {@link #levels()}
     */
    MethodPlan source(int level);

    /** The plan of the bins by which all levels of an ensemble average are evaluated; empty for a coherent one. */
    Optional<Plan> spectrum();

    /** Relative error that evaluated colors may have. */
    double tolerance();
}
