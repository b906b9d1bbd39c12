package sunbeam.precompute.colourtable;

/** Colours of diffracted power at any (u, v, w), many at a time. Belongs to the thread that made it. */
@FunctionalInterface
public interface ColourSource extends AutoCloseable {

    /**
     * CIE X, Y, Z of power, 3 values a place, in the order of the places.
     *
     * @param places u, v, w of each place; w at most 0
     */
    float[] xyz(float[] places);

    @Override
    default void close() {}
}
