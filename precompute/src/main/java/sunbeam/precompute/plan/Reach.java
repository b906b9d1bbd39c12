package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** Which (u, v, w) of an interval can occur. */
public sealed interface Reach {

    record Everything() implements Reach {}

    /** Those of one light and every direction to the viewer: w follows from u and v. */
    record OneLight(Direction light) implements Reach {}

    record Pairs(List<DirectionPair> pairs) implements Reach {
        public Pairs {
            pairs = List.copyOf(pairs);
        }
    }
}
