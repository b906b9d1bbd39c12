package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** Set of (u, v, w) that can occur within the intervals of a {@link VisibleRange}. */
public sealed interface Reach {

    record Everything() implements Reach {}

    /** One light and every direction to the viewer: w follows from u and v. */
    record OneLight(Direction light) implements Reach {}

    record Pairs(List<DirectionPair> pairs) implements Reach {
        public Pairs {
            pairs = List.copyOf(pairs);
        }
    }
}
