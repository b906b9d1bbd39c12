package sunbeam.precompute.patch;

import sunbeam.precompute.units.LengthFormatException;
import sunbeam.precompute.units.Lengths;

/**
 * A length together with what the user calls it, so that a complaint can name it.
 *
 * @param name the option ("--width") or the descriptor's key ("elaphe.json, line 3: width")
 * @param metres the length
 */
record NamedLength(String name, double metres) {
    /** @throws PatchException when the text is no length with a unit */
    static NamedLength parse(String name, String text) {
        try {
            return new NamedLength(name, Lengths.parse(text));
        } catch (LengthFormatException e) {
            throw new PatchException(name + ": " + e.getMessage(), e);
        }
    }

    /**
     * Refuses lengths that are no such quantity: zero, negative, NaN, or far from it, most often by a slip in the unit.
     *
     * @throws PatchException when the length is not within [least, most] metres
     */
    void requireBetween(double least, double most) {
        if (!(metres > 0)) {
            throw new PatchException("%s is %s, but must be positive; give a length between %s and %s"
                    .formatted(name, Lengths.format(metres), Lengths.format(least), Lengths.format(most)));
        }
        if (!(metres >= least && metres <= most)) {
            throw new PatchException("%s is %s, which is absurd; give a length between %s and %s (is the unit right?)"
                    .formatted(name, Lengths.format(metres), Lengths.format(least), Lengths.format(most)));
        }
    }
}
