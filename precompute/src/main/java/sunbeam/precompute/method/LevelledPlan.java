package sunbeam.precompute.method;

import sunbeam.precompute.colourtable.TableLevels;

/** A plan whose tables are made page by page, as far as a picture's pixels look, and for pixels of any size. */
public interface LevelledPlan extends MethodPlan {

    /** The tables' steps and windows. */
    TableLevels levels();

    /**
     * By what a level's colours are evaluated, for all (u, v, w).
     *
     * @param level its number in {@link #levels()}
     */
    MethodPlan source(int level);
}
