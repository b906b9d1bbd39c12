package sunbeam.precompute.plan;

/** What a plan keeps. */
public sealed interface Promise {

    /**
     * A relative error of power and colour that each part was chosen for.
     *
     * @param value relative error
     */
    record Tolerance(double value) implements Promise {}

    /** Nothing: the thesis's choices stand in for what is not fixed. */
    record Thesis() implements Promise {}
}
